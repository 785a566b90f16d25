// Written by suturec from unit/large_values/canvas.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. canvas.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "unit/large_values/canvas.h"

namespace large_values {

struct DotSlot {
  std::uint8_t shade;
};

bool store(const Dot& value, DotSlot& slot);
void load(const DotSlot& slot, Dot& value);

struct DotsSlot {
  suture::BoundedList<DotSlot, 2500000> dots;
};

bool store(const Dots& value, DotsSlot& slot);
void load(const DotsSlot& slot, Dots& value);
void reserve(const DotsSlot*, Dots& value);

bool isValid(const DotSlot& slot, suture::FieldPath* path);
bool isValid(const DotsSlot& slot, suture::FieldPath* path);

// --- Canvas: the arguments of its commands ---

struct CanvasResizeArguments {
  std::uint32_t dots;
};

bool store(const std::uint32_t& dots, CanvasResizeArguments& slot);

struct CanvasPaintArguments {
  DotsSlot dots;
};

bool store(const Dots& dots, CanvasPaintArguments& slot);

struct CanvasCopyArguments {
  std::uint32_t dots;
};

bool store(const std::uint32_t& dots, CanvasCopyArguments& slot);

/// Numbers the commands of Canvas.
struct CanvasCommand {
  static constexpr std::uint16_t resize = 0;
  static constexpr std::uint16_t paint = 1;
  static constexpr std::uint16_t painting = 2;
  static constexpr std::uint16_t copy = 3;
};

/// Numbers the events of Canvas.
struct CanvasEvent {
  static constexpr std::uint16_t painted = 0;
};

/// Numbers the reads of Canvas as a row of the state has them.
struct CanvasColumn {
  static constexpr std::uint16_t painting = 0;
};

}  // namespace large_values

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const large_values::Dot& value);
template <>
Result<> decode(std::span<const std::byte> bytes, large_values::Dot& value);

template <>
Result<std::vector<std::byte>> encode(const large_values::Dots& value);
template <>
Result<> decode(std::span<const std::byte> bytes, large_values::Dots& value);

template <>
const InterfaceInfo& interfaceInfo<large_values::Canvas>();

/// Calls large_values::Canvas of another component.
template <>
class Required<large_values::Canvas> : public RequiredBase {
  using Contract = large_values::Canvas;
  using Id = large_values::CanvasCommand;
  using EventId = large_values::CanvasEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Makes a painting of so many dots.
  /// Write: up to 16 wait.
  Command<&Contract::resize, large_values::CanvasResizeArguments> resize{*this, Id::resize};
  /// Write: up to 2 wait.
  Command<&Contract::paint, large_values::CanvasPaintArguments> paint{*this, Id::paint};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::painting, large_values::DotsSlot> painting{*this, Id::painting};
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::copy, large_values::CanvasCopyArguments,
                       large_values::DotsSlot> copy{*this, Id::copy};

  /// Subscribes to the events of large_values::Canvas.
  struct Events {
    explicit Events(RequiredBase& required)
        : painted{required, EventId::painted} {}

    /// At a subscriber up to 2 wait.
    Subscription<large_values::DotsSlot, large_values::Dots> painted;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves large_values::Canvas from a component.
template <>
class Provided<large_values::Canvas> : public ProvidedBase {
  using Contract = large_values::Canvas;
  using EventId = large_values::CanvasEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of large_values::Canvas.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : painted{provided, EventId::painted} {}

    Emitter<large_values::DotsSlot, large_values::Dots> painted;
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
    std::uint32_t resize_dots{};
    large_values::Dots paint_dots{};
    std::uint32_t copy_dots{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
