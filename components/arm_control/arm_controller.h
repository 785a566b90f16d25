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
#include "arm_control/motion/arm_motion.h"
#include "arm_control/motion/setpoint.h"
#include "arm_control/operating_states.h"
#include "arm_control/warnings.h"
#include "dynamics/arm_dynamics.h"
#include "kinematics/inverse.h"
#include "robot_types/joints.h"
#include "robot_types/operating_state.h"
#include "robot_types/pose.h"
#include "timing/stream_watch.h"

namespace robots {

/// Says when an arm refuses Cartesian control: until the frame behind the first `joints` joints has
/// been `least` + `buffer` from the base's origin, and again once it is nearer than `least`.
struct InsertionRule {
  int joints;
  double least, buffer;  ///< m
};

/// Says how one arm is built and what it may do. Joint vectors are in rad, or m for a prismatic
/// joint.
template <int N>
struct ArmModel {
  using Joints = Eigen::Matrix<double, N, 1>;

  kinematics::Chain<N> chain;
  std::array<const char*, std::size_t{N}> joint_names;
  Joints home;        ///< where home() takes it
  Joints rate_limit;  ///< rad/s or m/s
  /// Bounds how fast moves speed up and slow down; rad/s2 or m/s2.
  Joints acceleration_limit = Joints::Constant(std::numeric_limits<double>::infinity());
  /// A joint that trails its set-point by more than this faults the arm.
  Joints following_error = Joints::Constant(std::numeric_limits<double>::infinity());
  /// These and the rates above bound what the drives may measure of the joints.
  Joints effort_limit = Joints::Constant(std::numeric_limits<double>::infinity());  ///< N.m or N
  Joints encoder_step = Joints::Zero();  ///< rad or m: how far the joint moves in one count
  DriveBounds tool = {};
  DriveWatchOptions watch = {};
  /// Computes the efforts that carry the arm's weight, if that is known.
  std::optional<dynamics::ArmDynamics<N>> weight = {};
  std::optional<InsertionRule> insertion = {};
  /// A servo goal may lie as far from the set-point as the joints can move in this time, in s.
  double servo_horizon = 0.1;
  /// The arm's own closed form stands here, if it has one.
  kinematics::InverseFunction<N> inverse = kinematics::searched<N>;

  auto solve(const Eigen::Isometry3d& goal, const Joints& start,
             kinematics::Postures postures) const {
    return inverse(chain, goal, start, postures);
  }
};

template <int N>
class CrtkArm;

/// One thread. Turns the commands of an arm into set-points of its joints, and what its drives
/// measure into the arm's state. Poses are of the tool tip in the arm's base frame. Only the
/// constructor allocates.
template <int N>
class ArmController {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// The arm is undefined until step() has a reading of drives that may have power, now and after
  /// startAnew().
  explicit ArmController(const ArmModel<N>& model);
  ArmController(const ArmController&) = delete;
  ArmController& operator=(const ArmController&) = delete;
  virtual ~ArmController() = default;

  /// Does what after() says (operating_states.h), or refuses.
  void obey(StateCommand command);
  void hold();
  void servo_cp(const PoseStamped& goal);
  void servo_jp(const JointGoal& goal);
  void interpolate_cp(const PoseStamped& goal);
  void interpolate_jp(const JointGoal& goal);
  void move_jp(const JointGoal& goal);

  const ArmMotion<N>& motion() const { return motion_; }
  const OperatingState& operating_state() const { return state_; }
  PoseStamped forward_kinematics(const JointGoal& q) const;
  JointSolution inverse_kinematics(const PoseStamped& goal) const;

  /// Says that `client` is gone: if the arm follows a stream of its goals, the stream ends as with
  /// hold(), and the arm reports it. A move goes on to its end.
  void clientGone(const suture::ConnectedClient& client);

  void startAnew();

  /// Executes one cycle at time `now`, after the commands that arrived for it. `drives` is none if
  /// the drives are silent.
  void step(suture::Time now, const std::optional<DriveReading<N>>& drives);

