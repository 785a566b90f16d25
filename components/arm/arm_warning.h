#pragma once
// These are the numbers by which an arm says what it refuses and what has happened to it.

#include <cstdint>

namespace robots {

/// An ArmWarning is the code of an arm's warning or error.
enum class ArmWarning : std::uint32_t {
  NotEnabled = 1,  ///< motion commands need an enabled arm
  OutOfReach,      ///< no joint vector reaches the goal; for a move, none within limits
  Malformed,       ///< the goal has the wrong length, a number beyond 1e9, or is not a pose
  ClientGone,      ///< the client whose stream it followed is gone; the arm holds
  WrongState,      ///< the operating state does not admit the command: operating_states.h
  FollowingError,  ///< a joint trailed its set-point by more than its bound; the arm is in FAULT
  AtLimit,         ///< what it follows leads beyond a joint limit: the arm slides along it; once
                   ///< until it leads within again
  StepTooFar,      ///< a servo goal lies farther from the set-point than the rates allow
  PowerLost,       ///< the drives have no power any more, or may not have it: the arm is disabled
  DrivesSilent,    ///< the drives have measured nothing for 250 ms; the arm is in FAULT
  WrongFrame,      ///< a base is given in another frame than the arm's poses are
  InMotion,        ///< the base stays as it is while the arm moves, or a stream of
                   ///< goals in the reference frame comes
  EncoderJump,     ///< a joint is measured farther from where it was than it can have moved; the
                   ///< arm is in FAULT
  OverCurrent,     ///< a motor has given more than its joint may take for too long; the arm is in
                   ///< FAULT
  NotInserted,     ///< Cartesian control needs the wrist beyond the cannula: the rule of Arm
  NotHomed,        ///< Cartesian control needs an arm that is homed
};

}  // namespace robots
