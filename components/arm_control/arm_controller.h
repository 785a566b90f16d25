#pragma once
// This is what the arms share: the operating state and the set-point of a kinematic chain over its
// drives.

#include <suture/base/time.h>
#include <suture/component/channel/connected_client.h>

#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include "arm/arm_warning.h"
#include "arm_control/drive_reading.h"
#include "arm_control/drive_watch.h"
#include "arm_control/motion/joint_line.h"
#include "arm_control/motion/joint_move.h"
#include "arm_control/motion/setpoint_rate.h"
#include "arm_control/operating_states.h"
#include "arm_control/warnings.h"
#include "dynamics/arm_dynamics.h"
#include "kinematics/inverse.h"
#include "robot_types/joints.h"
#include "robot_types/operating_state.h"
#include "robot_types/pose.h"
#include "timing/stream_watch.h"

namespace robots {

/// Cartesian control is refused until the frame behind so many joints has been `least` + `buffer`
/// from the base's origin, and once it is nearer than `least` again.
struct InsertionRule {
  int joints;
  double least, buffer;  ///< m
};

/// How one arm is built and what it may do. Joint vectors in rad, or m for a prismatic joint.
template <int N>
struct ArmModel {
  using Joints = Eigen::Matrix<double, N, 1>;

  kinematics::Chain<N> chain;
  std::array<const char*, std::size_t{N}> joint_names;
  Joints home;        ///< where home() takes it
  Joints rate_limit;  ///< rad/s or m/s
  /// Moves speed up and slow down no faster; rad/s2 or m/s2.
  Joints acceleration_limit = Joints::Constant(std::numeric_limits<double>::infinity());
  /// A joint that trails its set-point by more faults the arm.
  Joints following_error = Joints::Constant(std::numeric_limits<double>::infinity());
  /// What the drives may measure of the joints; the rates are those above.
  Joints effort_limit = Joints::Constant(std::numeric_limits<double>::infinity());  ///< N.m or N
  Joints encoder_step = Joints::Zero();  ///< rad or m: what one count is of the joint
  DriveBounds tool = {};
  DriveWatchOptions watch = {};
  /// It tells the efforts that carry the arm's weight, if that is known.
  std::optional<dynamics::ArmDynamics<N>> weight = {};
  std::optional<InsertionRule> insertion = {};
  /// s: a servo goal may lie so far from the set-point as the joints can move in this time.
  double servo_horizon = 0.1;
  /// The arm's own closed form, if it has one.
  kinematics::InverseFunction<N> inverse = kinematics::searched<N>;

  auto solve(const Eigen::Isometry3d& goal, const Joints& start,
             kinematics::Postures postures) const {
    return inverse(chain, goal, start, postures);
  }
};

template <int N>
class CrtkArm;

/// Turns the commands of an arm into set-points of its joints, and what its drives measure into the
/// arm's state. Poses are of the tool tip in the arm's base frame. Confined to one thread; only the
/// constructor allocates.
template <int N>
class ArmController {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// Undefined, until step() has a reading of drives that may have power: now and after
  /// startAnew().
  explicit ArmController(const ArmModel<N>& model);
  ArmController(const ArmController&) = delete;
  ArmController& operator=(const ArmController&) = delete;
  virtual ~ArmController() = default;

  /// Does what after() says, or refuses.
  void obey(StateCommand command);
  void hold();
  void servo_cp(const PoseStamped& goal);
  void servo_jp(const JointGoal& goal);
  void interpolate_cp(const PoseStamped& goal);
  void interpolate_jp(const JointGoal& goal);
  void move_jp(const JointGoal& goal);

  const JointState& measured_js() const { return measuredJs_; }
  const JointState& setpoint_js() const { return setpointJs_; }
  const PoseStamped& measured_cp() const { return measuredCp_; }
  const PoseStamped& setpoint_cp() const { return setpointCp_; }
  const OperatingState& operating_state() const { return state_; }
  PoseStamped forward_kinematics(const JointGoal& q) const;
  JointSolution inverse_kinematics(const PoseStamped& goal) const;

  /// `client` is gone: if the arm follows a stream of its goals, that ends as hold(), and the arm
  /// says so. A move goes on to its end.
  void clientGone(const suture::ConnectedClient& client);

  void startAnew();

  /// One cycle at time `now`, after the commands that arrived for it. None: the drives are silent.
  void step(suture::Time now, const std::optional<DriveReading<N>>& drives);

