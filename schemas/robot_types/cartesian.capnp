@0xeabef65b27ad6d43;
# The wire contract of robot_types/cartesian.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robot_types/cartesian.h");

enum ServoMode @0xeed5266eb5c2e892 $Meta.cxx("robots::ServoMode") $Meta.underlying("UInt8") {
  # Says what an axis of a mixed servo command follows.

  none @0 $Meta.cxx("None") $Meta.value(0);
  position @1 $Meta.cxx("Position") $Meta.value(1);
  velocity @2 $Meta.cxx("Velocity") $Meta.value(2);
  positionVelocity @3 $Meta.cxx("PositionVelocity") $Meta.value(3);
  effort @4 $Meta.cxx("Effort") $Meta.value(4);
  positionEffort @5 $Meta.cxx("PositionEffort") $Meta.value(5);
  velocityEffort @6 $Meta.cxx("VelocityEffort") $Meta.value(6);
  all @7 $Meta.cxx("All") $Meta.value(7);
}

struct Twist @0xaa62fba3aef11562 $Meta.cxx("robots::Twist") {
  # A Twist is a velocity, as CRTK's measured_cv says it. Corresponds to cisst's
  # prmVelocityCartesianGet.

  linear @0 :Types.Vec3 $Meta.unit("m/s");
  angular @1 :Types.Vec3 $Meta.unit("rad/s");
  movingFrame @2 :UInt32 $Meta.cxx("moving_frame");
  referenceFrame @3 :UInt32 $Meta.cxx("reference_frame");
  stamp @4 :Int64 $Meta.clock("steady");
  valid @5 :Bool;
  # If it is false, do not use it.
}

struct TwistGoal @0xb9f9a4ea2665be7e $Meta.cxx("robots::TwistGoal") {
  # A TwistGoal is a velocity to follow, by CRTK's servo_cv. Corresponds to cisst's
  # prmVelocityCartesianSet.

  linear @0 :Types.Vec3 $Meta.unit("m/s");
  angular @1 :Types.Vec3 $Meta.unit("rad/s");
  linearAcceleration @2 :Types.Vec3 $Meta.cxx("linear_acceleration") $Meta.unit("m/s2");
  angularAcceleration @3 :Types.Vec3 $Meta.cxx("angular_acceleration") $Meta.unit("rad/s2");
  mask @4 :List(Bool) $Meta.shape("6");
  # Says which of x, y, z and the rotations about them count.
  stamp @5 :Int64 $Meta.clock("steady");
}

struct Wrench @0xdefffdcf07aeb2d1 $Meta.cxx("robots::Wrench") {
  # A Wrench is force and torque at the tool tip, as CRTK's measured_cf says it. Corresponds to
  # cisst's prmForceCartesianGet.

  force @0 :Types.Vec3 $Meta.unit("N");
  torque @1 :Types.Vec3 $Meta.unit("N.m");
  mask @2 :List(Bool) $Meta.shape("6");
  # Says which components are known.
  movingFrame @3 :UInt32 $Meta.cxx("moving_frame");
  referenceFrame @4 :UInt32 $Meta.cxx("reference_frame");
  stamp @5 :Int64 $Meta.clock("steady");
  valid @6 :Bool;
  # If it is false, do not use it.
}

struct WrenchGoal @0x913714b88c44b8c4 $Meta.cxx("robots::WrenchGoal") {
  # A WrenchGoal is force and torque to apply, by CRTK's servo_cf. Corresponds to cisst's
  # prmForceCartesianSet.

  force @0 :Types.Vec3 $Meta.unit("N");
  torque @1 :Types.Vec3 $Meta.unit("N.m");
  mask @2 :List(Bool) $Meta.shape("6");
  # Says which components count.
  stamp @3 :Int64 $Meta.clock("steady");
}

struct CartesianState @0xe8c20fc8c27161a7 $Meta.cxx("robots::CartesianState") {
  # A CartesianState is pose, velocity and force of one instant, as CRTK's measured_cs says it.
  # Corresponds to cisst's prmStateCartesian.

  movingFrame @0 :UInt32 $Meta.cxx("moving_frame");
  referenceFrame @1 :UInt32 $Meta.cxx("reference_frame");
  position @2 :Types.Pose $Meta.unit("m");
  positionIsValid @3 :Bool $Meta.cxx("position_is_valid");
  linearVelocity @4 :Types.Vec3 $Meta.cxx("linear_velocity") $Meta.unit("m/s");
  angularVelocity @5 :Types.Vec3 $Meta.cxx("angular_velocity") $Meta.unit("rad/s");
  velocityIsValid @6 :Bool $Meta.cxx("velocity_is_valid");
  force @7 :Types.Vec3 $Meta.unit("N");
  torque @8 :Types.Vec3 $Meta.unit("N.m");
  forceIsValid @9 :Bool $Meta.cxx("force_is_valid");
  stamp @10 :Int64 $Meta.clock("steady");
}

