// Written by suturec from suture/standard/lifecycle.h. Do not edit.
#include "suture/standard/lifecycle.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace suture {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<ComponentState>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(ComponentState::Constructed) == 0);
static_assert(static_cast<std::uint8_t>(ComponentState::Configured) == 1);
static_assert(static_cast<std::uint8_t>(ComponentState::Running) == 2);
static_assert(static_cast<std::uint8_t>(ComponentState::Suspended) == 3);
static_assert(static_cast<std::uint8_t>(ComponentState::Faulted) == 4);
static_assert(static_cast<std::uint8_t>(ComponentState::Stopped) == 5);
static_assert(std::is_same_v<std::underlying_type_t<ResumeOutcome>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(ResumeOutcome::Resumed) == 0);
static_assert(static_cast<std::uint8_t>(ResumeOutcome::Asked) == 1);
static_assert(static_cast<std::uint8_t>(ResumeOutcome::NoSuchInterface) == 2);
static_assert(static_cast<std::uint8_t>(ResumeOutcome::NotConnected) == 3);
static_assert(static_cast<std::uint8_t>(ResumeOutcome::NotAwaiting) == 4);
static_assert(static_cast<std::uint8_t>(ResumeOutcome::ProviderLost) == 5);
static_assert(std::is_same_v<decltype(StateChange::state), ComponentState>);
static_assert(std::is_same_v<decltype(StateChange::fault), std::string>);
static_assert(std::is_same_v<decltype(StateChange::stamp), std::chrono::steady_clock::time_point>);

}  // namespace

bool store(const StateChange& value, StateChangeSlot& slot) {
  bool fits = true;
  fits &= store(value.state, slot.state);
  fits &= store(value.fault, slot.fault);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const StateChangeSlot& slot, StateChange& value) {
  load(slot.state, value.state);
  load(slot.fault, value.fault);
  load(slot.stamp, value.stamp);
}

void reserve(const StateChangeSlot*, StateChange& value) {
  suture::reserveFor<decltype(StateChangeSlot::fault)>(value.fault);
}

void shiftStamps(StateChangeSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const std::string& required, LifecycleResumeConnectionArguments& slot) {
  return store(required, slot.required);
}

bool isKnownComponentState(std::uint8_t slot) {
  switch (static_cast<ComponentState>(slot)) {
    case ComponentState::Constructed:
    case ComponentState::Configured:
    case ComponentState::Running:
    case ComponentState::Suspended:
    case ComponentState::Faulted:
    case ComponentState::Stopped:
      return true;
  }
  return false;
}

bool isKnownResumeOutcome(std::uint8_t slot) {
  switch (static_cast<ResumeOutcome>(slot)) {
    case ResumeOutcome::Resumed:
    case ResumeOutcome::Asked:
    case ResumeOutcome::NoSuchInterface:
    case ResumeOutcome::NotConnected:
    case ResumeOutcome::NotAwaiting:
    case ResumeOutcome::ProviderLost:
      return true;
  }
  return false;
}

bool isValid(const StateChangeSlot& slot, suture::FieldPath* path) {
  return isKnownComponentState(slot.state) || suture::refusedAt(path, "state");
}

// Defined in suture/standard/lifecycle.wire.cpp.
const suture::codec::Codec& lifecycleCodec();

