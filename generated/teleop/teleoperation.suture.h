// Written by suturec from teleop/teleoperation.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. teleoperation.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "teleop/teleoperation.h"

namespace robots {

/// Says where following began: with this and the master's poses, anyone can compute what the slave
/// should do.
struct FollowAnchorsSlot {
  std::int64_t master_stamp;              // suture::Time, ns
  std::array<double, 12> master;          // Eigen::Isometry3d, m
  std::array<double, 12> slave_setpoint;  // Eigen::Isometry3d, m
  double scale;
  std::uint64_t entry;
  std::array<double, 9> view;       // Eigen::Matrix3d
  std::uint8_t rotation_locked;     // bool
  std::uint8_t translation_locked;  // bool
};

bool store(const FollowAnchors& value, FollowAnchorsSlot& slot);
void load(const FollowAnchorsSlot& slot, FollowAnchors& value);
void shiftStamps(FollowAnchorsSlot& slot, suture::Duration shift);

/// Holds the settings by which the slave follows.
struct TeleopSettingsSlot {
  double scale;
  std::uint8_t rotation_locked;     // bool
  std::uint8_t translation_locked;  // bool
};

bool store(const TeleopSettings& value, TeleopSettingsSlot& slot);
void load(const TeleopSettingsSlot& slot, TeleopSettings& value);

bool isKnownTeleopState(std::uint8_t slot);
bool isValid(const FollowAnchorsSlot& slot, suture::FieldPath* path);
bool isValid(const TeleopSettingsSlot& slot, suture::FieldPath* path);

// --- Teleoperation: the arguments of its commands ---

struct TeleoperationSetScaleArguments {
  double scale;
};

bool store(const double& scale, TeleoperationSetScaleArguments& slot);

struct TeleoperationLockRotationArguments {
  std::uint8_t lock;
};

bool store(const bool& lock, TeleoperationLockRotationArguments& slot);

struct TeleoperationLockTranslationArguments {
  std::uint8_t lock;
};

bool store(const bool& lock, TeleoperationLockTranslationArguments& slot);

/// Numbers the commands of Teleoperation.
struct TeleoperationCommand {
  static constexpr std::uint16_t enable = 0;
  static constexpr std::uint16_t disable = 1;
  static constexpr std::uint16_t teleop_state = 2;
  static constexpr std::uint16_t anchors = 3;
  static constexpr std::uint16_t set_scale = 4;
  static constexpr std::uint16_t lock_rotation = 5;
  static constexpr std::uint16_t lock_translation = 6;
  static constexpr std::uint16_t settings = 7;
};

/// Numbers the events of Teleoperation.
struct TeleoperationEvent {
  static constexpr std::uint16_t teleop_state = 0;
  static constexpr std::uint16_t followed = 1;
  static constexpr std::uint16_t settings = 2;
};

/// Numbers the reads of Teleoperation as a row of the state has them.
struct TeleoperationColumn {
  static constexpr std::uint16_t teleop_state = 0;
  static constexpr std::uint16_t anchors = 1;
  static constexpr std::uint16_t settings = 2;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::FollowAnchors& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::FollowAnchors& value);

template <>
Result<std::vector<std::byte>> encode(const robots::TeleopSettings& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::TeleopSettings& value);

template <>
const InterfaceInfo& interfaceInfo<robots::Teleoperation>();

/// Calls robots::Teleoperation of another component.
template <>
class Required<robots::Teleoperation> : public RequiredBase {
  using Contract = robots::Teleoperation;
  using Id = robots::TeleoperationCommand;
  using EventId = robots::TeleoperationEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Enables and homes arms that are not, then follows. It does not enable an arm in FAULT: the
  /// operator who has removed the cause does.
  /// Void: up to 16 wait.
  Command<&Contract::enable, NoSlot> enable{*this, Id::enable};
  /// Stops following. The slave holds.
  /// Void: up to 16 wait.
  Command<&Contract::disable, NoSlot> disable{*this, Id::disable};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::teleop_state, std::uint8_t> teleop_state{*this, Id::teleop_state};
  /// Returns the anchors of the present or last time of following.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::anchors, robots::FollowAnchorsSlot> anchors{*this, Id::anchors};
  /// Write: up to 16 wait. `scale` is from 0.01 to 10.
  Command<&Contract::set_scale, robots::TeleoperationSetScaleArguments> set_scale{
      *this, Id::set_scale};
  /// Makes the slave keep its orientation. When it is unlocked, the master is aligned anew before
  /// the slave follows.
  /// Write: up to 16 wait.
  Command<&Contract::lock_rotation, robots::TeleoperationLockRotationArguments> lock_rotation{
      *this, Id::lock_rotation};
  /// Makes the slave keep its position.
  /// Write: up to 16 wait.
  Command<&Contract::lock_translation,
          robots::TeleoperationLockTranslationArguments> lock_translation{
      *this, Id::lock_translation};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::settings, robots::TeleopSettingsSlot> settings{*this, Id::settings};

  /// Subscribes to the events of robots::Teleoperation.
  struct Events {
    explicit Events(RequiredBase& required)
        : teleop_state{required, EventId::teleop_state},
          followed{required, EventId::followed},
          settings{required, EventId::settings} {}

    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, robots::TeleopState> teleop_state;
    /// Reports that following begins, or goes on with other settings.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<robots::FollowAnchorsSlot, robots::FollowAnchors> followed;
    /// Reports each change, and the last one to a client that connects.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<robots::TeleopSettingsSlot, robots::TeleopSettings> settings;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::Teleoperation from a component.
template <>
class Provided<robots::Teleoperation> : public ProvidedBase {
  using Contract = robots::Teleoperation;
  using EventId = robots::TeleoperationEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::Teleoperation.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : teleop_state{provided, EventId::teleop_state},
          followed{provided, EventId::followed},
          settings{provided, EventId::settings} {}

    Emitter<std::uint8_t, robots::TeleopState> teleop_state;
    /// Reports that following begins, or goes on with other settings.
    Emitter<robots::FollowAnchorsSlot, robots::FollowAnchors> followed;
    /// Reports each change, and the last one to a client that connects.
    Emitter<robots::TeleopSettingsSlot, robots::TeleopSettings> settings;
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

  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    double set_scale_scale{};
    bool lock_rotation_lock{};
    bool lock_translation_lock{};
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_;
};

}  // namespace suture
