#pragma once
// These are ROS 2's messages: templates with an allocator, and constructors that nothing calls by
// itself.

#include "labs/ros2.h"
#include "members.h"

namespace invented {

using namespace builtin_interfaces::msg;
using namespace geometry_msgs::msg;
using namespace sensor_msgs::msg;
using namespace trajectory_msgs::msg;
using shape_msgs::msg::SolidPrimitive;

inline void fill(rosidl_runtime_cpp::BoundedVector<double, 3>& value, Random& random,
                 Bounds& bounds) {
  std::vector<double> shown;
  fill(shown, random, bounds);
  value = suture::Wire<rosidl_runtime_cpp::BoundedVector<double, 3>>::from(shown);
}
inline bool equal(const rosidl_runtime_cpp::BoundedVector<double, 3>& a,
                  const rosidl_runtime_cpp::BoundedVector<double, 3>& b, Tag tag) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [tag](double x, double y) { return equal(x, y, tag); });
}

auto fields(As<builtin_interfaces::msg::Time> auto& v, Tag) { return list(v.sec, v.nanosec); }
auto fields(As<builtin_interfaces::msg::Duration> auto& v, Tag) { return list(v.sec, v.nanosec); }
auto fields(As<std_msgs::msg::Header> auto& v, Tag) {
  return list(v.stamp, bounded(v.frame_id, 16));
}
auto fields(As<Point> auto& v, Tag) { return list(v.x, v.y, v.z); }
auto fields(As<Quaternion> auto& v, Tag) { return list(v.x, v.y, v.z, v.w); }
auto fields(As<Pose> auto& v, Tag) { return list(v.position, v.orientation); }
auto fields(As<PoseStamped> auto& v, Tag) { return list(v.header, v.pose); }
auto fields(As<PoseWithCovariance> auto& v, Tag) { return list(v.pose, v.covariance); }
auto fields(As<JointState> auto& v, Tag) {
  return list(v.header, bounded(v.name, 7, 12), bounded(v.position, 7), bounded(v.velocity, 7),
              bounded(v.effort, 7));
}
auto fields(As<Image> auto& v, Tag) {
  return list(v.header, v.height, v.width, bounded(v.encoding, 8), v.is_bigendian, v.step,
              bounded(v.data, 1024));
}
auto fields(As<BatteryState> auto& v, Tag) {
  return list(v.header, v.voltage, v.power_supply_status, v.present, bounded(v.cell_voltage, 6),
              bounded(v.location, 8));
}
auto fields(As<JointTrajectoryPoint> auto& v, Tag) {
  return list(bounded(v.positions, 7), bounded(v.velocities, 7), bounded(v.accelerations, 7),
              bounded(v.effort, 7), v.time_from_start);
}
auto fields(As<JointTrajectory> auto& v, Tag) {
  return list(v.header, bounded(v.joint_names, 7, 12), bounded(v.points, 5));
}
auto fields(As<SolidPrimitive> auto& v, Tag) { return list(v.type, bounded(v.dimensions, 3)); }

}  // namespace invented
