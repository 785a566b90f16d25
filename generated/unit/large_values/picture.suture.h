// Written by suturec from unit/large_values/picture.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. picture.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "unit/large_values/picture.h"

namespace large_values {

struct PictureSlot {
  suture::BoundedList<std::uint8_t, 1048576> pixels;
};

bool store(const Picture& value, PictureSlot& slot);
void load(const PictureSlot& slot, Picture& value);
void reserve(const PictureSlot*, Picture& value);

bool isValid(const PictureSlot& slot, suture::FieldPath* path);

// --- Gallery: the arguments of its commands ---

struct GalleryDimmedArguments {
  PictureSlot picture;
};

bool store(const Picture& picture, GalleryDimmedArguments& slot);

struct GalleryHangArguments {
  PictureSlot picture;
};

bool store(const Picture& picture, GalleryHangArguments& slot);

/// Numbers the commands of Gallery.
struct GalleryCommand {
  static constexpr std::uint16_t newest = 0;
  static constexpr std::uint16_t oldest = 1;
  static constexpr std::uint16_t dimmed = 2;
  static constexpr std::uint16_t hang = 3;
};

/// Numbers the events of Gallery.
struct GalleryEvent {
  static constexpr std::uint16_t hung = 0;
};

/// Numbers the reads of Gallery as a row of the state has them.
struct GalleryColumn {
  static constexpr std::uint16_t newest = 0;
  static constexpr std::uint16_t oldest = 1;
};

}  // namespace large_values

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const large_values::Picture& value);
template <>
Result<> decode(std::span<const std::byte> bytes, large_values::Picture& value);

template <>
const InterfaceInfo& interfaceInfo<large_values::Gallery>();

/// Calls large_values::Gallery of another component.
template <>
class Required<large_values::Gallery> : public RequiredBase {
  using Contract = large_values::Gallery;
  using Id = large_values::GalleryCommand;
  using EventId = large_values::GalleryEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::newest, large_values::PictureSlot> newest{*this, Id::newest};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::oldest, large_values::PictureSlot> oldest{*this, Id::oldest};
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::dimmed, large_values::GalleryDimmedArguments,
                       large_values::PictureSlot> dimmed{*this, Id::dimmed};
  /// Write: up to 2 wait.
  Command<&Contract::hang, large_values::GalleryHangArguments> hang{*this, Id::hang};

  /// Subscribes to the events of large_values::Gallery.
  struct Events {
    explicit Events(RequiredBase& required)
        : hung{required, EventId::hung} {}

    /// At a subscriber a newer one replaces the one that waits.
    Subscription<large_values::PictureSlot, large_values::Picture> hung;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves large_values::Gallery from a component.
template <>
class Provided<large_values::Gallery> : public ProvidedBase {
  using Contract = large_values::Gallery;
  using EventId = large_values::GalleryEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of large_values::Gallery.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : hung{provided, EventId::hung} {}

    Emitter<large_values::PictureSlot, large_values::Picture> hung;
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
    large_values::Picture dimmed_picture{};
    large_values::Picture hang_picture{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
