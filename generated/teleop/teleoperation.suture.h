// Written by suturec from teleop/teleoperation.h. Do not edit.
#pragma once

#include <suture/base/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "teleop/teleoperation.h"

namespace robots {

/// Where following began: with it and the master's poses, anyone can compute what the slave should
/// do.
struct FollowAnchorsSlot {
  std::int64_t master_stamp;              // suture::Time, ns
  std::array<double, 12> master;          // Eigen::Isometry3d, m
  std::array<double, 12> slave_setpoint;  // Eigen::Isometry3d, m
  double scale;
  std::uint64_t entry;
};

bool store(const FollowAnchors& value, FollowAnchorsSlot& slot);
void load(const FollowAnchorsSlot& slot, FollowAnchors& value);
void shiftStamps(FollowAnchorsSlot& slot, suture::Duration shift);

/// The numbers of Teleoperation's commands in every table and record.
enum class TeleoperationCommand : std::uint16_t {
  enable,
  disable,
  teleop_state,
  anchors,
};

/// The numbers of Teleoperation's events.
enum class TeleoperationEvent : std::uint16_t {
  teleop_state,
  followed,
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Teleoperation>();

/// What a client of robots::Teleoperation calls.
template <>
class Required<robots::Teleoperation> : public RequiredBase {
  using Contract = robots::Teleoperation;
  using Id = robots::TeleoperationCommand;
  using EventId = robots::TeleoperationEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Enables and homes arms that are not, then follows.
  Command<&Contract::enable, NoSlot> enable{*this, static_cast<std::uint16_t>(Id::enable)};
  /// Stops following; the slave holds.
  Command<&Contract::disable, NoSlot> disable{*this, static_cast<std::uint16_t>(Id::disable)};
  ReadCommand<&Contract::teleop_state, std::uint8_t> teleop_state{
      *this, static_cast<std::uint16_t>(Id::teleop_state)};
  /// Of the present or last time of following.
  ReadCommand<&Contract::anchors, robots::FollowAnchorsSlot> anchors{
      *this, static_cast<std::uint16_t>(Id::anchors)};

  /// The events of robots::Teleoperation, to subscribe to.
  struct Events {
    explicit Events(RequiredBase& required)
        : teleop_state{required, static_cast<std::uint16_t>(EventId::teleop_state)},
          followed{required, static_cast<std::uint16_t>(EventId::followed)} {}

    Subscription<std::uint8_t, robots::TeleopState> teleop_state;
    /// Following begins.
    Subscription<robots::FollowAnchorsSlot, robots::FollowAnchors> followed;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// What serves robots::Teleoperation from a component.
template <>
class Provided<robots::Teleoperation> : public ProvidedBase {
  using Contract = robots::Teleoperation;
  using EventId = robots::TeleoperationEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// The events of robots::Teleoperation, to emit.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : teleop_state{provided, static_cast<std::uint16_t>(EventId::teleop_state)},
          followed{provided, static_cast<std::uint16_t>(EventId::followed)} {}

    Emitter<std::uint8_t, robots::TeleopState> teleop_state;
    /// Following begins.
    Emitter<robots::FollowAnchorsSlot, robots::FollowAnchors> followed;
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
  Contract& implementation_;
  Events events_{*this};
};

}  // namespace suture
