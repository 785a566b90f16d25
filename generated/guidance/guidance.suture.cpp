// Written by suturec from guidance/guidance.h. Do not edit.
#include "guidance/guidance.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<GuidanceState>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(GuidanceState::Preparing) == 0);
static_assert(static_cast<std::uint8_t>(GuidanceState::Blind) == 1);
static_assert(static_cast<std::uint8_t>(GuidanceState::Guiding) == 2);
static_assert(static_cast<std::uint8_t>(GuidanceState::Disabled) == 3);
static_assert(static_cast<std::uint8_t>(GuidanceState::Clutched) == 4);
static_assert(std::is_same_v<decltype(GuidanceProgress::knot), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(GuidanceProgress::distance_to_target), double>);
static_assert(std::is_same_v<decltype(GuidanceProgress::lateral_error), double>);
static_assert(std::is_same_v<decltype(GuidanceProgress::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(GuidanceProgress::valid), bool>);
static_assert(std::is_same_v<decltype(ForbiddenMotion::left), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(ForbiddenMotion::right), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(ForbiddenMotion::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(ForbiddenMotion::valid), bool>);

}  // namespace

bool store(const GuidanceProgress& value, GuidanceProgressSlot& slot) {
  bool fits = true;
  fits &= store(value.knot, slot.knot);
  fits &= store(value.distance_to_target, slot.distance_to_target);
  fits &= store(value.lateral_error, slot.lateral_error);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const GuidanceProgressSlot& slot, GuidanceProgress& value) {
  load(slot.knot, value.knot);
  load(slot.distance_to_target, value.distance_to_target);
  load(slot.lateral_error, value.lateral_error);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(GuidanceProgressSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const ForbiddenMotion& value, ForbiddenMotionSlot& slot) {
  bool fits = true;
  fits &= store(value.left, slot.left);
  fits &= store(value.right, slot.right);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const ForbiddenMotionSlot& slot, ForbiddenMotion& value) {
  load(slot.left, value.left);
  load(slot.right, value.right);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(ForbiddenMotionSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isKnownGuidanceState(std::uint8_t slot) {
  switch (static_cast<GuidanceState>(slot)) {
    case GuidanceState::Preparing:
    case GuidanceState::Blind:
    case GuidanceState::Guiding:
    case GuidanceState::Disabled:
    case GuidanceState::Clutched:
      return true;
  }
  return false;
}

bool isValid(const GuidanceProgressSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.knot, path)) return suture::refusedAt(path, "knot");
  if (!isValid(slot.distance_to_target)) return suture::refusedAt(path, "distance_to_target");
  return isValid(slot.lateral_error) || suture::refusedAt(path, "lateral_error");
}

bool isValid(const ForbiddenMotionSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.left, path)) return suture::refusedAt(path, "left");
  return isValid(slot.right, path) || suture::refusedAt(path, "right");
}

// Defined in guidance/guidance.wire.cpp.
const suture::codec::Codec& guidanceCodec();