namespace {

bool acceptsLifecycleComponentStateResult(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownComponentState(slot);
}

bool acceptsLifecycleResumeConnectionResult(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownResumeOutcome(slot);
}

constexpr suture::CommandInfo kLifecycleCommands[] = {
    {.name = "suspend",
     .kind = suture::CommandKind::VoidReturn,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16},
    {.name = "resume",
     .kind = suture::CommandKind::VoidReturn,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16},
    {.name = "component_state",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .column = LifecycleColumn::component_state,
     .acceptsResult = suture::checkSlot<std::uint8_t, acceptsLifecycleComponentStateResult>},
    {.name = "resume_connection",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<LifecycleResumeConnectionArguments>,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .acceptsResult = suture::checkSlot<std::uint8_t, acceptsLifecycleResumeConnectionResult>},
};

constexpr suture::BoundedLevel kLifecycleStateChangedPayloadLevels[] = {
    suture::levelAt<suture::BoundedText<255>>(offsetof(StateChangeSlot, fault)),
};

constexpr suture::EventInfo kLifecycleEvents[] = {
    {.name = "state_changed",
     .payloadSize = suture::slotSize<StateChangeSlot>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<StateChangeSlot, isValid>,
     .shiftPayload = suture::shiftSlot<StateChangeSlot>,
     .payloadLevels = kLifecycleStateChangedPayloadLevels},
};

// The self-description, as in suture/standard/lifecycle.suture.json.
constexpr char kLifecycleDescription[] = R"json(
{"name": "suture::Lifecycle",
"doc": "Lifecycle is the provided interface \"component\" of every component that a manager has. It is\nserved even while the component is suspended or faulted.",
"hash": "c0d761ea153a3e16ede74edeb40c58bf", "commands": [{"name": "suspend",
"kind": "void with return", "ordinal": 1,
"doc": "Suspends the component, which does nothing from its next cycle on. Returns false if it is not\nrunning.",
"result": {"type": {"kind": "Bool"}}, "queue": 16}, {"name": "resume", "kind": "void with return",
"ordinal": 2, "doc": "Lets the component go on. Returns false if it is not suspended.", "result": {
"type": {"kind": "Bool"}}, "queue": 16}, {"name": "component_state", "kind": "read", "ordinal": 3,
"wire": "componentState", "result": {"type": {"kind": "enum", "name": "suture::ComponentState"}},
"queue": 16}, {"name": "resume_connection", "kind": "write with return", "ordinal": 4,
"wire": "resumeConnection",
"doc": "Lets the commands of a required interface through again, which await their operator after a\nloss or a value that was too old.",
"parameters": [{"name": "required", "type": {"kind": "text", "capacity": 63}}], "result": {
"type": {"kind": "enum", "name": "suture::ResumeOutcome"}}, "queue": 16}], "events": [{
"name": "state_changed", "kind": "write", "ordinal": 1, "wire": "stateChanged",
"doc": "Reports each transition once, and the last one to a client that subscribes later.",
"payload": {"type": {"kind": "struct", "name": "suture::StateChange"}}, "queue": 16, "latched": true
}], "enums": [{"name": "suture::ComponentState", "underlying": "UInt8", "enumerators": [{
"name": "Constructed", "value": 0, "wire": "constructed"}, {"name": "Configured", "value": 1,
"wire": "configured"}, {"name": "Running", "value": 2, "wire": "running"}, {"name": "Suspended",
"value": 3, "wire": "suspended",
"doc": "keeps its thread and its connections, and only waits for resume"}, {"name": "Faulted",
"value": 4, "wire": "faulted",
"doc": "a handler or hook threw; the end of this component, not of its process"}, {
"name": "Stopped", "value": 5, "wire": "stopped"}]}, {"name": "suture::ResumeOutcome",
"doc": "Says what became of a request to let the commands of a connection through again.",
"underlying": "UInt8", "enumerators": [{"name": "Resumed", "value": 0, "wire": "resumed"}, {
"name": "Asked", "value": 1, "wire": "asked",
"doc": "of a device: it happens when it uses the connection next, unless that is lost then"}, {
"name": "NoSuchInterface", "value": 2, "wire": "noSuchInterface",
"doc": "the component requires none of that name"}, {"name": "NotConnected", "value": 3,
"wire": "notConnected"}, {"name": "NotAwaiting", "value": 4, "wire": "notAwaiting",
"doc": "it awaits no operator, so nothing has to be done"}, {"name": "ProviderLost", "value": 5,
"wire": "providerLost", "doc": "or it is suspended or faulted: a connection to it cannot be resumed"
}]}], "structs": [{"name": "suture::StateChange",
"doc": "Says that a component has come into a state.", "fields": [{"name": "state", "type": {
"kind": "enum", "name": "suture::ComponentState"}, "default": "Constructed"}, {"name": "fault",
"doc": "The component threw this, if the state is Faulted; the end of the text may be cut off.",
"type": {"kind": "text", "capacity": 255}}, {"name": "stamp", "type": {"kind": "time",
"clock": "steady"}}]}], "wire": [{"id": "@0xc0c56c9588a77b40", "kind": "interface",
"name": "Lifecycle", "cxx": "suture::Lifecycle", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xa4c750cb89591cca"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "suspend", "is": "kind \"voidReturn\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Bool"}]}, {"at": 2,
"name": "resume", "is": "kind \"voidReturn\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Bool"}]}, {"at": 3,
"name": "componentState", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0x8e5bed957aeeb624"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4, "name": "resumeConnection",
"is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "required", "is": "Text"}, {"at": 1,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0xc2c9babc8f01c05f"}]}]}, {"id": "@0xa4c750cb89591cca", "kind": "interface",
"name": "LifecycleEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xf777f0543682aa19"}]}, {"at": 1, "name": "stateChanged", "parameters": [{
"at": 0, "name": "value", "is": "@0x94110f1e97b939a5"}, {"at": 1, "name": "stamp", "is": "Int64"}]}
]}, {"id": "@0xf777f0543682aa19", "kind": "struct", "name": "LifecycleStateRow", "members": [{
"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "componentState", "is": "@0x8e5bed957aeeb624"
}]}, {"id": "@0x8e5bed957aeeb624", "kind": "enum", "name": "ComponentState", "members": [{"at": 0,
"name": "constructed"}, {"at": 1, "name": "configured"}, {"at": 2, "name": "running"}, {"at": 3,
"name": "suspended"}, {"at": 4, "name": "faulted"}, {"at": 5, "name": "stopped"}]}, {
"id": "@0x94110f1e97b939a5", "kind": "struct", "name": "StateChange", "members": [{"at": 0,
"name": "state", "is": "@0x8e5bed957aeeb624"}, {"at": 1, "name": "fault", "is": "Text"}, {"at": 2,
"name": "stamp", "is": "Int64 clock \"steady\""}]}, {"id": "@0xc2c9babc8f01c05f", "kind": "enum",
"name": "ResumeOutcome", "members": [{"at": 0, "name": "resumed"}, {"at": 1, "name": "asked"}, {
"at": 2, "name": "noSuchInterface"}, {"at": 3, "name": "notConnected"}, {"at": 4,
"name": "notAwaiting"}, {"at": 5, "name": "providerLost"}]}]})json";

}  // namespace
}  // namespace suture

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<suture::Lifecycle>() {
  static constexpr InterfaceInfo kInfo{
      .name = "suture::Lifecycle",
      .hash = "c0d761ea153a3e16ede74edeb40c58bf",
      .description = suture::kLifecycleDescription,
      .commands = suture::kLifecycleCommands,
      .events = suture::kLifecycleEvents,
      .codec = &suture::lifecycleCodec,
  };
  return kInfo;
}

