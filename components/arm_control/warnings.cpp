#include "arm_control/warnings.h"

namespace robots {

std::string_view textOf(ArmWarning reason) {
  switch (reason) {
    case ArmWarning::NotEnabled: return "motion needs an enabled arm";
    case ArmWarning::OutOfReach: return "no joint vector reaches the goal";
    case ArmWarning::Malformed:
      return "the goal has the wrong length or a number beyond 1e9, or is no pose";
    case ArmWarning::ClientGone: return "the client whose stream the arm followed is gone";
    case ArmWarning::AtLimit: return "the goal leads beyond a joint limit; the arm slides along it";
    case ArmWarning::StepTooFar:
      return "the goal lies farther than the joints can be at their rates, by one step or many";
    case ArmWarning::WrongState: return "the operating state does not admit the command";
    case ArmWarning::FollowingError:
      return "it trailed its set-point by more than its bound; enable or disable the arm";
    case ArmWarning::PowerLost:
      return "the drives have no power, or may not have it; enable the arm when they may";
    case ArmWarning::DrivesSilent:
      return "the drives have been silent for too long; enable or disable the arm";
    case ArmWarning::WrongFrame:
      return "the base is given in another frame than the arm's poses are";
    case ArmWarning::EncoderJump:
      return "its encoder jumped farther than it can move; enable or disable the arm";
    case ArmWarning::OverCurrent:
      return "its effort was above its limit for too long; enable or disable the arm";
    case ArmWarning::NotInserted:
      return "Cartesian control needs the wrist farther beyond the remote centre; insert it";
    case ArmWarning::NotHomed:
      return "Cartesian control needs an arm that knows where its joints are; home it";
    case ArmWarning::InMotion:
      return "the base stays as it is while the arm moves or a stream comes; end "
             "that, then hold it";
  }
  return "";
}

}  // namespace robots
