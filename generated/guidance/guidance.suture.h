// Written by suturec from guidance/guidance.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. guidance.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "guidance/guidance.h"

namespace robots {

struct GuidanceProgressSlot {
  std::array<double, 3> knot;  // Eigen::Vector3d, m
  double distance_to_target;   // m
  double lateral_error;        // m
  std::int64_t stamp;          // suture::Time, ns
  std::uint8_t valid;          // bool
};

bool store(const GuidanceProgress& value, GuidanceProgressSlot& slot);
void load(const GuidanceProgressSlot& slot, GuidanceProgress& value);
void shiftStamps(GuidanceProgressSlot& slot, suture::Duration shift);

/// Says how fast the hands lead each tip where the fixtures let none go, in the scene: what a hand
/// should feel of them. What a fixture only delays is not in it.
struct ForbiddenMotionSlot {
  std::array<double, 3> left;   // Eigen::Vector3d, m/s
  std::array<double, 3> right;  // Eigen::Vector3d, m/s
  std::int64_t stamp;           // suture::Time, ns
  std::uint8_t valid;           // bool
};

bool store(const ForbiddenMotion& value, ForbiddenMotionSlot& slot);
void load(const ForbiddenMotionSlot& slot, ForbiddenMotion& value);
void shiftStamps(ForbiddenMotionSlot& slot, suture::Duration shift);

bool isKnownGuidanceState(std::uint8_t slot);
bool isValid(const GuidanceProgressSlot& slot, suture::FieldPath* path);
bool isValid(const ForbiddenMotionSlot& slot, suture::FieldPath* path);

/// Numbers the commands of Guidance.
struct GuidanceCommand {
  static constexpr std::uint16_t guidance_state = 0;
  static constexpr std::uint16_t progress = 1;
  static constexpr std::uint16_t enable = 2;
  static constexpr std::uint16_t disable = 3;
  static constexpr std::uint16_t forbidden_motion = 4;
};

/// Numbers the events of Guidance.
struct GuidanceEvent {
  static constexpr std::uint16_t guidance_state = 0;
};

/// Numbers the reads of Guidance as a row of the state has them.
struct GuidanceColumn {
  static constexpr std::uint16_t guidance_state = 0;
  static constexpr std::uint16_t progress = 1;
  static constexpr std::uint16_t forbidden_motion = 2;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::GuidanceProgress& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::GuidanceProgress& value);

template <>
Result<std::vector<std::byte>> encode(const robots::ForbiddenMotion& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ForbiddenMotion& value);

template <>
const InterfaceInfo& interfaceInfo<robots::Guidance>();

/// Calls robots::Guidance of another component.
template <>
class Required<robots::Guidance> : public RequiredBase {
  using Contract = robots::Guidance;
  using Id = robots::GuidanceCommand;
  using EventId = robots::GuidanceEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::guidance_state, std::uint8_t> guidance_state{*this, Id::guidance_state};
  /// The guide updates this even while it waits for something, as far as the knot has been seen.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::progress, robots::GuidanceProgressSlot> progress{*this, Id::progress};
  /// Enables and homes arms that are not, then guides. This also works after an arm was disabled or
  /// restarted. It does not enable an arm in FAULT: the operator who has removed the cause does.
  /// Void: up to 16 wait.
  Command<&Contract::enable, NoSlot> enable{*this, Id::enable};
  /// Stops guiding. Both slaves hold.
  /// Void: up to 16 wait.
  Command<&Contract::disable, NoSlot> disable{*this, Id::disable};
  /// A client at the masters makes hands feel this, as components/force_feedback says.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::forbidden_motion, robots::ForbiddenMotionSlot> forbidden_motion{
      *this, Id::forbidden_motion};

  /// Subscribes to the events of robots::Guidance.
  struct Events {
    explicit Events(RequiredBase& required)
        : guidance_state{required, EventId::guidance_state} {}

    /// Reports each change, and the last one to a client that connects.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, robots::GuidanceState> guidance_state;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::Guidance from a component.
template <>
class Provided<robots::Guidance> : public ProvidedBase {
  using Contract = robots::Guidance;
  using EventId = robots::GuidanceEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::Guidance.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : guidance_state{provided, EventId::guidance_state} {}

    /// Reports each change, and the last one to a client that connects.
    Emitter<std::uint8_t, robots::GuidanceState> guidance_state;
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

  Contract& implementation_;
  Events events_{*this};
};

}  // namespace suture