  /// Returns true if the drives shall have power from this cycle on, and follow the set-point. An
  /// arm in FAULT has none, because holding it would close a loop over what it has just found
  /// wrong.
  bool powered() const {
    return state_.state == ArmState::Enabled || state_.state == ArmState::Paused;
  }
  const Joints& setpoint() const { return setpoint_.joints(); }

  /// Returns the client whose command is being executed; null if it cannot be gone before the arm
  /// is.
  virtual const suture::ConnectedClient* asking() const { return nullptr; }

 private:
  friend class CrtkArm<N>;  // the contract of the same arm

  void refuse(StateCommand command);
  void unhome();
  /// Changes to `state`, in which the arm rests where its joints are.
  void restIn(ArmState state, const char* activity);
  /// Takes what the drives measured, and changes the state of the arm if they stop or fall silent.
  void take(const std::optional<DriveReading<N>>& drives, suture::Time now);
  void obeyPower();
  void obeyInsertion();
  /// Returns the joint that trails its set-point by too much, if one does.
  std::optional<int> trailing() const;
  void obey(const DriveFault& fault);
  void tell(const DriveFault& fault);
  void fail(const DriveFault& fault, const char* activity);
  bool mayMove();
  /// Does the same for Cartesian commands.
  bool mayMoveTip();
  void warn(ArmWarning reason) { warnings_.warn(reason); }
  std::nullopt_t refused(ArmWarning reason) {
    warn(reason);
    return std::nullopt;
  }
  void enter(ArmState state, const char* activity);
  void goOnFrom(bool paused);
  void startMove(const Joints& goal, bool homing);
  void endMove(bool reached);
  void follow(const Joints& setpoint, suture::Time goalStamp, const char* activity);
  /// Does the same for a set-point that a client streams.
  void followStream(const Joints& setpoint, suture::Time goalStamp, const char* activity);
  /// A ServoTarget is a set-point that a servo goal leads to.
  struct ServoTarget {
    Joints q;
    bool limited;  ///< the goal itself lies beyond a joint limit
  };
  ServoTarget withinLimits(const Joints& q) const;
  /// Returns none, and warns, if the arm may not move or the goal leads nowhere.
  std::optional<ServoTarget> target(const PoseStamped& goal);
  std::optional<ServoTarget> target(const JointGoal& goal);
  /// Follows the goal of a servo command of positions, unless it is too far for one step.
  void servo(const ServoTarget& target, suture::Time goalStamp, const char* activity);
  /// Follows a goal that the set-point shall reach when the next one comes.
  void interpolate(const ServoTarget& target, suture::Time goalStamp, const char* activity);
  /// Warns when the arm begins to slide along a limit.
  void slide(bool limited, bool slid);
  /// Forgets what has happened, once it has been reported.
  void forgetNews();
  void publish(suture::Time now);

  const ArmModel<N> model_;
  DriveWatch<N> watch_;
  DriveReading<N> reading_;  // what the drives measured last
  bool inserted_;            // far enough for Cartesian control
  bool heard_ = false;       // in this cycle there is a reading
  suture::Time permitted_;   // the permit of power under which the arm was enabled
  suture::Time lastStep_;
  Setpoint<N> setpoint_;
  suture::Time setpointStamp_;  // the streamed goal's that it came from; unset otherwise
  bool homing_ = false;
  StreamWatch servoing_;                               // any other activity of the arm ends it
  const suture::ConnectedClient* streamer_ = nullptr;  // whose stream is followed
  bool sliding_ = false;                               // along a joint limit

  ArmMotion<N> motion_;
  OperatingState state_;

  bool stateChanged_ = true;
  std::optional<bool> moveEnded_;
  std::optional<ArmState> desired_;  // what a command asked for, until it is reported
  Warnings warnings_;
  std::string_view refusal_;      // why the last state command was refused
  std::string_view faultyJoint_;  // the joint that has put the arm in FAULT
};

extern template class ArmController<6>;
extern template class ArmController<7>;

}  // namespace robots