namespace {

bool acceptsGuidanceGuidanceStateResult(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownGuidanceState(slot);
}

bool acceptsGuidanceGuidanceStateEvent(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownGuidanceState(slot);
}

constexpr suture::CommandInfo kGuidanceCommands[] = {
    {.name = "guidance_state",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .column = GuidanceColumn::guidance_state,
     .acceptsResult = suture::checkSlot<std::uint8_t, acceptsGuidanceGuidanceStateResult>},
    {.name = "progress",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<GuidanceProgressSlot>,
     .depth = 16,
     .column = GuidanceColumn::progress,
     .acceptsResult = suture::checkSlot<GuidanceProgressSlot, isValid>,
     .shiftResult = suture::shiftSlot<GuidanceProgressSlot>},
    {.name = "enable", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "disable", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "forbidden_motion",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<ForbiddenMotionSlot>,
     .depth = 16,
     .column = GuidanceColumn::forbidden_motion,
     .acceptsResult = suture::checkSlot<ForbiddenMotionSlot, isValid>,
     .shiftResult = suture::shiftSlot<ForbiddenMotionSlot>},
};

constexpr suture::EventInfo kGuidanceEvents[] = {
    {.name = "guidance_state",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<std::uint8_t, acceptsGuidanceGuidanceStateEvent>},
};

// The self-description, as in guidance/guidance.suture.json.
constexpr char kGuidanceDescription[] = R"json(
{"name": "robots::Guidance",
"doc": "Commands run in the guide's own thread before its next cycle; reads are from the end of its last\none.",
"hash": "fb18264ead73a4cc3d2071390378f5a9", "commands": [{"name": "guidance_state", "kind": "read",
"ordinal": 1, "wire": "guidanceState", "result": {"type": {"kind": "enum",
"name": "robots::GuidanceState"}}, "queue": 16}, {"name": "progress", "kind": "read", "ordinal": 2,
"doc": "The guide updates this even while it waits for something, as far as the knot has been seen.",
"result": {"type": {"kind": "struct", "name": "robots::GuidanceProgress"}}, "queue": 16}, {
"name": "enable", "kind": "void", "ordinal": 3,
"doc": "Enables and homes arms that are not, then guides. This also works after an arm was disabled or\nrestarted. It does not enable an arm in FAULT: the operator who has removed the cause does.",
"queue": 16}, {"name": "disable", "kind": "void", "ordinal": 4,
"doc": "Stops guiding. Both slaves hold.", "queue": 16}, {"name": "forbidden_motion",
"kind": "read", "ordinal": 5, "wire": "forbiddenMotion",
"doc": "A client at the masters makes hands feel this, as components/force_feedback says.",
"result": {"type": {"kind": "struct", "name": "robots::ForbiddenMotion"}}, "queue": 16}],
"events": [{"name": "guidance_state", "kind": "write", "ordinal": 1, "wire": "guidanceState",
"doc": "Reports each change, and the last one to a client that connects.", "payload": {"type": {
"kind": "enum", "name": "robots::GuidanceState"}}, "queue": 16, "latched": true}], "enums": [{
"name": "robots::GuidanceState", "underlying": "UInt8", "enumerators": [{"name": "Preparing",
"value": 0, "wire": "preparing",
"doc": "waits for the registration, and for all four arms: connected, enabled, homed,\nfresh data of each, and slaves that take goals"
}, {"name": "Blind", "value": 1, "wire": "blind",
"doc": "the arms are ready, but nobody has seen the knot lately; both slaves hold"}, {
"name": "Guiding", "value": 2, "wire": "guiding"}, {"name": "Disabled", "value": 3,
"wire": "disabled",
"doc": "until enable(); also since a slave refused its goals for a reason that stays"}, {
"name": "Clutched", "value": 4, "wire": "clutched",
"doc": "a pedal takes the masters from their slaves, or nobody is at the console: both\nslaves hold, and the masters are the surgeon's to move"
}]}], "structs": [{"name": "robots::GuidanceProgress", "fields": [{"name": "knot",
"doc": "The knot is here by the last sighting and by what the tips have moved since, in the scene.",
"type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}, "unit": "m"}, {
"name": "distance_to_target", "wire": "distanceToTarget",
"doc": "The knot has this distance to go along the line of approach; it is below zero behind the\ntarget.",
"type": {"kind": "Float64"}, "unit": "m", "default": 0.0}, {"name": "lateral_error",
"wire": "lateralError", "doc": "The knot has this distance from the line of approach.", "type": {
"kind": "Float64"}, "unit": "m", "default": 0.0}, {"name": "stamp",
"doc": "The stamp is that of the guide's cycle.", "type": {"kind": "time", "clock": "steady"}}, {
"name": "valid", "doc": "This is false unless the knot has been seen lately.", "type": {
"kind": "Bool"}, "default": false}]}, {"name": "robots::ForbiddenMotion",
"doc": "Says how fast the hands lead each tip where the fixtures let none go, in the scene: what a hand\nshould feel of them. What a fixture only delays is not in it.",
"fields": [{"name": "left", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1
}, "unit": "m/s"}, {"name": "right", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}, "unit": "m/s"}, {"name": "stamp", "doc": "The stamp is that of the guide's cycle.",
"type": {"kind": "time", "clock": "steady"}}, {"name": "valid",
"doc": "This is false while the guide does not guide.", "type": {"kind": "Bool"}, "default": false}
]}], "wire": [{"id": "@0xf839a0ec32e2aeaf", "kind": "interface", "name": "Guidance",
"cxx": "robots::Guidance", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xf87738b35a660df1"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "guidanceState",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0x909952bd3e04c1b4"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 2, "name": "progress", "is": "kind \"read\"", "parameters": [{"at": 0,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "@0xb62a9e40cb04e11e"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 3,
"name": "enable", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 4, "name": "disable", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 5,
"name": "forbiddenMotion", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xae50c2ec0f36c217"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xf87738b35a660df1", "kind": "interface",
"name": "GuidanceEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xaa6c5932ff7a6316"}]}, {"at": 1, "name": "guidanceState", "parameters": [{
"at": 0, "name": "value", "is": "@0x909952bd3e04c1b4"}, {"at": 1, "name": "stamp", "is": "Int64"}]}
]}, {"id": "@0xaa6c5932ff7a6316", "kind": "struct", "name": "GuidanceStateRow", "members": [{
"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "guidanceState", "is": "@0x909952bd3e04c1b4"
}, {"at": 4, "name": "progress", "is": "@0xb62a9e40cb04e11e"}, {"at": 5, "name": "forbiddenMotion",
"is": "@0xae50c2ec0f36c217"}]}, {"id": "@0x909952bd3e04c1b4", "kind": "enum",
"name": "GuidanceState", "members": [{"at": 0, "name": "preparing"}, {"at": 1, "name": "blind"}, {
"at": 2, "name": "guiding"}, {"at": 3, "name": "disabled"}, {"at": 4, "name": "clutched"}]}, {
"id": "@0xb62a9e40cb04e11e", "kind": "struct", "name": "GuidanceProgress", "members": [{"at": 0,
"name": "knot", "is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 3, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 4, "name": "valid", "is": "Bool"}, {"at": 5,
"name": "distanceToTarget", "is": "Float64 unit \"m\""}, {"at": 6, "name": "lateralError",
"is": "Float64 unit \"m\""}]}, {"id": "@0xae50c2ec0f36c217", "kind": "struct",
"name": "ForbiddenMotion", "members": [{"at": 0, "name": "left",
"is": "/suture/types.capnp:Vec3 unit \"m/s\""}, {"at": 1, "name": "right",
"is": "/suture/types.capnp:Vec3 unit \"m/s\""}, {"at": 2, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 3, "name": "valid", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Guidance>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::Guidance",
      .hash = "fb18264ead73a4cc3d2071390378f5a9",
      .description = robots::kGuidanceDescription,
      .commands = robots::kGuidanceCommands,
      .events = robots::kGuidanceEvents,
      .codec = &robots::guidanceCodec,
  };
  return kInfo;
}

// A function for each command of robots::Guidance, so that a stack in a debugger names it.
struct Provided<robots::Guidance>::Dispatch {
  static Errc execute_guidance_state(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint8_t>(result);
    return store(implementation.guidance_state(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_progress(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::GuidanceProgressSlot>(result);
    return store(implementation.progress(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_enable(Contract& implementation) {
    implementation.enable();
    return Errc{};
  }

  static Errc execute_disable(Contract& implementation) {
    implementation.disable();
    return Errc{};
  }

  static Errc execute_forbidden_motion(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::ForbiddenMotionSlot>(result);
    return store(implementation.forbidden_motion(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::Guidance>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                         std::byte* result) {
  using ::robots::GuidanceCommand;
  switch (command) {
    case GuidanceCommand::guidance_state:
      return Dispatch::execute_guidance_state(implementation_, result);
    case GuidanceCommand::progress: return Dispatch::execute_progress(implementation_, result);
    case GuidanceCommand::enable: return Dispatch::execute_enable(implementation_);
    case GuidanceCommand::disable: return Dispatch::execute_disable(implementation_);
    case GuidanceCommand::forbidden_motion:
      return Dispatch::execute_forbidden_motion(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
