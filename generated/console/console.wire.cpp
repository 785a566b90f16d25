// Written by suturec from console/console.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "console/console.capnp.h"
#include "console/console.suture.h"

// Defined in suture/standard/messages.wire.cpp.
namespace suture {
void toWire(const MessageSlot& slot, wire::Message::Builder out);
suture::Errc fromWire(wire::Message::Reader in, MessageSlot& slot, suture::Duration shift);
}  // namespace suture

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::ConsoleState wireConsoleState(std::uint8_t slot) {
  switch (static_cast<ConsoleState>(slot)) {
    case ConsoleState::Down: return wire::ConsoleState::DOWN;
    case ConsoleState::Enabling: return wire::ConsoleState::ENABLING;
    case ConsoleState::Homing: return wire::ConsoleState::HOMING;
    case ConsoleState::Up: return wire::ConsoleState::UP;
    case ConsoleState::Incomplete: return wire::ConsoleState::INCOMPLETE;
    case ConsoleState::Leaving: return wire::ConsoleState::LEAVING;
  }
  return wire::ConsoleState{};
}

suture::Errc fromWire(wire::ConsoleState in, std::uint8_t& slot) {
  switch (in) {
    case wire::ConsoleState::DOWN: return slot =
        static_cast<std::uint8_t>(ConsoleState::Down), suture::Errc{};
    case wire::ConsoleState::ENABLING: return slot =
        static_cast<std::uint8_t>(ConsoleState::Enabling), suture::Errc{};
    case wire::ConsoleState::HOMING: return slot =
        static_cast<std::uint8_t>(ConsoleState::Homing), suture::Errc{};
    case wire::ConsoleState::UP: return slot =
        static_cast<std::uint8_t>(ConsoleState::Up), suture::Errc{};
    case wire::ConsoleState::INCOMPLETE: return slot =
        static_cast<std::uint8_t>(ConsoleState::Incomplete), suture::Errc{};
    case wire::ConsoleState::LEAVING: return slot =
        static_cast<std::uint8_t>(ConsoleState::Leaving), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

wire::SystemUse wireSystemUse(std::uint8_t slot) {
  switch (static_cast<SystemUse>(slot)) {
    case SystemUse::Unknown: return wire::SystemUse::UNKNOWN;
    case SystemUse::Unused: return wire::SystemUse::UNUSED;
    case SystemUse::Used: return wire::SystemUse::USED;
  }
  return wire::SystemUse{};
}

suture::Errc fromWire(wire::SystemUse in, std::uint8_t& slot) {
  switch (in) {
    case wire::SystemUse::UNKNOWN: return slot =
        static_cast<std::uint8_t>(SystemUse::Unknown), suture::Errc{};
    case wire::SystemUse::UNUSED: return slot =
        static_cast<std::uint8_t>(SystemUse::Unused), suture::Errc{};
    case wire::SystemUse::USED: return slot =
        static_cast<std::uint8_t>(SystemUse::Used), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

// --- Console as Cap'n Proto

namespace {

void encodeConsoleConsoleStateResult(const std::uint8_t& slot,
                                     wire::Console::ConsoleStateResults::Builder out) {
  out.setValue(wireConsoleState(slot));
}
suture::Errc decodeConsoleConsoleStateResult(wire::Console::ConsoleStateResults::Reader in,
                                             std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeConsoleStatusEvent(const suture::MessageSlot& slot,
                              wire::ConsoleEvents::StatusParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeConsoleStatusEvent(wire::ConsoleEvents::StatusParams::Reader in,
                                      suture::MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeConsoleWarningEvent(const suture::MessageSlot& slot,
                               wire::ConsoleEvents::WarningParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeConsoleWarningEvent(wire::ConsoleEvents::WarningParams::Reader in,
                                       suture::MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeConsoleErrorEvent(const suture::MessageSlot& slot,
                             wire::ConsoleEvents::ErrorParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeConsoleErrorEvent(wire::ConsoleEvents::ErrorParams::Reader in,
                                     suture::MessageSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeConsoleConsoleStateEvent(const std::uint8_t& slot,
                                    wire::ConsoleEvents::ConsoleStateParams::Builder out) {
  out.setValue(wireConsoleState(slot));
}
suture::Errc decodeConsoleConsoleStateEvent(wire::ConsoleEvents::ConsoleStateParams::Reader in,
                                            std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeConsoleSystemUseEvent(const std::uint8_t& slot,
                                 wire::ConsoleEvents::SystemUseParams::Builder out) {
  out.setValue(wireSystemUse(slot));
}
suture::Errc decodeConsoleSystemUseEvent(wire::ConsoleEvents::SystemUseParams::Reader in,
                                         std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeConsoleConsoleStateColumn(const std::uint8_t& slot, wire::ConsoleStateRow::Builder out) {
  out.setConsoleState(wireConsoleState(slot));
}
suture::Errc decodeConsoleConsoleStateColumn(wire::ConsoleStateRow::Reader in, std::uint8_t& slot,
                                             suture::Duration) {
  return fromWire(in.getConsoleState(), slot);
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeConsoleColumn(unsigned column, const std::byte* memory,
                         wire::ConsoleStateRow::Builder out) {
  switch (column) {
    case ConsoleColumn::console_state:
      return encodeConsoleConsoleStateColumn(suture::slotIn<std::uint8_t>(memory), out);
  }
}
suture::Errc decodeConsoleColumn(wire::ConsoleStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case ConsoleColumn::console_state:
      return decodeConsoleConsoleStateColumn(in, suture::newSlot<std::uint8_t>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kConsoleCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Console>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Console::BringUpParams>},
    {.interface = capnp::typeId<wire::Console>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Console::BringDownParams>},
    {.interface = capnp::typeId<wire::Console>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Console::ConsoleStateParams>,
     .result = suture::codec::messageOf<wire::Console::ConsoleStateResults, std::uint8_t,
                                        encodeConsoleConsoleStateResult,
                                        decodeConsoleConsoleStateResult>,
     .stamp = suture::codec::stampIn<wire::Console::ConsoleStateResults>},
};

constexpr suture::codec::EventCodec kConsoleEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::ConsoleEvents::StatusParams>,
     .payload = suture::codec::messageOf<wire::ConsoleEvents::StatusParams, suture::MessageSlot,
                                         encodeConsoleStatusEvent, decodeConsoleStatusEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::ConsoleEvents::WarningParams>,
     .payload = suture::codec::messageOf<wire::ConsoleEvents::WarningParams, suture::MessageSlot,
                                         encodeConsoleWarningEvent, decodeConsoleWarningEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::ConsoleEvents::ErrorParams>,
     .payload = suture::codec::messageOf<wire::ConsoleEvents::ErrorParams, suture::MessageSlot,
                                         encodeConsoleErrorEvent, decodeConsoleErrorEvent>},
    {.method = 4,
     .stamp = suture::codec::stampIn<wire::ConsoleEvents::ConsoleStateParams>,
     .payload = suture::codec::messageOf<wire::ConsoleEvents::ConsoleStateParams, std::uint8_t,
                                         encodeConsoleConsoleStateEvent,
                                         decodeConsoleConsoleStateEvent>},
    {.method = 5,
     .stamp = suture::codec::stampIn<wire::ConsoleEvents::SystemUseParams>,
     .payload = suture::codec::messageOf<wire::ConsoleEvents::SystemUseParams, std::uint8_t,
                                         encodeConsoleSystemUseEvent, decodeConsoleSystemUseEvent>},
};

}  // namespace

const suture::codec::Codec& consoleCodec() {
  static const suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Console>,
      .contract = capnp::typeId<wire::Console>(),
      .subscriber = capnp::typeId<wire::ConsoleEvents>(),
      .commands = kConsoleCommandCodecs,
      .events = kConsoleEventCodecs,
      .row = suture::codec::rowOf<wire::ConsoleEvents::StateParams, wire::ConsoleStateRow,
                                  encodeConsoleColumn, decodeConsoleColumn>,
  };
  return kCodec;
}

}  // namespace robots
