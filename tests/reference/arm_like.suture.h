// Written by suturec from reference/arm_like.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. arm_like.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "reference/arm_like.h"
#include "reference/arm_types.suture.h"

namespace reference {

// --- ArmLike: the arguments of its commands ---

struct ArmLikeServoCpArguments {
  PoseStampedSlot goal;
};

bool store(const PoseStamped& goal, ArmLikeServoCpArguments& slot);
void shiftStamps(ArmLikeServoCpArguments& slot, suture::Duration shift);

struct ArmLikeServoJpArguments {
  JointStateSlot goal;
};

bool store(const JointState& goal, ArmLikeServoJpArguments& slot);

struct ArmLikeSetModeArguments {
  std::uint8_t mode;  // Mode
};

bool store(const Mode& mode, ArmLikeSetModeArguments& slot);

struct ArmLikeDistanceArguments {
  PoseStampedSlot to;
};

bool store(const PoseStamped& to, ArmLikeDistanceArguments& slot);
void shiftStamps(ArmLikeDistanceArguments& slot, suture::Duration shift);

struct ArmLikeMoveArguments {
  PoseStampedSlot goal;
  double speed;
  suture::BoundedText<15> reason;
};

bool store(const PoseStamped& goal, const double& speed, const std::string& reason,
           ArmLikeMoveArguments& slot);
void shiftStamps(ArmLikeMoveArguments& slot, suture::Duration shift);

struct ArmLikeLimitArguments {
  double speed;
  std::uint8_t mode;  // Mode
};

bool store(const double& speed, const Mode& mode, ArmLikeLimitArguments& slot);

// --- ArmLike: what its events carry ---

struct ArmLikeMovedPayload {
  PoseStampedSlot value;
  double value2;
};

bool store(const PoseStamped& value, const double& value2, ArmLikeMovedPayload& slot);
void load(const ArmLikeMovedPayload& slot, PoseStamped& value, double& value2);
void shiftStamps(ArmLikeMovedPayload& slot, suture::Duration shift);

/// Numbers the commands of ArmLike.
struct ArmLikeCommand {
  static constexpr std::uint16_t servo_cp = 0;
  static constexpr std::uint16_t servo_jp = 1;
  static constexpr std::uint16_t hold = 2;
  static constexpr std::uint16_t set_mode = 3;
  static constexpr std::uint16_t measured_cp = 4;
  static constexpr std::uint16_t measured_js = 5;
  static constexpr std::uint16_t distance = 6;
  static constexpr std::uint16_t move = 7;
  static constexpr std::uint16_t reset = 8;
  static constexpr std::uint16_t limit = 9;
  static constexpr std::uint16_t park = 10;
};

/// Numbers the events of ArmLike.
struct ArmLikeEvent {
  static constexpr std::uint16_t mode = 0;
  static constexpr std::uint16_t arrived = 1;
  static constexpr std::uint16_t stopped = 2;
  static constexpr std::uint16_t moved = 3;
};

/// Numbers the reads of ArmLike as a row of the state has them.
struct ArmLikeColumn {
  static constexpr std::uint16_t measured_cp = 0;
  static constexpr std::uint16_t measured_js = 1;
};

}  // namespace reference

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<reference::ArmLike>();

/// Calls reference::ArmLike of another component.
template <>
class Required<reference::ArmLike> : public RequiredBase {
  using Contract = reference::ArmLike;
  using Id = reference::ArmLikeCommand;
  using EventId = reference::ArmLikeEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Follows a stream of poses.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 500 ms
  /// ago.
  Command<&Contract::servo_cp, reference::ArmLikeServoCpArguments> servo_cp{*this, Id::servo_cp};
  /// Write: a newer one replaces the one that waits.
  Command<&Contract::servo_jp, reference::ArmLikeServoJpArguments> servo_jp{*this, Id::servo_jp};
  /// Void: up to 4 wait.
  Command<&Contract::hold, NoSlot> hold{*this, Id::hold};
  /// Write: up to 16 wait.
  Command<&Contract::set_mode, reference::ArmLikeSetModeArguments> set_mode{*this, Id::set_mode};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_cp, reference::PoseStampedSlot> measured_cp{
      *this, Id::measured_cp};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_js, reference::JointStateSlot> measured_js{
      *this, Id::measured_js};
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::distance, reference::ArmLikeDistanceArguments, double> distance{
      *this, Id::distance};
  /// Moves along a line; answers whether it can.
  /// Write with return: up to 16 wait. `within()` waits 200 ms for the answer. `speed` is from 0 to
  /// 1.
  ReturningCommand<&Contract::move, reference::ArmLikeMoveArguments, std::uint8_t> move{
      *this, Id::move};
  /// Forgets what it was told; answers how much that was.
  /// Void with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::reset, NoSlot, std::uint32_t> reset{*this, Id::reset};
  /// Write: up to 2 wait.
  Command<&Contract::limit, reference::ArmLikeLimitArguments> limit{*this, Id::limit};
  /// Folds the arm.
  /// Void: up to 16 wait.
  Command<&Contract::park, NoSlot> park{*this, Id::park};

  /// Subscribes to the events of reference::ArmLike.
  struct Events {
    explicit Events(RequiredBase& required)
        : mode{required, EventId::mode},
          arrived{required, EventId::arrived},
          stopped{required, EventId::stopped},
          moved{required, EventId::moved} {}

    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, reference::Mode> mode;
    /// At a subscriber up to 4 wait.
    Subscription<reference::PoseStampedSlot, reference::PoseStamped> arrived;
    /// At a subscriber up to 16 wait.
    Subscription<void> stopped;
    /// Where it is and how fast.
    /// At a subscriber up to 16 wait.
    Subscription<reference::ArmLikeMovedPayload, reference::PoseStamped, double> moved;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves reference::ArmLike from a component.
template <>
class Provided<reference::ArmLike> : public ProvidedBase {
  using Contract = reference::ArmLike;
  using EventId = reference::ArmLikeEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of reference::ArmLike.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : mode{provided, EventId::mode},
          arrived{provided, EventId::arrived},
          stopped{provided, EventId::stopped},
          moved{provided, EventId::moved} {}

    Emitter<std::uint8_t, reference::Mode> mode;
    Emitter<reference::PoseStampedSlot, reference::PoseStamped> arrived;
    Emitter<void> stopped;
    /// Where it is and how fast.
    Emitter<reference::ArmLikeMovedPayload, reference::PoseStamped, double> moved;
  };
  Events& emit() { return events_; }

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : ProvidedBase(owner, name, info, whole),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  struct Dispatch;  // has a function for each command

  // Reused by every command, so that what they own is allocated once: by reserved().
  struct Scratch {
    reference::PoseStamped servo_cp_goal{};
    reference::JointState servo_jp_goal{};
    reference::Mode set_mode_mode{};
    reference::PoseStamped distance_to{};
    reference::PoseStamped move_goal{};
    double move_speed{};
    std::string move_reason{};
    double limit_speed{};
    reference::Mode limit_mode{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