struct CartesianGoal @0xe4d650549dee47fd $Meta.cxx("robots::CartesianGoal") {
  # A CartesianGoal is a pose to reach, and how to get there. Corresponds to cisst's
  # prmPositionCartesianSet.

  goal @0 :Types.Pose $Meta.unit("m");
  linearVelocity @1 :Types.Vec3 $Meta.cxx("linear_velocity") $Meta.unit("m/s");
  angularVelocity @2 :Types.Vec3 $Meta.cxx("angular_velocity") $Meta.unit("rad/s");
  linearAcceleration @3 :Types.Vec3 $Meta.cxx("linear_acceleration") $Meta.unit("m/s2");
  angularAcceleration @4 :Types.Vec3 $Meta.cxx("angular_acceleration") $Meta.unit("rad/s2");
  mask @5 :List(Bool) $Meta.shape("2");
  # Says if position and orientation count.
  movingFrame @6 :UInt32 $Meta.cxx("moving_frame");
  referenceFrame @7 :UInt32 $Meta.cxx("reference_frame");
  stamp @8 :Int64 $Meta.clock("steady");
  valid @9 :Bool;
}

struct ServoCartesian @0x90f303a4951092d4 $Meta.cxx("robots::ServoCartesian") {
  # A ServoCartesian has position, velocity and effort in one servo command. Corresponds to cisst's
  # prmServoCartesian.

  taskFrame @0 :Types.Pose $Meta.cxx("task_frame") $Meta.unit("m");
  # The values below are along the axes of this frame, which is given in the base frame.
  position @1 :Types.Pose $Meta.unit("m");
  linearVelocity @2 :Types.Vec3 $Meta.cxx("linear_velocity") $Meta.unit("m/s");
  angularVelocity @3 :Types.Vec3 $Meta.cxx("angular_velocity") $Meta.unit("rad/s");
  force @4 :Types.Vec3 $Meta.unit("N");
  torque @5 :Types.Vec3 $Meta.unit("N.m");
  axisMode @6 :List(ServoMode) $Meta.cxx("axis_mode") $Meta.shape("6");
  # The modes are those of x, y, z and the rotations about them, in this order.
  stamp @7 :Int64 $Meta.clock("steady");
}

struct HalfPlaneGains @0xf5adf6b47f45412f $Meta.cxx("robots::HalfPlaneGains") {
  # Says how stiffly one side of an axis holds: force = p * distance + d * speed + bias beyond the
  # deadband.

  p @0 :Types.Vec3 $Meta.unit("N/m");
  d @1 :Types.Vec3 $Meta.unit("N.s/m");
  bias @2 :Types.Vec3 $Meta.unit("N");
  deadband @3 :Types.Vec3 $Meta.unit("m");
}

struct AngularHalfPlaneGains @0xb5891631aa394628 $Meta.cxx("robots::AngularHalfPlaneGains") {
  # These gains hold about an axis in the same way.

  p @0 :Types.Vec3 $Meta.unit("N.m/rad");
  d @1 :Types.Vec3 $Meta.unit("N.m.s/rad");
  bias @2 :Types.Vec3 $Meta.unit("N.m");
  deadband @3 :Types.Vec3 $Meta.unit("rad");
}

struct CartesianImpedance @0xa1baf72e8978a5b3 $Meta.cxx("robots::CartesianImpedance") {
  # A CartesianImpedance is a spring that holds the tool tip, per axis and side. Corresponds to
  # cisst's prmCartesianImpedance.

  forceOrientation @0 :Types.Mat3 $Meta.cxx("force_orientation");
  # Holds the axes along which the forces act.
  forcePosition @1 :Types.Vec3 $Meta.cxx("force_position") $Meta.unit("m");
  # The springs rest here.
  torqueOrientation @2 :Types.Mat3 $Meta.cxx("torque_orientation");
  # Holds the axes about which the torques act.
  positionPositive @3 :HalfPlaneGains $Meta.cxx("position_positive");
  positionNegative @4 :HalfPlaneGains $Meta.cxx("position_negative");
  orientationPositive @5 :AngularHalfPlaneGains $Meta.cxx("orientation_positive");
  orientationNegative @6 :AngularHalfPlaneGains $Meta.cxx("orientation_negative");
  stamp @7 :Int64 $Meta.clock("steady");
}
