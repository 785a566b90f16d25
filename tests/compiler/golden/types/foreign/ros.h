#pragma once
// Messages of ROS, none of their lines edited. Debian's ask their allocator for rebind, which C++20
// took from std::allocator; their templates are content with one that has it.

#include <geometry_msgs/PoseStamped.h>
#include <sensor_msgs/JointState.h>
#include <suture/annotate.h>

#include <memory>

namespace foreign {

struct Rebind {
  template <class T>
  struct rebind {
    using other = std::allocator<T>;
  };
};

using Header = std_msgs::Header_<Rebind>;
using Point = geometry_msgs::Point_<Rebind>;
using Quaternion = geometry_msgs::Quaternion_<Rebind>;
using Pose = geometry_msgs::Pose_<Rebind>;
using PoseStamped = geometry_msgs::PoseStamped_<Rebind>;
using JointState = sensor_msgs::JointState_<Rebind>;

SUTURE_EXTERNAL_TYPE(ros::Time, sec, nsec);
SUTURE_EXTERNAL_TYPE(Header, seq, stamp, member(frame_id, capacity(16)));
SUTURE_EXTERNAL_TYPE(Point, member(x, unit("m")), member(y, unit("m")), member(z, unit("m")));
SUTURE_EXTERNAL_TYPE(Quaternion, x, y, z, w);
SUTURE_EXTERNAL_TYPE(Pose, position, orientation);
SUTURE_EXTERNAL_TYPE(PoseStamped, header, pose);
SUTURE_EXTERNAL_TYPE(JointState, header, member(name, capacity(4, 12)),
                     member(position, capacity(4), unit("rad")), member(velocity, capacity(4)),
                     member(effort, capacity(4)));

}  // namespace foreign
