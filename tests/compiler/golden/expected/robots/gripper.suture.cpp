// Written by suturec from robots/gripper.h. Do not edit.
#include "robots/gripper.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const double& width, GripperOpenArguments& slot) { return store(width, slot.width); }

bool store(const double& width, GripperFitsArguments& slot) { return store(width, slot.width); }

bool store(const double& value, const bool& value2, GripperGrippedPayload& slot) {
  return store(value, slot.value) && store(value2, slot.value2);
}

void load(const GripperGrippedPayload& slot, double& value, bool& value2) {
  load(slot.value, value);
  load(slot.value2, value2);
}

bool store(const std::int32_t& name, NamesQueueArguments& slot) { return store(name, slot.name); }

bool store(const double& range, const double& slot, const double& storeGiven,
           NamesNameArguments& slotGiven) {
  return store(range, slotGiven.range) && store(slot, slotGiven.slot) &&
      store(storeGiven, slotGiven.store);
}

// Defined in robots/gripper.wire.cpp.
const suture::codec::Codec& gripperCodec();
const suture::codec::Codec& namesCodec();

namespace {

bool acceptsGripperOpen(const GripperOpenArguments& slot, suture::FieldPath* path) {
  return isValid(slot.width) || suture::refusedAt(path, "width");
}

bool acceptsGripperOpeningResult(const double& slot, suture::FieldPath*) { return isValid(slot); }

bool acceptsGripperFits(const GripperFitsArguments& slot, suture::FieldPath* path) {
  return isValid(slot.width) || suture::refusedAt(path, "width");
}

bool acceptsGripperGrippedEvent(const GripperGrippedPayload& slot, suture::FieldPath* path) {
  return isValid(slot.value) || suture::refusedAt(path, "value");
}

constexpr suture::CommandInfo kGripperCommands[] = {
    {.name = "open",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<GripperOpenArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<GripperOpenArguments, acceptsGripperOpen>},
    {.name = "opening",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = GripperColumn::opening,
     .acceptsResult = suture::checkSlot<double, acceptsGripperOpeningResult>},
    {.name = "fits",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<GripperFitsArguments>,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .inCallersThread = true,
     .accepts = suture::checkSlot<GripperFitsArguments, acceptsGripperFits>},
};

constexpr suture::EventInfo kGripperEvents[] = {
    {.name = "gripped",
     .payloadSize = suture::slotSize<GripperGrippedPayload>,
     .depth = 16,
     .accepts = suture::checkSlot<GripperGrippedPayload, acceptsGripperGrippedEvent>},
};

// The self-description, as in robots/gripper.suture.json.
constexpr char kGripperDescription[] = R"json(
{"name": "robots::Gripper", "doc": "An arm with a gripper.",
"hash": "fc71972a184a19de55a9a012bd7d14f9", "core": "eb9eb46966e5dba33474216f5ce87555",
"version": 2, "base": "robots::Arm", "since": 2, "commands": [{"name": "enable", "kind": "void",
"ordinal": 1, "queue": 4, "from": "robots::Arm"}, {"name": "servo_cp", "kind": "write",
"ordinal": 2, "wire": "servoCp", "doc": "Follow the goal.", "parameters": [{"name": "goal",
"type": {"kind": "struct", "name": "robots::PoseStamped"}}], "queue": 16, "latest": true,
"ttl": 0.02, "from": "robots::Arm"}, {"name": "set_speed", "kind": "write", "ordinal": 3,
"wire": "setSpeed", "parameters": [{"name": "speed", "type": {"kind": "Float64"}, "unit": "m/s"}],
"queue": 16, "from": "robots::Arm"}, {"name": "measured_cp", "kind": "read", "ordinal": 4,
"wire": "measuredCp", "result": {"type": {"kind": "struct", "name": "robots::PoseStamped"}},
"queue": 16, "from": "robots::Arm"}, {"name": "mode", "kind": "read", "ordinal": 5, "result": {
"type": {"kind": "enum", "name": "robots::Mode"}}, "queue": 16, "from": "robots::Arm"}, {
"name": "everything", "kind": "read", "ordinal": 6, "result": {"type": {"kind": "struct",
"name": "robots::Everything"}}, "queue": 16, "from": "robots::Arm"}, {"name": "inverse_kinematics",
"kind": "qualified read", "ordinal": 7, "wire": "inverseKinematics", "parameters": [{"name": "x",
"type": {"kind": "struct", "name": "robots::PoseStamped"}}, {"name": "tolerance", "type": {
"kind": "Float64"}, "range": [0.0, 1.0]}], "result": {"type": {"kind": "struct",
"name": "robots::Everything"}}, "queue": 16, "from": "robots::Arm"}, {"name": "grasp",
"kind": "write with return", "ordinal": 8,
"doc": "Closes the gripper; answers whether it holds something.", "parameters": [{"name": "width",
"type": {"kind": "Float64"}}, {"name": "mode", "type": {"kind": "enum", "name": "robots::Mode"}}],
"result": {"type": {"kind": "Bool"}}, "queue": 2, "deadline": 0.05, "from": "robots::Arm"}, {
"name": "next_token", "kind": "void with return", "ordinal": 9, "wire": "nextToken", "result": {
"type": {"kind": "UInt32"}}, "queue": 16, "from": "robots::Arm", "since": 1}, {"name": "park",
"kind": "void", "ordinal": 10, "queue": 16, "optional": true, "direct": true, "from": "robots::Arm",
"deprecated": "use enable"}, {"name": "load", "kind": "read", "ordinal": 11, "result": {"type": {
"kind": "Float64"}}, "queue": 16, "optional": true, "from": "robots::Arm"}, {"name": "open",
"kind": "write", "ordinal": 1, "parameters": [{"name": "width", "type": {"kind": "Float64"},
"unit": "m"}], "queue": 16}, {"name": "opening", "kind": "read", "ordinal": 2, "result": {"type": {
"kind": "Float64"}}, "queue": 16, "since": 2}, {"name": "fits", "kind": "qualified read",
"ordinal": 3, "parameters": [{"name": "width", "type": {"kind": "Float64"}}], "result": {"type": {
"kind": "Bool"}}, "queue": 16, "concurrent": true}], "events": [{"name": "mode_changed",
"kind": "write", "ordinal": 1, "wire": "modeChanged", "payload": {"type": {"kind": "enum",
"name": "robots::Mode"}}, "queue": 8, "latched": true, "from": "robots::Arm"}, {"name": "stopped",
"kind": "void", "ordinal": 2, "queue": 16, "from": "robots::Arm"}, {"name": "arrived",
"kind": "write", "ordinal": 3, "payload": {"type": {"kind": "struct", "name": "robots::PoseStamped"
}}, "queue": 16, "from": "robots::Arm"}, {"name": "moved", "kind": "write", "ordinal": 4,
"doc": "Where, how fast and why.", "payload": [{"name": "value", "type": {"kind": "struct",
"name": "robots::PoseStamped"}}, {"name": "value2", "type": {"kind": "Float64"}}, {
"name": "value3", "type": {"kind": "enum", "name": "robots::Mode"}}], "queue": 16, "latched": true,
"from": "robots::Arm"}, {"name": "gripped", "kind": "write", "ordinal": 5, "payload": [{
"name": "value", "type": {"kind": "Float64"}}, {"name": "value2", "type": {"kind": "Bool"}}],
"queue": 16, "since": 2}], "enums": [{"name": "robots::Mode", "doc": "What the arm does.",
"underlying": "Int8", "enumerators": [{"name": "Disabled", "value": -1, "wire": "disabled"}, {
"name": "HoldStill", "value": 4, "wire": "holdStill", "doc": "Brakes off, set-point frozen."}, {
"name": "Servo", "value": 2, "wire": "servo"}]}], "structs": [{"name": "robots::PoseStamped",
"doc": "A pose with its time.", "fields": [{"name": "pose", "type": {"kind": "isometry",
"scalar": "Float64"}}, {"name": "stamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "valid", "type": {"kind": "Bool"}, "default": false}]}, {"name": "robots::Everything",
"doc": "Every kind of member.\n\nTwo paragraphs.", "fields": [{"name": "on", "type": {
"kind": "Bool"}, "default": false}, {"name": "tiny", "type": {"kind": "Int8"}, "default": 0}, {
"name": "count", "type": {"kind": "UInt64"}, "default": 0}, {"name": "speed",
"doc": "Along the path.", "type": {"kind": "Float64"}, "unit": "m/s", "range": [-0.5, 2.0],
"default": 0.25}, {"name": "ratio", "type": {"kind": "Float32"}, "default": 0.0}, {"name": "mode",
"type": {"kind": "enum", "name": "robots::Mode"}, "default": "Servo"}, {"name": "label", "type": {
"kind": "text", "capacity": 16}}, {"name": "bytes", "type": {"kind": "list", "element": {
"kind": "UInt8"}, "capacity": 32}}, {"name": "flags", "type": {"kind": "list", "element": {
"kind": "Bool"}, "capacity": 4}}, {"name": "names", "type": {"kind": "list", "element": {
"kind": "text", "capacity": 8}, "capacity": 3}}, {"name": "pairs", "type": {"kind": "list",
"element": {"kind": "array", "element": {"kind": "Float64"}, "length": 2}, "capacity": 5}}, {
"name": "modes", "type": {"kind": "array", "element": {"kind": "enum", "name": "robots::Mode"},
"length": 2}}, {"name": "goal", "type": {"kind": "struct", "name": "robots::PoseStamped"}}, {
"name": "track", "type": {"kind": "list", "element": {"kind": "struct",
"name": "robots::PoseStamped"}, "capacity": 2}}, {"name": "point", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}, "unit": "m"}, {"name": "plane", "type": {
"kind": "matrix", "scalar": "Float32", "rows": 3, "columns": 1}}, {"name": "inertia", "type": {
"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 3}}, {"name": "jacobian", "type": {
"kind": "matrix", "scalar": "Float64", "rows": 6, "columns": 7}}, {"name": "attitude", "type": {
"kind": "quaternion", "scalar": "Float64"}}, {"name": "period", "type": {"kind": "duration",
"period": "1/1000"}, "default": 0.0}, {"name": "when", "type": {"kind": "time", "clock": "steady"}}
]}], "wire": [{"id": "@0xb9e926d064e78714", "kind": "interface", "name": "Gripper",
"cxx": "robots::Gripper", "version": 2, "members": [{"at": 0, "name": "subscribe", "parameters": [{
"at": 0, "name": "events", "is": "@0x9acb6a7a5fa48866"}, {"at": 1, "name": "eventMask",
"is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "open",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "width", "is": "Float64 unit \"m\""}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "opening",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]
}, {"at": 3, "name": "fits", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0,
"name": "width", "is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Bool"}]}]}, {"id": "@0x974e120931408f6d",
"kind": "interface", "name": "Arm", "cxx": "robots::Arm", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xa6aa5daf71e0a4ba"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "enable", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "servoCp", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "goal", "is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 3, "name": "setSpeed", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "speed", "is": "Float64 unit \"m/s\""}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 4, "name": "measuredCp", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 5, "name": "mode", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xab8c3dd92b2643d4"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 6, "name": "everything",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xe827b555e2bdb416"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 7, "name": "inverseKinematics", "is": "kind \"qualifiedRead\"",
"parameters": [{"at": 0, "name": "x", "is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "tolerance",
"is": "Float64"}, {"at": 2, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xe827b555e2bdb416"}]}, {"at": 8, "name": "grasp",
"is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "width", "is": "Float64"}, {"at": 1,
"name": "mode", "is": "@0xab8c3dd92b2643d4"}, {"at": 2, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Bool"}]}, {"at": 9,
"name": "nextToken", "is": "kind \"voidReturn\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "UInt32"}]}, {
"at": 10, "name": "park", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 11, "name": "load", "is": "kind \"read\"", "parameters": [
{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xa6aa5daf71e0a4ba",
"kind": "interface", "name": "ArmEvents", "members": [{"at": 0, "name": "state", "parameters": [{
"at": 0, "name": "row", "is": "@0xd633b378dcab35c1"}]}, {"at": 1, "name": "modeChanged",
"parameters": [{"at": 0, "name": "value", "is": "@0xab8c3dd92b2643d4"}, {"at": 1, "name": "stamp",
"is": "Int64"}]}, {"at": 2, "name": "stopped", "parameters": [{"at": 0, "name": "stamp",
"is": "Int64"}]}, {"at": 3, "name": "arrived", "parameters": [{"at": 0, "name": "value",
"is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4,
"name": "moved", "parameters": [{"at": 0, "name": "value", "is": "@0xe61654a89cf5f1dd"}, {"at": 1,
"name": "value2", "is": "Float64"}, {"at": 2, "name": "value3", "is": "@0xab8c3dd92b2643d4"}, {
"at": 3, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xd633b378dcab35c1", "kind": "struct",
"name": "ArmStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "measuredCp", "is": "@0xe61654a89cf5f1dd"}, {"at": 4, "name": "mode",
"is": "@0xab8c3dd92b2643d4"}, {"at": 5, "name": "everything", "is": "@0xe827b555e2bdb416"}, {
"at": 6, "name": "load", "is": "Float64"}]}, {"id": "@0xe61654a89cf5f1dd", "kind": "struct",
"name": "PoseStamped", "members": [{"at": 0, "name": "pose", "is": "/suture/types.capnp:Pose"}, {
"at": 1, "name": "stamp", "is": "Int64 clock \"steady\""}, {"at": 2, "name": "valid", "is": "Bool"}
]}, {"id": "@0xab8c3dd92b2643d4", "kind": "enum", "name": "Mode", "members": [{"at": 0,
"name": "disabled"}, {"at": 1, "name": "holdStill"}, {"at": 2, "name": "servo"}]}, {
"id": "@0xe827b555e2bdb416", "kind": "struct", "name": "Everything", "members": [{"at": 0,
"name": "on", "is": "Bool"}, {"at": 1, "name": "tiny", "is": "Int8"}, {"at": 2, "name": "count",
"is": "UInt64"}, {"at": 3, "name": "speed", "is": "Float64 unit \"m/s\" = 0.25"}, {"at": 4,
"name": "ratio", "is": "Float32"}, {"at": 5, "name": "mode", "is": "@0xab8c3dd92b2643d4 = servo"}, {
"at": 6, "name": "label", "is": "Text"}, {"at": 7, "name": "bytes", "is": "Data"}, {"at": 8,
"name": "flags", "is": "List(Bool)"}, {"at": 9, "name": "names", "is": "List(Text)"}, {"at": 10,
"name": "pairs", "is": "List(List(Float64)) shape \"*,2\""}, {"at": 11, "name": "modes",
"is": "List(@0xab8c3dd92b2643d4) shape \"2\""}, {"at": 12, "name": "goal",
"is": "@0xe61654a89cf5f1dd"}, {"at": 13, "name": "track", "is": "List(@0xe61654a89cf5f1dd)"}, {
"at": 14, "name": "point", "is": "/suture/types.capnp:Vec3 unit \"m\""}, {"at": 15, "name": "plane",
"is": "List(Float32) shape \"3x1\""}, {"at": 16, "name": "inertia", "is": "/suture/types.capnp:Mat3"
}, {"at": 17, "name": "jacobian", "is": "List(Float64) shape \"6x7\""}, {"at": 18,
"name": "attitude", "is": "/suture/types.capnp:Quat"}, {"at": 19, "name": "period",
"is": "Int64 period \"1/1000\""}, {"at": 20, "name": "when", "is": "Int64 clock \"steady\""}]}, {
"id": "@0x9acb6a7a5fa48866", "kind": "interface", "name": "GripperEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0x8d73a8caf926376a"}]}, {"at": 1,
"name": "modeChanged", "parameters": [{"at": 0, "name": "value", "is": "@0xab8c3dd92b2643d4"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "stopped", "parameters": [{"at": 0,
"name": "stamp", "is": "Int64"}]}, {"at": 3, "name": "arrived", "parameters": [{"at": 0,
"name": "value", "is": "@0xe61654a89cf5f1dd"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 4, "name": "moved", "parameters": [{"at": 0, "name": "value", "is": "@0xe61654a89cf5f1dd"}, {
"at": 1, "name": "value2", "is": "Float64"}, {"at": 2, "name": "value3", "is": "@0xab8c3dd92b2643d4"
}, {"at": 3, "name": "stamp", "is": "Int64"}]}, {"at": 5, "name": "gripped", "parameters": [{
"at": 0, "name": "value", "is": "Float64"}, {"at": 1, "name": "value2", "is": "Bool"}, {"at": 2,
"name": "stamp", "is": "Int64"}]}]}, {"id": "@0x8d73a8caf926376a", "kind": "struct",
"name": "GripperStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "measuredCp", "is": "@0xe61654a89cf5f1dd"}, {"at": 4, "name": "mode",
"is": "@0xab8c3dd92b2643d4"}, {"at": 5, "name": "everything", "is": "@0xe827b555e2bdb416"}, {
"at": 6, "name": "load", "is": "Float64"}, {"at": 7, "name": "opening", "is": "Float64"}]}]})json";

bool acceptsNamesTitle(const NamesNameArguments& slot, suture::FieldPath* path) {
  if (!isValid(slot.range)) return suture::refusedAt(path, "range");
  if (!isValid(slot.slot)) return suture::refusedAt(path, "slot");
  return isValid(slot.store) || suture::refusedAt(path, "store");
}

bool acceptsNamesRangeResult(const double& slot, suture::FieldPath*) {
  return suture::inRange(slot, 0, 1);
}

bool acceptsNamesLatchedEvent(const double& slot, suture::FieldPath*) { return isValid(slot); }

constexpr suture::CommandInfo kNamesCommands[] = {
    {.name = "queue",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<NamesQueueArguments>,
     .depth = 4},
    {.name = "name",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<NamesNameArguments>,
     .resultSize = suture::slotSize<std::uint8_t>,
     .depth = 16,
     .accepts = suture::checkSlot<NamesNameArguments, acceptsNamesTitle>},
    {.name = "range",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = NamesColumn::range,
     .acceptsResult = suture::checkSlot<double, acceptsNamesRangeResult>},
};

constexpr suture::EventInfo kNamesEvents[] = {
    {.name = "latched",
     .payloadSize = suture::slotSize<double>,
     .depth = 16,
     .latched = true,
     .accepts = suture::checkSlot<double, acceptsNamesLatchedEvent>},
};

// The self-description, as in robots/gripper.suture.json.
constexpr char kNamesDescription[] = R"json(
{"name": "robots::Names", "doc": "Members that are called as arguments of the annotations are.",
"hash": "523ca76d5743653a39146ca5ecc60fec", "commands": [{"name": "queue", "kind": "write",
"ordinal": 1, "parameters": [{"name": "name", "type": {"kind": "Int32"}}], "queue": 4}, {
"name": "name", "kind": "write with return", "ordinal": 2, "wire": "title", "parameters": [{
"name": "range", "type": {"kind": "Float64"}}, {"name": "slot", "type": {"kind": "Float64"}}, {
"name": "store", "type": {"kind": "Float64"}}], "result": {"type": {"kind": "Bool"}}, "queue": 16},
{"name": "range", "kind": "read", "ordinal": 3, "result": {"type": {"kind": "Float64"}, "range": [
0.0, 1.0]}, "queue": 16}], "events": [{"name": "latched", "kind": "write", "ordinal": 1,
"payload": {"type": {"kind": "Float64"}}, "queue": 16, "latched": true}], "enums": [],
"structs": [], "wire": [{"id": "@0xa213f67f20043abb", "kind": "interface", "name": "Names",
"cxx": "robots::Names", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xf43423c9c422881d"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "queue", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "name", "is": "Int32"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "title", "is": "kind \"writeReturn\"",
"parameters": [{"at": 0, "name": "range", "is": "Float64"}, {"at": 1, "name": "slot",
"is": "Float64"}, {"at": 2, "name": "store", "is": "Float64"}, {"at": 3, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Bool"}]}, {"at": 3,
"name": "range", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Float64"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xf43423c9c422881d", "kind": "interface",
"name": "NamesEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0x87faafafa7e923b7"}]}, {"at": 1, "name": "latched", "parameters": [{
"at": 0, "name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0x87faafafa7e923b7", "kind": "struct", "name": "NamesStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "range", "is": "Float64"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Gripper>() {
  static const auto kCommands = extended<14>(interfaceInfo<robots::Arm>().commands,
                                             robots::kGripperCommands);
  static const auto kEvents = extended<5>(interfaceInfo<robots::Arm>().events,
                                          robots::kGripperEvents);
  static const InterfaceInfo kInfo{
      .name = "robots::Gripper",
      .hash = "fc71972a184a19de55a9a012bd7d14f9",
      .description = robots::kGripperDescription,
      .commands = kCommands,
      .events = kEvents,
      .codec = &robots::gripperCodec,
      .base = &interfaceInfo<robots::Arm>,
      .toBase = &castToBase<robots::Gripper, robots::Arm>,
  };
  return kInfo;
}

template <>
const InterfaceInfo& interfaceInfo<robots::Names>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::Names",
      .hash = "523ca76d5743653a39146ca5ecc60fec",
      .description = robots::kNamesDescription,
      .commands = robots::kNamesCommands,
      .events = robots::kNamesEvents,
      .codec = &robots::namesCodec,
  };
  return kInfo;
}

// A function for each command of robots::Gripper, so that a stack in a debugger names it.
struct Provided<robots::Gripper>::Dispatch {
  static Errc execute_open(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<robots::GripperOpenArguments>(arguments);
    load(slot.width, scratch.open_width);
    implementation.open(scratch.open_width);
    return Errc{};
  }

  static Errc execute_opening(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.opening(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_fits(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                           std::byte* result) {
    const auto& slot = slotIn<robots::GripperFitsArguments>(arguments);
    load(slot.width, scratch.fits_width);
    auto& answer = newSlot<std::uint8_t>(result);
    return store(implementation.fits(scratch.fits_width), answer) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::Gripper>::execute(std::uint16_t command, const std::byte* arguments,
                                        std::byte* result) {
  using ::robots::GripperCommand;
  switch (command) {
    case GripperCommand::open: return Dispatch::execute_open(implementation_, scratch_, arguments);
    case GripperCommand::opening: return Dispatch::execute_opening(implementation_, result);
    case GripperCommand::fits:
      return Dispatch::execute_fits(implementation_, scratch_, arguments, result);
  }
  return Provided<robots::Arm>::execute(command, arguments, result);
}

// A function for each command of robots::Names, so that a stack in a debugger names it.
struct Provided<robots::Names>::Dispatch {
  static Errc execute_queue(Contract& implementation, Scratch& scratch,
                            const std::byte* arguments) {
    const auto& slot = slotIn<robots::NamesQueueArguments>(arguments);
    load(slot.name, scratch.queue_name);
    implementation.queue(scratch.queue_name);
    return Errc{};
  }

  static Errc execute_name(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                           std::byte* result) {
    const auto& slot = slotIn<robots::NamesNameArguments>(arguments);
    load(slot.range, scratch.name_range);
    load(slot.slot, scratch.name_slot);
    load(slot.store, scratch.name_store);
    auto& answer = newSlot<std::uint8_t>(result);
    return store(implementation.name(scratch.name_range, scratch.name_slot, scratch.name_store),
                 answer) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_range(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.range(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::Names>::execute(std::uint16_t command, const std::byte* arguments,
                                      std::byte* result) {
  using ::robots::NamesCommand;
  switch (command) {
    case NamesCommand::queue: return Dispatch::execute_queue(implementation_, scratch_, arguments);
    case NamesCommand::name:
      return Dispatch::execute_name(implementation_, scratch_, arguments, result);
    case NamesCommand::range: return Dispatch::execute_range(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
