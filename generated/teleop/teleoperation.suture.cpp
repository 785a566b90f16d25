// Written by suturec from teleop/teleoperation.h. Do not edit.
#include "teleop/teleoperation.suture.h"

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
static_assert(std::is_same_v<std::underlying_type_t<TeleopState>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(TeleopState::Disabled) == 0);
static_assert(static_cast<std::uint8_t>(TeleopState::Preparing) == 1);
static_assert(static_cast<std::uint8_t>(TeleopState::Following) == 2);
static_assert(static_cast<std::uint8_t>(TeleopState::Aligning) == 3);
static_assert(static_cast<std::uint8_t>(TeleopState::Clutched) == 4);
static_assert(std::is_same_v<decltype(FollowAnchors::master_stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(FollowAnchors::master), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(FollowAnchors::slave_setpoint), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(FollowAnchors::scale), double>);
static_assert(std::is_same_v<decltype(FollowAnchors::entry), std::uint64_t>);
static_assert(std::is_same_v<decltype(FollowAnchors::view), Eigen::Matrix3d>);
static_assert(std::is_same_v<decltype(FollowAnchors::rotation_locked), bool>);
static_assert(std::is_same_v<decltype(FollowAnchors::translation_locked), bool>);
static_assert(std::is_same_v<decltype(TeleopSettings::scale), double>);
static_assert(std::is_same_v<decltype(TeleopSettings::rotation_locked), bool>);
static_assert(std::is_same_v<decltype(TeleopSettings::translation_locked), bool>);

}  // namespace

bool store(const FollowAnchors& value, FollowAnchorsSlot& slot) {
  bool fits = true;
  fits &= store(value.master_stamp, slot.master_stamp);
  fits &= store(value.master, slot.master);
  fits &= store(value.slave_setpoint, slot.slave_setpoint);
  fits &= store(value.scale, slot.scale);
  fits &= store(value.entry, slot.entry);
  fits &= store(value.view, slot.view);
  fits &= store(value.rotation_locked, slot.rotation_locked);
  fits &= store(value.translation_locked, slot.translation_locked);
  return fits;
}

void load(const FollowAnchorsSlot& slot, FollowAnchors& value) {
  load(slot.master_stamp, value.master_stamp);
  load(slot.master, value.master);
  load(slot.slave_setpoint, value.slave_setpoint);
  load(slot.scale, value.scale);
  load(slot.entry, value.entry);
  load(slot.view, value.view);
  load(slot.rotation_locked, value.rotation_locked);
  load(slot.translation_locked, value.translation_locked);
}

void shiftStamps(FollowAnchorsSlot& slot, suture::Duration shift) {
  slot.master_stamp = suture::codec::shifted(slot.master_stamp, shift);
}

bool store(const TeleopSettings& value, TeleopSettingsSlot& slot) {
  bool fits = true;
  fits &= store(value.scale, slot.scale);
  fits &= store(value.rotation_locked, slot.rotation_locked);
  fits &= store(value.translation_locked, slot.translation_locked);
  return fits;
}

void load(const TeleopSettingsSlot& slot, TeleopSettings& value) {
  load(slot.scale, value.scale);
  load(slot.rotation_locked, value.rotation_locked);
  load(slot.translation_locked, value.translation_locked);
}

bool store(const double& scale, TeleoperationSetScaleArguments& slot) {
  return store(scale, slot.scale);
}

bool store(const bool& lock, TeleoperationLockRotationArguments& slot) {
  return store(lock, slot.lock);
}

bool store(const bool& lock, TeleoperationLockTranslationArguments& slot) {
  return store(lock, slot.lock);
}

bool isKnownTeleopState(std::uint8_t slot) {
  switch (static_cast<TeleopState>(slot)) {
    case TeleopState::Disabled:
    case TeleopState::Preparing:
    case TeleopState::Following:
    case TeleopState::Aligning:
    case TeleopState::Clutched:
      return true;
  }
  return false;
}

bool isValid(const FollowAnchorsSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.master)) return suture::refusedAt(path, "master");
  if (!isValid(slot.slave_setpoint)) return suture::refusedAt(path, "slave_setpoint");
  if (!isValid(slot.scale)) return suture::refusedAt(path, "scale");
  return isValid(slot.view) || suture::refusedAt(path, "view");
}

bool isValid(const TeleopSettingsSlot& slot, suture::FieldPath* path) {
  return isValid(slot.scale) || suture::refusedAt(path, "scale");
}

// Defined in teleop/teleoperation.wire.cpp.
const suture::codec::Codec& teleoperationCodec();