  /// From this cycle on the drives shall hold power if this is true, and follow the set-point. An
  /// arm in FAULT has none: to hold it would close a loop over what it has just found wrong.
  bool powered() const {
    return state_.state == ArmState::Enabled || state_.state == ArmState::Paused;
  }
  const Joints& setpoint() const { return setpoint_; }

  /// The client whose command is being executed; null if it cannot be gone before the arm is.
  virtual const suture::ConnectedClient* asking() const { return nullptr; }

 private:
  friend class CrtkArm<N>;  // the contract of the same arm

  void refuse(StateCommand command);
  void unhome();
  /// Changes to `state`, in which the arm rests where its joints are.
  void restIn(ArmState state, const char* activity);
  /// Takes what the drives measured, and goes where they lead: they stop, or fall silent.
  void take(const std::optional<DriveReading<N>>& drives);
  void obeyPower();
  void obeyInsertion();
  /// The joint that trails its set-point by too much, if one does.
  std::optional<int> trailing() const;
  void obey(const DriveFault& fault);
  void tell(const DriveFault& fault);
  void fail(const DriveFault& fault, const char* activity);
  bool mayMove();
  /// The same of Cartesian commands.
  bool mayMoveTip();
  void warn(ArmWarning reason) { warnings_.warn(reason); }
  std::nullopt_t refused(ArmWarning reason) {
    warn(reason);
    return std::nullopt;
  }
  void enter(ArmState state, const char* activity);
  void goOnAfterPause();
  void startMove(const Joints& goal, bool homing);
  void endMove(bool reached);
  void follow(const Joints& setpoint, suture::Time goalStamp, const char* activity);
  /// The same for what a client streams.
  void followStream(const Joints& setpoint, suture::Time goalStamp, const char* activity);
  /// A set-point that a servo goal leads to.
  struct ServoTarget {
    Joints q;
    bool limited;  ///< the goal itself lies beyond a joint limit
  };
  ServoTarget withinLimits(const Joints& q) const;
  /// None, and the arm has said so, if it may not move or the goal leads nowhere.
  std::optional<ServoTarget> target(const PoseStamped& goal);
  std::optional<ServoTarget> target(const JointGoal& goal);
  /// The same for a goal of a position, unless it is too far for one step.
  void servo(const ServoTarget& target, suture::Time goalStamp, const char* activity);
  /// The same for a goal to be at when the next one comes.
  void interpolate(const ServoTarget& target, suture::Time goalStamp, const char* activity);
  /// Where the set-point will be, unless another command comes.
  Joints interpolated() const { return line_ ? line_->to() : setpoint_; }
  /// Says it when the arm begins to slide along a limit.
  void slide(bool limited, bool slid);
  /// What has happened has been told.
  void forgetNews();
  void publish(suture::Time now);

  const ArmModel<N> model_;
  DriveWatch<N> watch_;
  DriveReading<N> reading_;  // what the drives measured last
  bool inserted_;            // far enough for Cartesian control
  bool heard_ = false;       // in this cycle there is a reading
  suture::Time permitted_;   // by which permit of power the arm was enabled
  suture::Time lastStep_;
  Joints setpoint_;
  SetpointRate<N> setpointRate_;
  suture::Time setpointStamp_;  // of the streamed goal it came from; unset otherwise
  std::optional<JointMove<N>> move_;
  suture::Time moveStart_;            // the cycle that its first set-point is of
  std::optional<Joints> begun_;       // the goal of a move that has begun since the last step
  std::optional<JointLine<N>> line_;  // to the last goal that is interpolated
  bool homing_ = false;
  StreamWatch servoing_;                               // whatever else the arm does ends it
  const suture::ConnectedClient* streamer_ = nullptr;  // whose stream is followed
  bool sliding_ = false;                               // along a joint limit
  MoveRatios moveRatios_;

  JointState measuredJs_, setpointJs_;
  PoseStamped measuredCp_, setpointCp_;
  OperatingState state_;

  bool stateChanged_ = true;
  std::optional<bool> moveEnded_;
  std::optional<ArmState> desired_;  // what a command asked for, until it is told
  Warnings warnings_;
  std::string_view refusal_;  // why the last state command was refused
  std::string_view culprit_;  // the joint that has put it in FAULT
};

extern template class ArmController<6>;
extern template class ArmController<7>;

}  // namespace robots
