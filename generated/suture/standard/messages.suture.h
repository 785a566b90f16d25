// Written by suturec from suture/standard/messages.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. messages.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "suture/standard/messages.h"

namespace suture {

struct MessageSlot {
  suture::BoundedText<255> text;
  std::uint32_t code;
  std::uint32_t counter;
  std::int64_t stamp;  // suture::Time, ns
};

bool store(const Message& value, MessageSlot& slot);
void load(const MessageSlot& slot, Message& value);
void reserve(const MessageSlot*, Message& value);
void shiftStamps(MessageSlot& slot, suture::Duration shift);

bool isValid(const MessageSlot& slot, suture::FieldPath* path);

/// Numbers the events of Messages.
struct MessagesEvent {
  static constexpr std::uint16_t status = 0;
  static constexpr std::uint16_t warning = 1;
  static constexpr std::uint16_t error = 2;
};

}  // namespace suture

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const suture::Message& value);
template <>
Result<> decode(std::span<const std::byte> bytes, suture::Message& value);

template <>
const InterfaceInfo& interfaceInfo<suture::Messages>();

/// Calls suture::Messages of another component.
template <>
class Required<suture::Messages> : public RequiredBase {
  using Contract = suture::Messages;
  using EventId = suture::MessagesEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Subscribes to the events of suture::Messages.
  struct Events {
    explicit Events(RequiredBase& required)
        : status{required, EventId::status},
          warning{required, EventId::warning},
          error{required, EventId::error} {}

    /// Reports that something has been done, and nothing is wrong.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<MessageSlot, Message> status;
    /// Reports that something was refused, or is not as it should be; the component goes on.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<MessageSlot, Message> warning;
    /// Reports that something failed, and needs somebody's attention.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<MessageSlot, Message> error;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves suture::Messages from a component.
template <>
class Provided<suture::Messages> : public ProvidedBase {
  using Contract = suture::Messages;
  using EventId = suture::MessagesEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of suture::Messages.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : status{provided, EventId::status},
          warning{provided, EventId::warning},
          error{provided, EventId::error} {}

    /// Reports that something has been done, and nothing is wrong.
    Emitter<MessageSlot, Message> status;
    /// Reports that something was refused, or is not as it should be; the component goes on.
    Emitter<MessageSlot, Message> warning;
    /// Reports that something failed, and needs somebody's attention.
    Emitter<MessageSlot, Message> error;
  };
  Events& emit() { return events_; }

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& /*implementation*/)
      : ProvidedBase(owner, name, info, whole) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  Events events_{*this};
};

}  // namespace suture