namespace {

bool acceptsTeleoperationTeleopStateResult(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownTeleopState(slot);
}

bool acceptsTeleoperationSetScale(const TeleoperationSetScaleArguments& slot,
                                  suture::FieldPath* path) {
  return suture::inRange(slot.scale, 0.01, 10) || suture::refusedAt(path, "scale");
}

bool acceptsTeleoperationTeleopStateEvent(const std::uint8_t& slot, suture::FieldPath*) {
  return isKnownTeleopState(slot);
}

constexpr suture::CommandInfo kTeleoperationCommands[] = {
    {.name = "enable", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "disable", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "teleop_state",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .column = TeleoperationColumn::teleop_state,
     .acceptsResult = suture::checkSlot<std::uint8_t, acceptsTeleoperationTeleopStateResult>},
    {.name = "anchors",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<FollowAnchorsSlot>,
     .depth = 16,
     .column = TeleoperationColumn::anchors,
     .acceptsResult = suture::checkSlot<FollowAnchorsSlot, isValid>,
     .shiftResult = suture::shiftSlot<FollowAnchorsSlot>},
    {.name = "set_scale",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<TeleoperationSetScaleArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<TeleoperationSetScaleArguments, acceptsTeleoperationSetScale>},
    {.name = "lock_rotation",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<TeleoperationLockRotationArguments>,
     .depth = 16},
    {.name = "lock_translation",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<TeleoperationLockTranslationArguments>,
     .depth = 16},
    {.name = "settings",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<TeleopSettingsSlot>,
     .depth = 16,
     .column = TeleoperationColumn::settings,
     .acceptsResult = suture::checkSlot<TeleopSettingsSlot, isValid>},
};

constexpr suture::EventInfo kTeleoperationEvents[] = {
    {.name = "teleop_state",
     .payloadSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<std::uint8_t, acceptsTeleoperationTeleopStateEvent>},
    {.name = "followed",
     .payloadSize = suture::slotSize<FollowAnchorsSlot>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<FollowAnchorsSlot, isValid>,
     .shiftPayload = suture::shiftSlot<FollowAnchorsSlot>},
    {.name = "settings",
     .payloadSize = suture::slotSize<TeleopSettingsSlot>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<TeleopSettingsSlot, isValid>},
};

// The self-description, as in teleop/teleoperation.suture.json.
constexpr char kTeleoperationDescription[] = R"json(
{"name": "robots::Teleoperation",
"doc": "Commands run in the teleoperation's own thread before its next cycle. A change of the settings\nwhile it follows does not move the slave: it follows from where it is.",
"hash": "ce8c110f1e23bc0acf8dc69700b6dfa0", "commands": [{"name": "enable", "kind": "void",
"ordinal": 1,
"doc": "Enables and homes arms that are not, then follows. It does not enable an arm in FAULT: the\noperator who has removed the cause does.",
"queue": 16}, {"name": "disable", "kind": "void", "ordinal": 2,
"doc": "Stops following. The slave holds.", "queue": 16}, {"name": "teleop_state", "kind": "read",
"ordinal": 3, "wire": "teleopState", "result": {"type": {"kind": "enum",
"name": "robots::TeleopState"}}, "queue": 16}, {"name": "anchors", "kind": "read", "ordinal": 4,
"doc": "Returns the anchors of the present or last time of following.", "result": {"type": {
"kind": "struct", "name": "robots::FollowAnchors"}}, "queue": 16}, {"name": "set_scale",
"kind": "write", "ordinal": 5, "wire": "setScale", "parameters": [{"name": "scale", "type": {
"kind": "Float64"}, "range": [0.01, 10.0]}], "queue": 16}, {"name": "lock_rotation",
"kind": "write", "ordinal": 6, "wire": "lockRotation",
"doc": "Makes the slave keep its orientation. When it is unlocked, the master is aligned anew before\nthe slave follows.",
"parameters": [{"name": "lock", "type": {"kind": "Bool"}}], "queue": 16}, {
"name": "lock_translation", "kind": "write", "ordinal": 7, "wire": "lockTranslation",
"doc": "Makes the slave keep its position.", "parameters": [{"name": "lock", "type": {
"kind": "Bool"}}], "queue": 16}, {"name": "settings", "kind": "read", "ordinal": 8, "result": {
"type": {"kind": "struct", "name": "robots::TeleopSettings"}}, "queue": 16}], "events": [{
"name": "teleop_state", "kind": "write", "ordinal": 1, "wire": "teleopState", "payload": {"type": {
"kind": "enum", "name": "robots::TeleopState"}}, "queue": 16, "latched": true}, {
"name": "followed", "kind": "write", "ordinal": 2,
"doc": "Reports that following begins, or goes on with other settings.", "payload": {"type": {
"kind": "struct", "name": "robots::FollowAnchors"}}, "queue": 16, "latched": true}, {
"name": "settings", "kind": "write", "ordinal": 3,
"doc": "Reports each change, and the last one to a client that connects.", "payload": {"type": {
"kind": "struct", "name": "robots::TeleopSettings"}}, "queue": 16, "latched": true}], "enums": [{
"name": "robots::TeleopState", "underlying": "UInt8", "enumerators": [{"name": "Disabled",
"value": 0, "wire": "disabled", "doc": "until enable()"}, {"name": "Preparing", "value": 1,
"wire": "preparing",
"doc": "waits for both arms: connected, enabled, homed, fresh data of both, and a slave\nthat carries out goals"
}, {"name": "Following", "value": 2, "wire": "following"}, {"name": "Aligning", "value": 3,
"wire": "aligning", "doc": "turns the master to the orientation that the slave has in the view"}, {
"name": "Clutched", "value": 4, "wire": "clutched",
"doc": "the clutch is pressed, or nobody is at the console: the slave holds, the master is\nthe surgeon's to move"
}]}], "structs": [{"name": "robots::FollowAnchors",
"doc": "Says where following began: with this and the master's poses, anyone can compute what the slave\nshould do.",
"fields": [{"name": "master_stamp", "wire": "masterStamp",
"doc": "The first master pose that was followed has this stamp.", "type": {"kind": "time",
"clock": "steady"}}, {"name": "master",
"doc": "The master's measured pose was this at that stamp, in the master's reference frame.",
"type": {"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "slave_setpoint",
"wire": "slaveSetpoint",
"doc": "The slave's set-point was this at entry, in the slave's reference frame.", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}, {"name": "scale",
"doc": "The slave moves this many metres for each metre of the master.", "type": {"kind": "Float64"
}, "default": 0.0}, {"name": "entry",
"doc": "Following began this many times, including this one; 0 if it never did. A change of the\nsettings counts too, and does not move the slave.",
"type": {"kind": "UInt64"}, "default": 0}, {"name": "view",
"doc": "Rotates directions of the master's reference frame to those of the slave's that look the same\nto the surgeon.",
"type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 3}}, {
"name": "rotation_locked", "wire": "rotationLocked", "type": {"kind": "Bool"}, "default": false}, {
"name": "translation_locked", "wire": "translationLocked", "type": {"kind": "Bool"},
"default": false}]}, {"name": "robots::TeleopSettings",
"doc": "Holds the settings by which the slave follows.", "fields": [{"name": "scale",
"doc": "The slave moves this many metres for each metre of the master.", "type": {"kind": "Float64"
}, "default": 0.0}, {"name": "rotation_locked", "wire": "rotationLocked", "type": {"kind": "Bool"},
"default": false}, {"name": "translation_locked", "wire": "translationLocked", "type": {
"kind": "Bool"}, "default": false}]}], "wire": [{"id": "@0x9c2044876661808e", "kind": "interface",
"name": "Teleoperation", "cxx": "robots::Teleoperation", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xe8de6e374cc63239"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "enable", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "disable", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 3,
"name": "teleopState", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0x82c72c556eb58a10"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4, "name": "anchors", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0x8cdd0eb841f978ce"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 5, "name": "setScale", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "scale",
"is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 6,
"name": "lockRotation", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "lock",
"is": "Bool"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 7,
"name": "lockTranslation", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "lock",
"is": "Bool"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 8,
"name": "settings", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xe1eab6cf5390e93b"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xe8de6e374cc63239", "kind": "interface",
"name": "TeleoperationEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xbc0e291de17cadad"}]}, {"at": 1, "name": "teleopState", "parameters": [{
"at": 0, "name": "value", "is": "@0x82c72c556eb58a10"}, {"at": 1, "name": "stamp", "is": "Int64"}]
}, {"at": 2, "name": "followed", "parameters": [{"at": 0, "name": "value",
"is": "@0x8cdd0eb841f978ce"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 3,
"name": "settings", "parameters": [{"at": 0, "name": "value", "is": "@0xe1eab6cf5390e93b"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xbc0e291de17cadad", "kind": "struct",
"name": "TeleoperationStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "teleopState", "is": "@0x82c72c556eb58a10"
}, {"at": 3, "name": "anchors", "is": "@0x8cdd0eb841f978ce"}, {"at": 4, "name": "tooLarge",
"is": "UInt64"}, {"at": 5, "name": "settings", "is": "@0xe1eab6cf5390e93b"}]}, {
"id": "@0x82c72c556eb58a10", "kind": "enum", "name": "TeleopState", "members": [{"at": 0,
"name": "disabled"}, {"at": 1, "name": "preparing"}, {"at": 2, "name": "following"}, {"at": 3,
"name": "aligning"}, {"at": 4, "name": "clutched"}]}, {"id": "@0x8cdd0eb841f978ce",
"kind": "struct", "name": "FollowAnchors", "members": [{"at": 0, "name": "masterStamp",
"is": "Int64 clock \"steady\""}, {"at": 1, "name": "master",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 2, "name": "slaveSetpoint",
"is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 3, "name": "scale", "is": "Float64"}, {
"at": 4, "name": "entry", "is": "UInt64"}, {"at": 5, "name": "view",
"is": "/suture/types.capnp:Mat3"}, {"at": 6, "name": "rotationLocked", "is": "Bool"}, {"at": 7,
"name": "translationLocked", "is": "Bool"}]}, {"id": "@0xe1eab6cf5390e93b", "kind": "struct",
"name": "TeleopSettings", "members": [{"at": 0, "name": "scale", "is": "Float64"}, {"at": 1,
"name": "rotationLocked", "is": "Bool"}, {"at": 2, "name": "translationLocked", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Teleoperation>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::Teleoperation",
      .hash = "ce8c110f1e23bc0acf8dc69700b6dfa0",
      .description = robots::kTeleoperationDescription,
      .commands = robots::kTeleoperationCommands,
      .events = robots::kTeleoperationEvents,
      .codec = &robots::teleoperationCodec,
  };
  return kInfo;
}

// A function for each command of robots::Teleoperation, so that a stack in a debugger names it.
struct Provided<robots::Teleoperation>::Dispatch {
  static Errc execute_enable(Contract& implementation) {
    implementation.enable();
    return Errc{};
  }

  static Errc execute_disable(Contract& implementation) {
    implementation.disable();
    return Errc{};
  }

  static Errc execute_teleop_state(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::uint8_t>(result);
    return store(implementation.teleop_state(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_anchors(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::FollowAnchorsSlot>(result);
    return store(implementation.anchors(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_set_scale(Contract& implementation, Scratch& scratch,
                                const std::byte* arguments) {
    const auto& slot = slotIn<robots::TeleoperationSetScaleArguments>(arguments);
    load(slot.scale, scratch.set_scale_scale);
    implementation.set_scale(scratch.set_scale_scale);
    return Errc{};
  }

  static Errc execute_lock_rotation(Contract& implementation, Scratch& scratch,
                                    const std::byte* arguments) {
    const auto& slot = slotIn<robots::TeleoperationLockRotationArguments>(arguments);
    load(slot.lock, scratch.lock_rotation_lock);
    implementation.lock_rotation(scratch.lock_rotation_lock);
    return Errc{};
  }

  static Errc execute_lock_translation(Contract& implementation, Scratch& scratch,
                                       const std::byte* arguments) {
    const auto& slot = slotIn<robots::TeleoperationLockTranslationArguments>(arguments);
    load(slot.lock, scratch.lock_translation_lock);
    implementation.lock_translation(scratch.lock_translation_lock);
    return Errc{};
  }

  static Errc execute_settings(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::TeleopSettingsSlot>(result);
    return store(implementation.settings(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::Teleoperation>::execute(std::uint16_t command, const std::byte* arguments,
                                              std::byte* result) {
  using ::robots::TeleoperationCommand;
  switch (command) {
    case TeleoperationCommand::enable: return Dispatch::execute_enable(implementation_);
    case TeleoperationCommand::disable: return Dispatch::execute_disable(implementation_);
    case TeleoperationCommand::teleop_state:
      return Dispatch::execute_teleop_state(implementation_, result);
    case TeleoperationCommand::anchors: return Dispatch::execute_anchors(implementation_, result);
    case TeleoperationCommand::set_scale:
      return Dispatch::execute_set_scale(implementation_, scratch_, arguments);
    case TeleoperationCommand::lock_rotation:
      return Dispatch::execute_lock_rotation(implementation_, scratch_, arguments);
    case TeleoperationCommand::lock_translation:
      return Dispatch::execute_lock_translation(implementation_, scratch_, arguments);
    case TeleoperationCommand::settings: return Dispatch::execute_settings(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
