// These are ROS 2's messages: templates with an allocator, and constructors that nothing calls by
// itself.

#include "values/ros2.h"
#include "connected.h"
#include "labs/ros2.capnp.h"
#include "labs/ros2.suture.h"

namespace lab {

void toWire(const geometry_msgsmsgPoseStampedSlot&, wire::PoseStamped::Builder);
suture::Errc fromWire(wire::PoseStamped::Reader, geometry_msgsmsgPoseStampedSlot&,
                      suture::Duration);
bool isValid(const geometry_msgsmsgPoseStampedSlot&, suture::FieldPath* = nullptr);
void toWire(const geometry_msgsmsgPoseWithCovarianceSlot&, wire::PoseWithCovariance::Builder);
suture::Errc fromWire(wire::PoseWithCovariance::Reader, geometry_msgsmsgPoseWithCovarianceSlot&,
                      suture::Duration);
bool isValid(const geometry_msgsmsgPoseWithCovarianceSlot&, suture::FieldPath* = nullptr);
void toWire(const sensor_msgsmsgJointStateSlot&, wire::JointState::Builder);
suture::Errc fromWire(wire::JointState::Reader, sensor_msgsmsgJointStateSlot&, suture::Duration);
bool isValid(const sensor_msgsmsgJointStateSlot&, suture::FieldPath* = nullptr);
void toWire(const sensor_msgsmsgImageSlot&, wire::Image::Builder);
suture::Errc fromWire(wire::Image::Reader, sensor_msgsmsgImageSlot&, suture::Duration);
bool isValid(const sensor_msgsmsgImageSlot&, suture::FieldPath* = nullptr);
void toWire(const sensor_msgsmsgBatteryStateSlot&, wire::BatteryState::Builder);
suture::Errc fromWire(wire::BatteryState::Reader, sensor_msgsmsgBatteryStateSlot&,
                      suture::Duration);
bool isValid(const sensor_msgsmsgBatteryStateSlot&, suture::FieldPath* = nullptr);
void toWire(const trajectory_msgsmsgJointTrajectorySlot&, wire::JointTrajectory::Builder);
suture::Errc fromWire(wire::JointTrajectory::Reader, trajectory_msgsmsgJointTrajectorySlot&,
                      suture::Duration);
bool isValid(const trajectory_msgsmsgJointTrajectorySlot&, suture::FieldPath* = nullptr);
void toWire(const shape_msgsmsgSolidPrimitiveSlot&, wire::SolidPrimitive::Builder);
suture::Errc fromWire(wire::SolidPrimitive::Reader, shape_msgsmsgSolidPrimitiveSlot&,
                      suture::Duration);
bool isValid(const shape_msgsmsgSolidPrimitiveSlot&, suture::FieldPath* = nullptr);

}  // namespace lab

namespace invented {

class RosProvider final : public suture::EventTask, public lab::RosArm {
 public:
  void follow(const JointTrajectory& path) override {
    state_.header = path.header;
    state_.name = path.joint_names;
    SolidPrimitive ball;
    ball.type = SolidPrimitive::SPHERE;
    ball.dimensions.push_back(0.5);
    require(port_.emit().grasped(ball, path.header.stamp).has_value(), "grasped", "is not emitted");
  }
  void move(const PoseStamped& goal) override { pose_.pose = goal.pose; }
  const JointState& state() const override { return state_; }
  const PoseWithCovariance& pose() const override { return pose_; }
  const BatteryState& battery() const override { return battery_; }
  void run() override {}

 private:
  JointState state_;
  PoseWithCovariance pose_;
  BatteryState battery_;
  suture::Provided<lab::RosArm> port_{*this, "Port", *this};
};

void connectRos2(Random& random) {
  SolidPrimitive heard;
  Connected<lab::RosArm, RosProvider> arm([&](auto& port) {
    port.on().grasped(
        [&](const SolidPrimitive& solid, const builtin_interfaces::msg::Time&) { heard = solid; });
  });
  JointTrajectory path;
  fill(path, random);
  require(arm.port().follow(path).has_value(), "follow", "is not sent");
  arm.until([&] { return heard.type == SolidPrimitive::SPHERE; }, "grasped");
  require(heard.dimensions.size() == 1 && heard.dimensions[0] == 0.5, "grasped", "differs");
  const auto state = arm.port().state.fresh().within(10s);
  require(state && same(state->header, path.header) && state->name == path.joint_names, "state",
          "is another one");
}

void checkRos2(Random& random) {
  checkType<PoseStamped, lab::geometry_msgsmsgPoseStampedSlot, lab::wire::PoseStamped>(
      "PoseStamped", random);
  checkType<PoseWithCovariance, lab::geometry_msgsmsgPoseWithCovarianceSlot,
            lab::wire::PoseWithCovariance>("PoseWithCovariance", random);
  checkType<JointState, lab::sensor_msgsmsgJointStateSlot, lab::wire::JointState>("JointState",
                                                                                  random);
  checkType<Image, lab::sensor_msgsmsgImageSlot, lab::wire::Image>("Image", random);
  checkType<BatteryState, lab::sensor_msgsmsgBatteryStateSlot, lab::wire::BatteryState>(
      "BatteryState", random);
  checkType<JointTrajectory, lab::trajectory_msgsmsgJointTrajectorySlot,
            lab::wire::JointTrajectory>("JointTrajectory", random);
  checkType<SolidPrimitive, lab::shape_msgsmsgSolidPrimitiveSlot, lab::wire::SolidPrimitive>(
      "SolidPrimitive", random);

  JointTrajectory path;
  path.points.resize(5);
  path.points[4].accelerations = {0, kNaN};
  checkRefused<lab::trajectory_msgsmsgJointTrajectorySlot>(path, "points[4].accelerations[1]");
  SolidPrimitive cylinder;
  cylinder.dimensions.push_back(kNaN);
  checkRefused<lab::shape_msgsmsgSolidPrimitiveSlot>(cylinder, "dimensions[0]");
  connectRos2(random);
}

}  // namespace invented