auto Provided<suture::Lifecycle>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(suture::LifecycleResumeConnectionArguments::required)>(
      scratch.resume_connection_required);
  return scratch;
}

// A function for each command of suture::Lifecycle, so that a stack in a debugger names it.
struct Provided<suture::Lifecycle>::Dispatch {
  static Errc execute_suspend(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint8_t>(result);
    return store(implementation.suspend(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_resume(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint8_t>(result);
    return store(implementation.resume(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_component_state(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint8_t>(result);
    return store(implementation.component_state(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_resume_connection(Contract& implementation, Scratch& scratch,
                                        const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<suture::LifecycleResumeConnectionArguments>(arguments);
    load(slot.required, scratch.resume_connection_required);
    auto& answer = newSlot<std::uint8_t>(result);
    return store(implementation.resume_connection(scratch.resume_connection_required), answer)
        ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<suture::Lifecycle>::execute(std::uint16_t command, const std::byte* arguments,
                                          std::byte* result) {
  using ::suture::LifecycleCommand;
  switch (command) {
    case LifecycleCommand::suspend: return Dispatch::execute_suspend(implementation_, result);
    case LifecycleCommand::resume: return Dispatch::execute_resume(implementation_, result);
    case LifecycleCommand::component_state:
      return Dispatch::execute_component_state(implementation_, result);
    case LifecycleCommand::resume_connection:
      return Dispatch::execute_resume_connection(implementation_, scratch_, arguments, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
