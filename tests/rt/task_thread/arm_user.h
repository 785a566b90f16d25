#pragma once
// This uses all of the Arm contract, without ever waiting.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "arm/arm.suture.h"

namespace proof {

/// Uses in each cycle every read, the next of all commands, and a question that is followed by
/// poll(). It subscribes to every event.
class ArmUser {
 public:
  explicit ArmUser(suture::Required<robots::Arm>& arm);

  /// The thread that owns the required interface calls this.
  void cycle();

  // These count how the commands, reads and questions ended.
  std::uint64_t reads = 0, commands = 0, refused = 0, answers = 0, events = 0;

  /// Returns true if each command has been executed, each value read and each question answered
  /// some times over, and what tasks do once a second has been done. Before that, code that runs
  /// for the first time may cost a page fault.
  bool isWarm() const;

 private:
  using Step = std::function<suture::Result<void>()>;
  using Question = suture::Call<suture::Result<robots::PoseStamped>, robots::PoseStampedSlot>;
  using Problem = suture::Call<suture::Result<robots::JointSolution>, robots::JointSolutionSlot>;

  void subscribe();
  std::vector<Step> stateSteps();
  std::vector<Step> streamSteps();
  std::vector<Step> moveSteps();
  std::vector<Step> settingSteps();
  void readAll();
  void readMotion();
  void ask();
  template <class Read, class Value>
  void read(Read& command, Value& value) {
    reads += command(value) ? 1 : 0;
  }

  suture::Required<robots::Arm>& arm_;
  suture::Time began_;
  std::vector<Step> steps_;
  std::size_t next_ = 0;
  std::optional<Question> question_;
  std::optional<Problem> problem_;

  // These hold what is read, and keep its memory so that no read allocates, and what is sent.
  robots::JointConfiguration configuration_;
  robots::OperatingState state_;
  robots::IntervalStatistics periods_;
  robots::JointState joints_;
  robots::PoseStamped pose_;
  robots::TransformStamped base_;
  robots::Twist twist_;
  robots::Wrench wrench_;
  robots::CartesianState cartesian_;
  robots::Jacobian jacobian_;
  double ratio_ = 0;
  robots::JointGoal here_, step_, short_;
  robots::JointVelocityGoal velocity_;
  robots::JointEffortGoal effort_;
  robots::PoseStamped noStep_;
};

}  // namespace proof
