// Written by suturec from suture/standard/lifecycle.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "suture/standard/lifecycle.capnp.h"
#include "suture/standard/lifecycle.suture.h"

namespace suture {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::ComponentState wireComponentState(std::uint8_t slot) {
  switch (static_cast<ComponentState>(slot)) {
    case ComponentState::Constructed: return wire::ComponentState::CONSTRUCTED;
    case ComponentState::Configured: return wire::ComponentState::CONFIGURED;
    case ComponentState::Running: return wire::ComponentState::RUNNING;
    case ComponentState::Suspended: return wire::ComponentState::SUSPENDED;
    case ComponentState::Faulted: return wire::ComponentState::FAULTED;
    case ComponentState::Stopped: return wire::ComponentState::STOPPED;
  }
  return wire::ComponentState{};
}

suture::Errc fromWire(wire::ComponentState in, std::uint8_t& slot) {
  switch (in) {
    case wire::ComponentState::CONSTRUCTED: return slot =
        static_cast<std::uint8_t>(ComponentState::Constructed), suture::Errc{};
    case wire::ComponentState::CONFIGURED: return slot =
        static_cast<std::uint8_t>(ComponentState::Configured), suture::Errc{};
    case wire::ComponentState::RUNNING: return slot =
        static_cast<std::uint8_t>(ComponentState::Running), suture::Errc{};
    case wire::ComponentState::SUSPENDED: return slot =
        static_cast<std::uint8_t>(ComponentState::Suspended), suture::Errc{};
    case wire::ComponentState::FAULTED: return slot =
        static_cast<std::uint8_t>(ComponentState::Faulted), suture::Errc{};
    case wire::ComponentState::STOPPED: return slot =
        static_cast<std::uint8_t>(ComponentState::Stopped), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

wire::ResumeOutcome wireResumeOutcome(std::uint8_t slot) {
  switch (static_cast<ResumeOutcome>(slot)) {
    case ResumeOutcome::Resumed: return wire::ResumeOutcome::RESUMED;
    case ResumeOutcome::Asked: return wire::ResumeOutcome::ASKED;
    case ResumeOutcome::NoSuchInterface: return wire::ResumeOutcome::NO_SUCH_INTERFACE;
    case ResumeOutcome::NotConnected: return wire::ResumeOutcome::NOT_CONNECTED;
    case ResumeOutcome::NotAwaiting: return wire::ResumeOutcome::NOT_AWAITING;
    case ResumeOutcome::ProviderLost: return wire::ResumeOutcome::PROVIDER_LOST;
  }
  return wire::ResumeOutcome{};
}

suture::Errc fromWire(wire::ResumeOutcome in, std::uint8_t& slot) {
  switch (in) {
    case wire::ResumeOutcome::RESUMED: return slot =
        static_cast<std::uint8_t>(ResumeOutcome::Resumed), suture::Errc{};
    case wire::ResumeOutcome::ASKED: return slot =
        static_cast<std::uint8_t>(ResumeOutcome::Asked), suture::Errc{};
    case wire::ResumeOutcome::NO_SUCH_INTERFACE: return slot =
        static_cast<std::uint8_t>(ResumeOutcome::NoSuchInterface), suture::Errc{};
    case wire::ResumeOutcome::NOT_CONNECTED: return slot =
        static_cast<std::uint8_t>(ResumeOutcome::NotConnected), suture::Errc{};
    case wire::ResumeOutcome::NOT_AWAITING: return slot =
        static_cast<std::uint8_t>(ResumeOutcome::NotAwaiting), suture::Errc{};
    case wire::ResumeOutcome::PROVIDER_LOST: return slot =
        static_cast<std::uint8_t>(ResumeOutcome::ProviderLost), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const StateChangeSlot& slot, wire::StateChange::Builder out) {
  out.setState(wireComponentState(slot.state));
  toWire(slot.fault, out.initFault(sizeOf(slot.fault)));
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::StateChange::Reader in, StateChangeSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      fromWire(in.getState(), slot.state),
      fromWire(in.getFault(), slot.fault),
  });
}

// --- Lifecycle as Cap'n Proto

namespace {

void encodeLifecycleSuspendResult(const std::uint8_t& slot,
                                  wire::Lifecycle::SuspendResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeLifecycleSuspendResult(wire::Lifecycle::SuspendResults::Reader in,
                                          std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeLifecycleResumeResult(const std::uint8_t& slot,
                                 wire::Lifecycle::ResumeResults::Builder out) {
  out.setValue(slot != 0);
}
suture::Errc decodeLifecycleResumeResult(wire::Lifecycle::ResumeResults::Reader in,
                                         std::uint8_t& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeLifecycleComponentStateResult(const std::uint8_t& slot,
                                         wire::Lifecycle::ComponentStateResults::Builder out) {
  out.setValue(wireComponentState(slot));
}
suture::Errc decodeLifecycleComponentStateResult(wire::Lifecycle::ComponentStateResults::Reader in,
                                                 std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeLifecycleResumeConnection(const LifecycleResumeConnectionArguments& slot,
                                     wire::Lifecycle::ResumeConnectionParams::Builder out) {
  toWire(slot.required, out.initRequired(sizeOf(slot.required)));
}
suture::Errc decodeLifecycleResumeConnection(wire::Lifecycle::ResumeConnectionParams::Reader in,
                                             LifecycleResumeConnectionArguments& slot,
                                             suture::Duration) {
  return fromWire(in.getRequired(), slot.required);
}

void encodeLifecycleResumeConnectionResult(const std::uint8_t& slot,
                                           wire::Lifecycle::ResumeConnectionResults::Builder out) {
  out.setValue(wireResumeOutcome(slot));
}
suture::Errc decodeLifecycleResumeConnectionResult(
    wire::Lifecycle::ResumeConnectionResults::Reader in, std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeLifecycleStateChangedEvent(const StateChangeSlot& slot,
                                      wire::LifecycleEvents::StateChangedParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeLifecycleStateChangedEvent(wire::LifecycleEvents::StateChangedParams::Reader in,
                                              StateChangeSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeLifecycleComponentStateColumn(const std::uint8_t& slot,
                                         wire::LifecycleStateRow::Builder out) {
  out.setComponentState(wireComponentState(slot));
}
suture::Errc decodeLifecycleComponentStateColumn(wire::LifecycleStateRow::Reader in,
                                                 std::uint8_t& slot, suture::Duration) {
  return fromWire(in.getComponentState(), slot);
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeLifecycleColumn(unsigned column, const std::byte* memory,
                           wire::LifecycleStateRow::Builder out) {
  switch (column) {
    case LifecycleColumn::component_state:
      return encodeLifecycleComponentStateColumn(suture::slotIn<std::uint8_t>(memory), out);
  }
}
suture::Errc decodeLifecycleColumn(wire::LifecycleStateRow::Reader in, unsigned column,
                                   std::byte* memory, suture::Duration shift) {
  switch (column) {
    case LifecycleColumn::component_state:
      return decodeLifecycleComponentStateColumn(in, suture::newSlot<std::uint8_t>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kLifecycleCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Lifecycle>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Lifecycle::SuspendParams>,
     .result = suture::codec::messageOf<wire::Lifecycle::SuspendResults, std::uint8_t,
                                        encodeLifecycleSuspendResult,
                                        decodeLifecycleSuspendResult>},
    {.interface = capnp::typeId<wire::Lifecycle>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Lifecycle::ResumeParams>,
     .result = suture::codec::messageOf<wire::Lifecycle::ResumeResults, std::uint8_t,
                                        encodeLifecycleResumeResult, decodeLifecycleResumeResult>},
    {.interface = capnp::typeId<wire::Lifecycle>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Lifecycle::ComponentStateParams>,
     .result = suture::codec::messageOf<wire::Lifecycle::ComponentStateResults, std::uint8_t,
                                        encodeLifecycleComponentStateResult,
                                        decodeLifecycleComponentStateResult>,
     .stamp = suture::codec::stampIn<wire::Lifecycle::ComponentStateResults>},
    {.interface = capnp::typeId<wire::Lifecycle>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Lifecycle::ResumeConnectionParams>,
     .arguments = suture::codec::messageOf<wire::Lifecycle::ResumeConnectionParams,
                                           LifecycleResumeConnectionArguments,
                                           encodeLifecycleResumeConnection,
                                           decodeLifecycleResumeConnection>,
     .result = suture::codec::messageOf<wire::Lifecycle::ResumeConnectionResults, std::uint8_t,
                                        encodeLifecycleResumeConnectionResult,
                                        decodeLifecycleResumeConnectionResult>},
};

constexpr suture::codec::EventCodec kLifecycleEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::LifecycleEvents::StateChangedParams>,
     .payload = suture::codec::messageOf<wire::LifecycleEvents::StateChangedParams, StateChangeSlot,
                                         encodeLifecycleStateChangedEvent,
                                         decodeLifecycleStateChangedEvent>},
};

}  // namespace

const suture::codec::Codec& lifecycleCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Lifecycle>,
      .contract = capnp::typeId<wire::Lifecycle>(),
      .subscriber = capnp::typeId<wire::LifecycleEvents>(),
      .commands = kLifecycleCommandCodecs,
      .events = kLifecycleEventCodecs,
      .row = suture::codec::rowOf<wire::LifecycleEvents::StateParams, wire::LifecycleStateRow,
                                  encodeLifecycleColumn, decodeLifecycleColumn>,
  };
  return kCodec;
}

}  // namespace suture

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const suture::StateChange& value) {
  return codec::encodeAs<suture::wire::StateChange, suture::StateChangeSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, suture::StateChange& value) {
  return codec::decodeAs<suture::wire::StateChange, suture::StateChangeSlot>(bytes, value);
}

}  // namespace suture
