#pragma once
// These are messages of ROS 2. Its own aliases name the instances of its templates.

#include <suture/annotate.h>

#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/pose_with_covariance.hpp>
#include <sensor_msgs/msg/battery_state.hpp>
#include <sensor_msgs/msg/image.hpp>
#include <sensor_msgs/msg/joint_state.hpp>
#include <shape_msgs/msg/solid_primitive.hpp>
#include <trajectory_msgs/msg/joint_trajectory.hpp>

#include <cstddef>
#include <vector>

/// What ROS 2 bounds itself hides its vector.
template <class T, std::size_t Bound>
struct suture::Wire<rosidl_runtime_cpp::BoundedVector<T, Bound>> {
  using Hidden = rosidl_runtime_cpp::BoundedVector<T, Bound>;
  using Type = std::vector<T>;
  static Type to(const Hidden& hidden) { return Type(hidden.begin(), hidden.end()); }
  static Hidden from(const Type& shown) { return Hidden(shown.begin(), shown.end()); }
};

SUTURE_EXTERNAL_TYPE(builtin_interfaces::msg::Time);
SUTURE_EXTERNAL_TYPE(builtin_interfaces::msg::Duration);
SUTURE_EXTERNAL_TYPE(std_msgs::msg::Header, all(), member(frame_id, capacity(16)));
SUTURE_EXTERNAL_TYPE(geometry_msgs::msg::Point, all(), member(x, unit("m")), member(y, unit("m")),
                     member(z, unit("m")));
SUTURE_EXTERNAL_TYPE(geometry_msgs::msg::Quaternion);
SUTURE_EXTERNAL_TYPE(geometry_msgs::msg::Pose);
SUTURE_EXTERNAL_TYPE(geometry_msgs::msg::PoseStamped);
SUTURE_EXTERNAL_TYPE(geometry_msgs::msg::PoseWithCovariance);

namespace sensor_msgs::msg {
SUTURE_EXTERNAL_TYPE(JointState, all(), member(name, capacity(7, 12)),
                     member(position, capacity(7), unit("rad")), member(velocity, capacity(7)),
                     member(effort, capacity(7)));
SUTURE_EXTERNAL_TYPE(Image, all(), member(encoding, capacity(8)), member(data, capacity(1024)));
SUTURE_EXTERNAL_TYPE(BatteryState, all(), member(cell_voltage, capacity(6), unit("V")),
                     member(location, capacity(8)));
}  // namespace sensor_msgs::msg

namespace trajectory_msgs::msg {
SUTURE_EXTERNAL_TYPE(JointTrajectoryPoint, all(), member(positions, capacity(7)),
                     member(velocities, capacity(7)), member(accelerations, capacity(7)),
                     member(effort, capacity(7)));
SUTURE_EXTERNAL_TYPE(JointTrajectory, all(), member(joint_names, capacity(7, 12)),
                     member(points, capacity(5)));
}  // namespace trajectory_msgs::msg

SUTURE_EXTERNAL_TYPE(shape_msgs::msg::SolidPrimitive, all(), member(dimensions, capacity(3)));

namespace lab {

/// An arm of ROS 2, and what its camera sees.
class SUTURE_INTERFACE() RosArm {
 public:
  virtual ~RosArm() = default;
  SUTURE_COMMAND() virtual void follow(const trajectory_msgs::msg::JointTrajectory& path) = 0;
  SUTURE_COMMAND(latest()) virtual void move(const geometry_msgs::msg::PoseStamped& goal) = 0;
  SUTURE_COMMAND() virtual const sensor_msgs::msg::JointState& state() const = 0;
  SUTURE_COMMAND() virtual const geometry_msgs::msg::PoseWithCovariance& pose() const = 0;
  SUTURE_COMMAND() virtual const sensor_msgs::msg::BatteryState& battery() const = 0;
  SUTURE_EVENT(queue(2)) suture::EventOf<sensor_msgs::msg::Image> seen;
  SUTURE_EVENT(queue(4))
  suture::EventOf<shape_msgs::msg::SolidPrimitive, builtin_interfaces::msg::Time> grasped;
};

}  // namespace lab
