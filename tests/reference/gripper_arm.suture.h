// Written by suturec from reference/gripper_arm.h. Do not edit.
#pragma once

#include <suture/base/slots.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "reference/gripper_arm.h"
#include "reference/arm_like.suture.h"

namespace reference {

// --- GripperArm: the arguments of its commands ---

struct GripperArmCloseArguments {
  double width;  // m
};

inline bool store(const double& width, GripperArmCloseArguments& slot) {
  using suture::store;
  return store(width, slot.width);
}

/// The numbers of GripperArm's commands in every table and record.
enum class GripperArmCommand : std::uint16_t {
  servo_cp,
  servo_jp,
  hold,
  set_mode,
  measured_cp,
  measured_js,
  distance,
  move,
  reset,
  limit,
  park,
  close,
  opening,
};

/// The numbers of GripperArm's events.
enum class GripperArmEvent : std::uint16_t {
  mode,
  arrived,
  stopped,
  moved,
  gripped,
};

}  // namespace reference

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<reference::GripperArm>();

/// What a client of reference::GripperArm calls.
template <>
class Required<reference::GripperArm> final : public RequiredBase {
  using Contract = reference::GripperArm;
  using Id = reference::GripperArmCommand;
  using EventId = reference::GripperArmEvent;

 public:
  Required(Component& owner, std::string_view name)
      : RequiredBase(owner, name, interfaceInfo<Contract>()) {}

  /// Follows a stream of poses.
  Command<&Contract::servo_cp, reference::ArmLikeServoCpArguments> servo_cp{
      *this, static_cast<std::uint16_t>(Id::servo_cp)};
  Command<&Contract::servo_jp, reference::ArmLikeServoJpArguments> servo_jp{
      *this, static_cast<std::uint16_t>(Id::servo_jp)};
  Command<&Contract::hold, NoSlot> hold{*this, static_cast<std::uint16_t>(Id::hold)};
  Command<&Contract::set_mode, reference::ArmLikeSetModeArguments> set_mode{
      *this, static_cast<std::uint16_t>(Id::set_mode)};
  ReadCommand<&Contract::measured_cp, reference::PoseStampedSlot> measured_cp{
      *this, static_cast<std::uint16_t>(Id::measured_cp)};
  ReadCommand<&Contract::measured_js, reference::JointStateSlot> measured_js{
      *this, static_cast<std::uint16_t>(Id::measured_js)};
  QualifiedReadCommand<&Contract::distance, reference::ArmLikeDistanceArguments, double> distance{
      *this, static_cast<std::uint16_t>(Id::distance)};
  /// Moves along a line; answers whether it can.
  ReturningCommand<&Contract::move, reference::ArmLikeMoveArguments, std::uint8_t> move{
      *this, static_cast<std::uint16_t>(Id::move)};
  /// Forgets what it was told; answers how much that was.
  ReturningCommand<&Contract::reset, NoSlot, std::uint32_t> reset{
      *this, static_cast<std::uint16_t>(Id::reset)};
  Command<&Contract::limit, reference::ArmLikeLimitArguments> limit{
      *this, static_cast<std::uint16_t>(Id::limit)};
  /// Folds the arm.
  Command<&Contract::park, NoSlot> park{*this, static_cast<std::uint16_t>(Id::park)};
  /// Closes to this width; answers the width that it could reach.
  ReturningCommand<&Contract::close, reference::GripperArmCloseArguments, double> close{
      *this, static_cast<std::uint16_t>(Id::close)};
  ReadCommand<&Contract::opening, double> opening{*this, static_cast<std::uint16_t>(Id::opening)};

  /// The events of reference::GripperArm, to subscribe to.
  struct Events {
    explicit Events(RequiredBase& required)
        : mode{required, static_cast<std::uint16_t>(EventId::mode)},
          arrived{required, static_cast<std::uint16_t>(EventId::arrived)},
          stopped{required, static_cast<std::uint16_t>(EventId::stopped)},
          moved{required, static_cast<std::uint16_t>(EventId::moved)},
          gripped{required, static_cast<std::uint16_t>(EventId::gripped)} {}

    Subscription<std::uint8_t, reference::Mode> mode;
    Subscription<reference::PoseStampedSlot, reference::PoseStamped> arrived;
    Subscription<void> stopped;
    /// Where it is and how fast.
    Subscription<reference::ArmLikeMovedPayload, reference::PoseStamped, double> moved;
    Subscription<double, double> gripped;
  };
  Events& on() { return events_; }

 private:
  Events events_{*this};
};

/// What serves reference::GripperArm from a component.
template <>
class Provided<reference::GripperArm> final : public ProvidedBase {
  using Contract = reference::GripperArm;
  using EventId = reference::GripperArmEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : ProvidedBase(owner, name, interfaceInfo<Contract>(), &implementation),
        implementation_(implementation) {}

  /// The events of reference::GripperArm, to emit.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : mode{provided, static_cast<std::uint16_t>(EventId::mode)},
          arrived{provided, static_cast<std::uint16_t>(EventId::arrived)},
          stopped{provided, static_cast<std::uint16_t>(EventId::stopped)},
          moved{provided, static_cast<std::uint16_t>(EventId::moved)},
          gripped{provided, static_cast<std::uint16_t>(EventId::gripped)} {}

    Emitter<std::uint8_t, reference::Mode> mode;
    Emitter<reference::PoseStampedSlot, reference::PoseStamped> arrived;
    Emitter<void> stopped;
    /// Where it is and how fast.
    Emitter<reference::ArmLikeMovedPayload, reference::PoseStamped, double> moved;
    Emitter<double, double> gripped;
  };
  Events& emit() { return events_; }

 private:
  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    reference::PoseStamped servo_cp_goal;
    reference::JointState servo_jp_goal;
    reference::Mode set_mode_mode;
    reference::PoseStamped distance_to;
    reference::PoseStamped move_goal;
    double move_speed;
    std::string move_reason;
    double limit_speed;
    reference::Mode limit_mode;
    double close_width;
  };

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_{};
};

}  // namespace suture
