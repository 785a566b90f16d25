// Written by suturec from unit/large_values/screen.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. screen.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "unit/large_values/screen.h"

namespace large_values {

struct FrameSlot {
  std::uint32_t number;
  suture::BoundedList<std::uint8_t, 65536> pixels;
};

bool store(const Frame& value, FrameSlot& slot);
void load(const FrameSlot& slot, Frame& value);
void reserve(const FrameSlot*, Frame& value);

struct FramePairSlot {
  FrameSlot left;
  FrameSlot right;
};

bool store(const FramePair& value, FramePairSlot& slot);
void load(const FramePairSlot& slot, FramePair& value);
void reserve(const FramePairSlot*, FramePair& value);

bool isValid(const FrameSlot& slot, suture::FieldPath* path);
bool isValid(const FramePairSlot& slot, suture::FieldPath* path);

// --- Screen: the arguments of its commands ---

struct ScreenShowArguments {
  FrameSlot frame;
};

bool store(const Frame& frame, ScreenShowArguments& slot);

struct ScreenReplaceArguments {
  FrameSlot frame;
};

bool store(const Frame& frame, ScreenReplaceArguments& slot);

struct ScreenShowBothArguments {
  FramePairSlot frames;
};

bool store(const FramePair& frames, ScreenShowBothArguments& slot);

/// Numbers the commands of Screen.
struct ScreenCommand {
  static constexpr std::uint16_t show = 0;
  static constexpr std::uint16_t replace = 1;
  static constexpr std::uint16_t show_both = 2;
};

/// Numbers the events of Screen.
struct ScreenEvent {
  static constexpr std::uint16_t shown = 0;
  static constexpr std::uint16_t newest = 1;
  static constexpr std::uint16_t both = 2;
};

}  // namespace large_values

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const large_values::Frame& value);
template <>
Result<> decode(std::span<const std::byte> bytes, large_values::Frame& value);

template <>
Result<std::vector<std::byte>> encode(const large_values::FramePair& value);
template <>
Result<> decode(std::span<const std::byte> bytes, large_values::FramePair& value);

template <>
const InterfaceInfo& interfaceInfo<large_values::Screen>();

/// Calls large_values::Screen of another component.
template <>
class Required<large_values::Screen> : public RequiredBase {
  using Contract = large_values::Screen;
  using Id = large_values::ScreenCommand;
  using EventId = large_values::ScreenEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Write: up to 3 wait.
  Command<&Contract::show, large_values::ScreenShowArguments> show{*this, Id::show};
  /// Write: a newer one replaces the one that waits.
  Command<&Contract::replace, large_values::ScreenReplaceArguments> replace{*this, Id::replace};
  /// Write: up to 3 wait.
  Command<&Contract::show_both, large_values::ScreenShowBothArguments> show_both{
      *this, Id::show_both};

  /// Subscribes to the events of large_values::Screen.
  struct Events {
    explicit Events(RequiredBase& required)
        : shown{required, EventId::shown},
          newest{required, EventId::newest},
          both{required, EventId::both} {}

    /// At a subscriber up to 3 wait.
    Subscription<large_values::FrameSlot, large_values::Frame> shown;
    /// At a subscriber a newer one replaces the one that waits.
    Subscription<large_values::FrameSlot, large_values::Frame> newest;
    /// At a subscriber up to 3 wait.
    Subscription<large_values::FramePairSlot, large_values::FramePair> both;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves large_values::Screen from a component.
template <>
class Provided<large_values::Screen> : public ProvidedBase {
  using Contract = large_values::Screen;
  using EventId = large_values::ScreenEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of large_values::Screen.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : shown{provided, EventId::shown},
          newest{provided, EventId::newest},
          both{provided, EventId::both} {}

    Emitter<large_values::FrameSlot, large_values::Frame> shown;
    Emitter<large_values::FrameSlot, large_values::Frame> newest;
    Emitter<large_values::FramePairSlot, large_values::FramePair> both;
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
    large_values::Frame show_frame{};
    large_values::Frame replace_frame{};
    large_values::FramePair show_both_frames{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
