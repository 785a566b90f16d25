#pragma once
// This is what the arms share: the Arm contract over a kinematic chain and its drives.

#include <suture/base/time.h>
#include <suture/component/connected_client.h>

#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include "arm/arm.h"
#include "arm/drive_reading.h"
#include "arm/joint_move.h"
#include "arm/operating_states.h"
#include "arm/warnings.h"
#include "kinematics/chain.h"
#include "timing/stream_watch.h"

namespace robots {

/// How one arm is built and what it may do. Joint vectors in rad, or m for a prismatic joint.
template <int N>
struct ArmModel {
  using Joints = Eigen::Matrix<double, N, 1>;

  kinematics::Chain<N> chain;
  std::array<const char*, std::size_t{N}> joint_names;
  Joints home;        ///< where home() takes it
  Joints rate_limit;  ///< rad/s or m/s
  /// A joint that trails its set-point by more faults the arm.
  Joints following_error = Joints::Constant(std::numeric_limits<double>::infinity());
  /// s: a servo goal may lie so far from the set-point as the joints can move in this time.
  double servo_horizon = 0.1;
};

template <int N>
class CrtkFace;

/// Turns the commands of an arm into set-points of its joints, and what its drives measure into the
/// arm's state. Confined to one thread; only the constructor allocates.
template <int N>
class ArmController : public Arm {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// Undefined, until step() has a reading of drives that may have power: now and after
  /// startAnew().
  explicit ArmController(const ArmModel<N>& model);

  void enable() override { obey(StateCommand::Enable); }
  void disable() override { obey(StateCommand::Disable); }
  void home() override { obey(StateCommand::Home); }
  void hold() override;
  void servo_cp(const PoseStamped& goal) override;
  void servo_jp(const JointGoal& goal) override;
  void move_jp(const JointGoal& goal) override;

  const JointState& measured_js() const override { return measuredJs_; }
  const JointState& setpoint_js() const override { return setpointJs_; }
  PoseStamped measured_cp() const override { return measuredCp_; }
  PoseStamped setpoint_cp() const override { return setpointCp_; }
  const OperatingState& operating_state() const override { return state_; }
  PoseStamped forward_kinematics(const JointGoal& q) const override;
  JointSolution inverse_kinematics(const PoseStamped& goal) const override;

  /// `client` is gone: if the arm follows a stream of its goals, that ends as hold(), and the arm
  /// says so. A move goes on to its end.
  void clientGone(const suture::ConnectedClient& client);

  void startAnew();

  /// One cycle at time `now`, after the commands that arrived for it. None: the drives are silent.
  void step(suture::Time now, const std::optional<DriveReading<N>>& drives);

  /// From this cycle on the drives shall hold power if this is true, and follow the set-point.
  bool powered() const {
    return state_.state != ArmState::Undefined && state_.state != ArmState::Disabled;
  }
  const Joints& setpoint() const { return setpoint_; }

  /// Tells `events` (what Provided<Arm>::emit() returns) what happened since the last call.
  template <class Events>
  void announce(Events&& events) {
    if (stateChanged_) events.operating_state(state_);
    if (moveEnded_) events.goal_reached(*moveEnded_);
    warnings_.forEachNew([&events](ArmWarning reason) { events.warning(reason); });
    stateChanged_ = false;
    moveEnded_.reset();
    warnings_.forgetNews();
  }

 private:
  friend class CrtkFace<N>;  // the rest of the same arm

  /// The client whose command is being executed; null if it cannot be gone before the arm is.
  virtual const suture::ConnectedClient* asking() const { return nullptr; }

  /// Does what after() says, or refuses.
  void obey(StateCommand command);
  void refuse(StateCommand command);
  void unhome();
  /// Changes to `state`, in which the arm holds where its joints are.
  void restIn(ArmState state, const char* activity);
  /// Takes what the drives measured, and goes where they lead: they stop, or fall silent.
  void take(const std::optional<DriveReading<N>>& drives);
  void obeyPower();
  /// A joint trails its set-point by too much.
  bool trails() const;
  bool mayMove();
  void warn(ArmWarning reason) { warnings_.warn(reason); }
  void enter(ArmState state, const char* activity);
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
  /// The same for a goal of a position, unless it is too far for one step.
  void servo(const ServoTarget& target, suture::Time goalStamp, const char* activity);
  void publish(suture::Time now);

  const ArmModel<N> model_;
  DriveReading<N> reading_;  // what the drives measured last
  bool heard_ = false;       // in this cycle there is a reading
  suture::Time permitted_;   // by which permit of power the arm was enabled
  suture::Time lastStep_;
  Joints setpoint_;
  suture::Time setpointStamp_;  // of the servo goal it came from; unset otherwise
  std::optional<JointMove<N>> move_;
  suture::Time moveStart_;  // of the cycle that began move_
  bool homing_ = false;
  StreamWatch servoing_;                               // whatever else the arm does ends it
  const suture::ConnectedClient* streamer_ = nullptr;  // whose stream is followed
  bool sliding_ = false;                               // along a joint limit
  double moveRatio_ = 1;                               // of the rates that a move may use

  JointState measuredJs_, setpointJs_;
  PoseStamped measuredCp_, setpointCp_;
  OperatingState state_;

  bool stateChanged_ = true;
  std::optional<bool> moveEnded_;
  std::optional<ArmState> desired_;  // what a command asked for, since the face has told it
  Warnings warnings_;
  std::string_view refusal_;  // why the last state command was refused
};

extern template class ArmController<6>;
extern template class ArmController<7>;

}  // namespace robots
