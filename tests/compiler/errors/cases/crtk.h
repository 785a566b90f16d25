#pragma once
#include <suture/annotate.h>
#include <suture/base/time.h>
#include <Eigen/Geometry>
#include <string>
#include <vector>
namespace demo {
struct SUTURE_TYPE() Pose {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  suture::Time stamp;
};
struct SUTURE_TYPE() Twist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
};
struct SUTURE_TYPE() Joints {
  SUTURE_FIELD(capacity(8)) std::vector<double> position;
};
struct SUTURE_TYPE() JointState {
  SUTURE_FIELD(capacity(8)) std::vector<double> position, velocity, effort;
};
enum class SUTURE_TYPE() State { Disabled, Enabled };
class SUTURE_INTERFACE(crtk()) Arm {
 public:
  // As CRTK has them.
  SUTURE_COMMAND() virtual const JointState& measured_js() const = 0;
  SUTURE_COMMAND() virtual Pose measured2_cp() const = 0;
  SUTURE_COMMAND() virtual Twist body_measured_cf() const = 0;
  SUTURE_COMMAND() virtual void servo_jp(const Joints& goal) = 0;
  SUTURE_COMMAND() virtual void move_cr(const Pose& step) = 0;
  SUTURE_COMMAND() virtual void state_command(SUTURE_FIELD(capacity(15)) const std::string& name) = 0;
  SUTURE_COMMAND() virtual void hold() = 0;
  SUTURE_EVENT() suture::EventOf<State> operating_state;
  // Not so.
  SUTURE_COMMAND() virtual Pose measured_cp() = 0;
  SUTURE_COMMAND() virtual Pose setpoint_cp(int frame) const = 0;
  SUTURE_COMMAND() virtual void servo_cp() = 0;
  SUTURE_COMMAND() virtual bool move_jp(const Joints& goal) const = 0;
  SUTURE_COMMAND() virtual Pose measured_cv() const = 0;
  SUTURE_COMMAND() virtual void servo_jv(const Twist& velocity) = 0;
  SUTURE_COMMAND() virtual const Joints& setpoint_js() const = 0;
  SUTURE_COMMAND() virtual void move_cv(const Twist& velocity) = 0;
  SUTURE_COMMAND() virtual void measure_jp(const Joints& joints) = 0;
  SUTURE_COMMAND() virtual void dance() = 0;
  SUTURE_EVENT() suture::EventOf<int> goal_reached;
  SUTURE_EVENT() suture::EventOf<> error;
};
}  // namespace demo
