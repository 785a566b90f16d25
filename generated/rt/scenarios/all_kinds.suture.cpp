// Written by suturec from rt/scenarios/all_kinds.h. Do not edit.
#include "rt/scenarios/all_kinds.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace scenarios {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const double& value, AllKindsSetScalarArguments& slot) {
  return store(value, slot.value);
}

bool store(const Eigen::Vector3d& value, AllKindsSetVectorArguments& slot) {
  return store(value, slot.value);
}

bool store(const robots::PosePrm& value, AllKindsSetRecordArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(AllKindsSetRecordArguments& slot, suture::Duration shift) {
  shiftStamps(slot.value, shift);
}

bool store(const std::string& value, AllKindsSetTextArguments& slot) {
  return store(value, slot.value);
}

bool store(const double& value, AllKindsTwiceScalarArguments& slot) {
  return store(value, slot.value);
}

bool store(const Eigen::Vector3d& value, AllKindsTwiceVectorArguments& slot) {
  return store(value, slot.value);
}

bool store(const robots::PosePrm& value, AllKindsTwiceRecordArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(AllKindsTwiceRecordArguments& slot, suture::Duration shift) {
  shiftStamps(slot.value, shift);
}

bool store(const std::string& value, AllKindsTwiceTextArguments& slot) {
  return store(value, slot.value);
}

bool store(const double& value, AllKindsSwapScalarArguments& slot) {
  return store(value, slot.value);
}

bool store(const Eigen::Vector3d& value, AllKindsSwapVectorArguments& slot) {
  return store(value, slot.value);
}

bool store(const robots::PosePrm& value, AllKindsSwapRecordArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(AllKindsSwapRecordArguments& slot, suture::Duration shift) {
  shiftStamps(slot.value, shift);
}

bool store(const std::string& value, AllKindsSwapTextArguments& slot) {
  return store(value, slot.value);
}

// Defined in rt/scenarios/all_kinds.wire.cpp.
const suture::codec::Codec& allKindsCodec();

namespace {

bool acceptsAllKindsSetScalar(const AllKindsSetScalarArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value) || suture::refusedAt(path, "value");
}

bool acceptsAllKindsSetVector(const AllKindsSetVectorArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsAllKindsSetRecord(const AllKindsSetRecordArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsAllKindsScalarResult(const double& slot, suture::FieldPath*) { return isValid(slot); }

bool acceptsAllKindsVectorResult(const std::array<double, 3>& slot, suture::FieldPath* path) {
  return isValid(slot, path);
}

bool acceptsAllKindsTwiceScalar(const AllKindsTwiceScalarArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value) || suture::refusedAt(path, "value");
}

bool acceptsAllKindsTwiceScalarResult(const double& slot, suture::FieldPath*) {
  return isValid(slot);
}

bool acceptsAllKindsTwiceVector(const AllKindsTwiceVectorArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsAllKindsTwiceVectorResult(const std::array<double, 3>& slot, suture::FieldPath* path) {
  return isValid(slot, path);
}

bool acceptsAllKindsTwiceRecord(const AllKindsTwiceRecordArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsAllKindsTakeScalarResult(const double& slot, suture::FieldPath*) {
  return isValid(slot);
}

bool acceptsAllKindsTakeVectorResult(const std::array<double, 3>& slot, suture::FieldPath* path) {
  return isValid(slot, path);
}

bool acceptsAllKindsSwapScalar(const AllKindsSwapScalarArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value) || suture::refusedAt(path, "value");
}

bool acceptsAllKindsSwapScalarResult(const double& slot, suture::FieldPath*) {
  return isValid(slot);
}

bool acceptsAllKindsSwapVector(const AllKindsSwapVectorArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsAllKindsSwapVectorResult(const std::array<double, 3>& slot, suture::FieldPath* path) {
  return isValid(slot, path);
}

bool acceptsAllKindsSwapRecord(const AllKindsSwapRecordArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsAllKindsScalarSetEvent(const double& slot, suture::FieldPath*) { return isValid(slot); }

bool acceptsAllKindsVectorSetEvent(const std::array<double, 3>& slot, suture::FieldPath* path) {
  return isValid(slot, path);
}

constexpr suture::CommandInfo kAllKindsCommands[] = {
    {.name = "clear", .kind = suture::CommandKind::Void, .depth = 16},
    {.name = "set_scalar",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<AllKindsSetScalarArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<AllKindsSetScalarArguments, acceptsAllKindsSetScalar>},
    {.name = "set_vector",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<AllKindsSetVectorArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<AllKindsSetVectorArguments, acceptsAllKindsSetVector>},
    {.name = "set_record",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<AllKindsSetRecordArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<AllKindsSetRecordArguments, acceptsAllKindsSetRecord>,
     .shiftArguments = suture::shiftSlot<AllKindsSetRecordArguments>},
    {.name = "set_text",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<AllKindsSetTextArguments>,
     .depth = 16},
    {.name = "scalar",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = AllKindsColumn::scalar,
     .acceptsResult = suture::checkSlot<double, acceptsAllKindsScalarResult>},
    {.name = "vector",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<std::array<double, 3>>,
     .depth = 16,
     .column = AllKindsColumn::vector,
     .acceptsResult = suture::checkSlot<std::array<double, 3>, acceptsAllKindsVectorResult>},
    {.name = "record",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .column = AllKindsColumn::record,
     .acceptsResult = suture::checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftResult = suture::shiftSlot<robots::PosePrmSlot>},
    {.name = "text",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<suture::BoundedText<31>>,
     .depth = 16,
     .column = AllKindsColumn::text},
    {.name = "twice_scalar",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<AllKindsTwiceScalarArguments>,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .accepts = suture::checkSlot<AllKindsTwiceScalarArguments, acceptsAllKindsTwiceScalar>,
     .acceptsResult = suture::checkSlot<double, acceptsAllKindsTwiceScalarResult>},
    {.name = "twice_vector",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<AllKindsTwiceVectorArguments>,
     .resultSize = suture::slotSize<std::array<double, 3>>,
     .depth = 16,
     .accepts = suture::checkSlot<AllKindsTwiceVectorArguments, acceptsAllKindsTwiceVector>,
     .acceptsResult = suture::checkSlot<std::array<double, 3>, acceptsAllKindsTwiceVectorResult>},
    {.name = "twice_record",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<AllKindsTwiceRecordArguments>,
     .resultSize = suture::slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<AllKindsTwiceRecordArguments, acceptsAllKindsTwiceRecord>,
     .acceptsResult = suture::checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftArguments = suture::shiftSlot<AllKindsTwiceRecordArguments>,
     .shiftResult = suture::shiftSlot<robots::PosePrmSlot>},
    {.name = "twice_text",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<AllKindsTwiceTextArguments>,
     .resultSize = suture::slotSize<suture::BoundedText<31>>,
     .depth = 16},
    {.name = "take_scalar",
     .kind = suture::CommandKind::VoidReturn,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .acceptsResult = suture::checkSlot<double, acceptsAllKindsTakeScalarResult>},
    {.name = "take_vector",
     .kind = suture::CommandKind::VoidReturn,
     .resultSize = suture::slotSize<std::array<double, 3>>,
     .depth = 16,
     .acceptsResult = suture::checkSlot<std::array<double, 3>, acceptsAllKindsTakeVectorResult>},
    {.name = "take_record",
     .kind = suture::CommandKind::VoidReturn,
     .resultSize = suture::slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .acceptsResult = suture::checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftResult = suture::shiftSlot<robots::PosePrmSlot>},
    {.name = "take_text",
     .kind = suture::CommandKind::VoidReturn,
     .resultSize = suture::slotSize<suture::BoundedText<31>>,
     .depth = 16},
    {.name = "swap_scalar",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<AllKindsSwapScalarArguments>,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .accepts = suture::checkSlot<AllKindsSwapScalarArguments, acceptsAllKindsSwapScalar>,
     .acceptsResult = suture::checkSlot<double, acceptsAllKindsSwapScalarResult>},
    {.name = "swap_vector",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<AllKindsSwapVectorArguments>,
     .resultSize = suture::slotSize<std::array<double, 3>>,
     .depth = 16,
     .accepts = suture::checkSlot<AllKindsSwapVectorArguments, acceptsAllKindsSwapVector>,
     .acceptsResult = suture::checkSlot<std::array<double, 3>, acceptsAllKindsSwapVectorResult>},
    {.name = "swap_record",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<AllKindsSwapRecordArguments>,
     .resultSize = suture::slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<AllKindsSwapRecordArguments, acceptsAllKindsSwapRecord>,
     .acceptsResult = suture::checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftArguments = suture::shiftSlot<AllKindsSwapRecordArguments>,
     .shiftResult = suture::shiftSlot<robots::PosePrmSlot>},
    {.name = "swap_text",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<AllKindsSwapTextArguments>,
     .resultSize = suture::slotSize<suture::BoundedText<31>>,
     .depth = 16},
};

constexpr suture::EventInfo kAllKindsEvents[] = {
    {.name = "cleared", .depth = 16},
    {.name = "scalar_set",
     .payloadSize = suture::slotSize<double>,
     .depth = 16,
     .accepts = suture::checkSlot<double, acceptsAllKindsScalarSetEvent>},
    {.name = "vector_set",
     .payloadSize = suture::slotSize<std::array<double, 3>>,
     .depth = 16,
     .accepts = suture::checkSlot<std::array<double, 3>, acceptsAllKindsVectorSetEvent>},
    {.name = "record_set",
     .payloadSize = suture::slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .accepts = suture::checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftPayload = suture::shiftSlot<robots::PosePrmSlot>},
    {.name = "text_set", .payloadSize = suture::slotSize<suture::BoundedText<31>>, .depth = 16},
};

// The self-description, as in rt/scenarios/all_kinds.suture.json.
constexpr char kAllKindsDescription[] = R"json(
{"name": "scenarios::AllKinds", "hash": "a9aa7eb587740dbc7d09ca6fff6de2b1", "commands": [{
"name": "clear", "kind": "void", "ordinal": 1, "doc": "Forgets all values. This is a void command.",
"queue": 16}, {"name": "set_scalar", "kind": "write", "ordinal": 2, "wire": "setScalar",
"doc": "Keeps a value and tells it. This is a write.", "parameters": [{"name": "value", "type": {
"kind": "Float64"}}], "queue": 16}, {"name": "set_vector", "kind": "write", "ordinal": 3,
"wire": "setVector", "parameters": [{"name": "value", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}}], "queue": 16}, {"name": "set_record",
"kind": "write", "ordinal": 4, "wire": "setRecord", "parameters": [{"name": "value", "type": {
"kind": "struct", "name": "robots::PosePrm"}}], "queue": 16}, {"name": "set_text", "kind": "write",
"ordinal": 5, "wire": "setText", "parameters": [{"name": "value", "type": {"kind": "text",
"capacity": 31}}], "queue": 16}, {"name": "scalar", "kind": "read", "ordinal": 6,
"doc": "Returns the value that is kept. This is a read.", "result": {"type": {"kind": "Float64"}},
"queue": 16}, {"name": "vector", "kind": "read", "ordinal": 7, "result": {"type": {
"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16}, {"name": "record",
"kind": "read", "ordinal": 8, "result": {"type": {"kind": "struct", "name": "robots::PosePrm"}},
"queue": 16}, {"name": "text", "kind": "read", "ordinal": 9, "result": {"type": {"kind": "text",
"capacity": 31}}, "queue": 16}, {"name": "twice_scalar", "kind": "qualified read", "ordinal": 10,
"wire": "twiceScalar", "doc": "Returns twice the value that is given. This is a qualified read.",
"parameters": [{"name": "value", "type": {"kind": "Float64"}}], "result": {"type": {
"kind": "Float64"}}, "queue": 16}, {"name": "twice_vector", "kind": "qualified read", "ordinal": 11,
"wire": "twiceVector", "parameters": [{"name": "value", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}}], "result": {"type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16}, {"name": "twice_record",
"kind": "qualified read", "ordinal": 12, "wire": "twiceRecord", "parameters": [{"name": "value",
"type": {"kind": "struct", "name": "robots::PosePrm"}}], "result": {"type": {"kind": "struct",
"name": "robots::PosePrm"}}, "queue": 16}, {"name": "twice_text", "kind": "qualified read",
"ordinal": 13, "wire": "twiceText", "parameters": [{"name": "value", "type": {"kind": "text",
"capacity": 15}}], "result": {"type": {"kind": "text", "capacity": 31}}, "queue": 16}, {
"name": "take_scalar", "kind": "void with return", "ordinal": 14, "wire": "takeScalar",
"doc": "Returns the value that was kept, and forgets it. This is a void command with a return.",
"result": {"type": {"kind": "Float64"}}, "queue": 16}, {"name": "take_vector",
"kind": "void with return", "ordinal": 15, "wire": "takeVector", "result": {"type": {
"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16}, {
"name": "take_record", "kind": "void with return", "ordinal": 16, "wire": "takeRecord", "result": {
"type": {"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}, {"name": "take_text",
"kind": "void with return", "ordinal": 17, "wire": "takeText", "result": {"type": {"kind": "text",
"capacity": 31}}, "queue": 16}, {"name": "swap_scalar", "kind": "write with return", "ordinal": 18,
"wire": "swapScalar",
"doc": "Keeps a value and returns the one before. This is a write with a return.", "parameters": [{
"name": "value", "type": {"kind": "Float64"}}], "result": {"type": {"kind": "Float64"}}, "queue": 16
}, {"name": "swap_vector", "kind": "write with return", "ordinal": 19, "wire": "swapVector",
"parameters": [{"name": "value", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}}], "result": {"type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1
}}, "queue": 16}, {"name": "swap_record", "kind": "write with return", "ordinal": 20,
"wire": "swapRecord", "parameters": [{"name": "value", "type": {"kind": "struct",
"name": "robots::PosePrm"}}], "result": {"type": {"kind": "struct", "name": "robots::PosePrm"}},
"queue": 16}, {"name": "swap_text", "kind": "write with return", "ordinal": 21, "wire": "swapText",
"parameters": [{"name": "value", "type": {"kind": "text", "capacity": 31}}], "result": {"type": {
"kind": "text", "capacity": 31}}, "queue": 16}], "events": [{"name": "cleared", "kind": "void",
"ordinal": 1, "doc": "Tells that all values are forgotten. This is a void event.", "queue": 16}, {
"name": "scalar_set", "kind": "write", "ordinal": 2, "wire": "scalarSet",
"doc": "Tells the value that has been set. This is a write event.", "payload": {"type": {
"kind": "Float64"}}, "queue": 16}, {"name": "vector_set", "kind": "write", "ordinal": 3,
"wire": "vectorSet", "payload": {"type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}}, "queue": 16}, {"name": "record_set", "kind": "write", "ordinal": 4,
"wire": "recordSet", "payload": {"type": {"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16
}, {"name": "text_set", "kind": "write", "ordinal": 5, "wire": "textSet", "payload": {"type": {
"kind": "text", "capacity": 31}}, "queue": 16}], "enums": [], "structs": [{
"name": "robots::PosePrm",
"doc": "A PosePrm has the fields of the cisst libraries' prmPositionCartesianGet, the type of the\npaper's measurements.",
"fields": [{"name": "timestamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "automatic_timestamp", "wire": "automaticTimestamp",
"doc": "This is true if the provider stamps the data itself.", "type": {"kind": "Bool"},
"default": true}, {"name": "valid", "type": {"kind": "Bool"}, "default": false}, {
"name": "moving_frame", "wire": "movingFrame", "type": {"kind": "text", "capacity": 15}}, {
"name": "reference_frame", "wire": "referenceFrame", "type": {"kind": "text", "capacity": 15}}, {
"name": "position", "doc": "The moving frame is here in the reference frame.", "type": {
"kind": "isometry", "scalar": "Float64"}, "unit": "m"}]}], "wire": [{"id": "@0xf6dce3f368753cbc",
"kind": "interface", "name": "AllKinds", "cxx": "scenarios::AllKinds", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xdccb6d872bbaa8db"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "clear", "is": "kind \"void\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 2, "name": "setScalar", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "value", "is": "Float64"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}]}, {"at": 3, "name": "setVector", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "value", "is": "/suture/types.capnp:Vec3"}, {"at": 1,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 4, "name": "setRecord",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 5, "name": "setText",
"is": "kind \"write\"", "parameters": [{"at": 0, "name": "value", "is": "Text"}, {"at": 1,
"name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 6, "name": "scalar",
"is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]
}, {"at": 7, "name": "vector", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "/suture/types.capnp:Vec3"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 8,
"name": "record", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 9, "name": "text", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Text"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 10,
"name": "twiceScalar", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "value",
"is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Float64"}]}, {"at": 11, "name": "twiceVector",
"is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "value",
"is": "/suture/types.capnp:Vec3"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "/suture/types.capnp:Vec3"}]}, {"at": 12,
"name": "twiceRecord", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xedd17c97b8723561"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"}]}, {"at": 13,
"name": "twiceText", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "value",
"is": "Text"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Text"}]}, {"at": 14, "name": "takeScalar", "is": "kind \"voidReturn\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Float64"}]}, {"at": 15, "name": "takeVector", "is": "kind \"voidReturn\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "/suture/types.capnp:Vec3"}]}, {"at": 16, "name": "takeRecord",
"is": "kind \"voidReturn\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"
}], "results": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"}]}, {"at": 17,
"name": "takeText", "is": "kind \"voidReturn\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Text"}]}, {
"at": 18, "name": "swapScalar", "is": "kind \"writeReturn\"", "parameters": [{"at": 0,
"name": "value", "is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Float64"}]}, {"at": 19, "name": "swapVector",
"is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "value",
"is": "/suture/types.capnp:Vec3"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "/suture/types.capnp:Vec3"}]}, {"at": 20,
"name": "swapRecord", "is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xedd17c97b8723561"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"}]}, {"at": 21,
"name": "swapText", "is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "value",
"is": "Text"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Text"}]}]}, {"id": "@0xdccb6d872bbaa8db", "kind": "interface",
"name": "AllKindsEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xf9cad0ab043d03c9"}]}, {"at": 1, "name": "cleared", "parameters": [{
"at": 0, "name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "scalarSet", "parameters": [{"at": 0,
"name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 3,
"name": "vectorSet", "parameters": [{"at": 0, "name": "value", "is": "/suture/types.capnp:Vec3"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4, "name": "recordSet", "parameters": [{"at": 0,
"name": "value", "is": "@0xedd17c97b8723561"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 5, "name": "textSet", "parameters": [{"at": 0, "name": "value", "is": "Text"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}]}, {"id": "@0xf9cad0ab043d03c9", "kind": "struct",
"name": "AllKindsStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "scalar", "is": "Float64"}, {"at": 4, "name": "vector", "is": "/suture/types.capnp:Vec3"}, {
"at": 5, "name": "record", "is": "@0xedd17c97b8723561"}, {"at": 6, "name": "text", "is": "Text"}]},
{"id": "@0xedd17c97b8723561", "kind": "struct", "name": "PosePrm", "members": [{"at": 0,
"name": "timestamp", "is": "Int64 clock \"steady\""}, {"at": 1, "name": "automaticTimestamp",
"is": "Bool = true"}, {"at": 2, "name": "valid", "is": "Bool"}, {"at": 3, "name": "movingFrame",
"is": "Text"}, {"at": 4, "name": "referenceFrame", "is": "Text"}, {"at": 5, "name": "position",
"is": "/suture/types.capnp:Pose unit \"m\""}]}]})json";

}  // namespace
}  // namespace scenarios

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<scenarios::AllKinds>() {
  static constexpr InterfaceInfo kInfo{
      .name = "scenarios::AllKinds",
      .hash = "a9aa7eb587740dbc7d09ca6fff6de2b1",
      .description = scenarios::kAllKindsDescription,
      .commands = scenarios::kAllKindsCommands,
      .events = scenarios::kAllKindsEvents,
      .codec = &scenarios::allKindsCodec,
  };
  return kInfo;
}

auto Provided<scenarios::AllKinds>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(scenarios::AllKindsSetRecordArguments::value)>(scratch.set_record_value);
  reserveFor<decltype(scenarios::AllKindsSetTextArguments::value)>(scratch.set_text_value);
  reserveFor<decltype(scenarios::AllKindsTwiceRecordArguments::value)>(scratch.twice_record_value);
  reserveFor<decltype(scenarios::AllKindsTwiceTextArguments::value)>(scratch.twice_text_value);
  reserveFor<decltype(scenarios::AllKindsSwapRecordArguments::value)>(scratch.swap_record_value);
  reserveFor<decltype(scenarios::AllKindsSwapTextArguments::value)>(scratch.swap_text_value);
  return scratch;
}

// A function for each command of scenarios::AllKinds, so that a stack in a debugger names it.
struct Provided<scenarios::AllKinds>::Dispatch {
  static Errc execute_clear(Contract& implementation) {
    implementation.clear();
    return Errc{};
  }

  static Errc execute_set_scalar(Contract& implementation, Scratch& scratch,
                                 const std::byte* arguments) {
    const auto& slot = slotIn<scenarios::AllKindsSetScalarArguments>(arguments);
    load(slot.value, scratch.set_scalar_value);
    implementation.set_scalar(scratch.set_scalar_value);
    return Errc{};
  }

  static Errc execute_set_vector(Contract& implementation, Scratch& scratch,
                                 const std::byte* arguments) {
    const auto& slot = slotIn<scenarios::AllKindsSetVectorArguments>(arguments);
    load(slot.value, scratch.set_vector_value);
    implementation.set_vector(scratch.set_vector_value);
    return Errc{};
  }

  static Errc execute_set_record(Contract& implementation, Scratch& scratch,
                                 const std::byte* arguments) {
    const auto& slot = slotIn<scenarios::AllKindsSetRecordArguments>(arguments);
    load(slot.value, scratch.set_record_value);
    implementation.set_record(scratch.set_record_value);
    return Errc{};
  }

  static Errc execute_set_text(Contract& implementation, Scratch& scratch,
                               const std::byte* arguments) {
    const auto& slot = slotIn<scenarios::AllKindsSetTextArguments>(arguments);
    load(slot.value, scratch.set_text_value);
    implementation.set_text(scratch.set_text_value);
    return Errc{};
  }

  static Errc execute_scalar(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.scalar(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_vector(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::array<double, 3>>(result);
    return store(implementation.vector(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_record(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PosePrmSlot>(result);
    return store(implementation.record(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_text(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<suture::BoundedText<31>>(result);
    return store(implementation.text(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_twice_scalar(Contract& implementation, Scratch& scratch,
                                   const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<scenarios::AllKindsTwiceScalarArguments>(arguments);
    load(slot.value, scratch.twice_scalar_value);
    auto& answer = newSlot<double>(result);
    return store(implementation.twice_scalar(scratch.twice_scalar_value), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_twice_vector(Contract& implementation, Scratch& scratch,
                                   const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<scenarios::AllKindsTwiceVectorArguments>(arguments);
    load(slot.value, scratch.twice_vector_value);
    auto& answer = newSlot<std::array<double, 3>>(result);
    return store(implementation.twice_vector(scratch.twice_vector_value), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_twice_record(Contract& implementation, Scratch& scratch,
                                   const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<scenarios::AllKindsTwiceRecordArguments>(arguments);
    load(slot.value, scratch.twice_record_value);
    auto& answer = newSlot<robots::PosePrmSlot>(result);
    return store(implementation.twice_record(scratch.twice_record_value), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_twice_text(Contract& implementation, Scratch& scratch,
                                 const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<scenarios::AllKindsTwiceTextArguments>(arguments);
    load(slot.value, scratch.twice_text_value);
    auto& answer = newSlot<suture::BoundedText<31>>(result);
    return store(implementation.twice_text(scratch.twice_text_value), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_take_scalar(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.take_scalar(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_take_vector(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<std::array<double, 3>>(result);
    return store(implementation.take_vector(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_take_record(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::PosePrmSlot>(result);
    return store(implementation.take_record(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_take_text(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<suture::BoundedText<31>>(result);
    return store(implementation.take_text(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_swap_scalar(Contract& implementation, Scratch& scratch,
                                  const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<scenarios::AllKindsSwapScalarArguments>(arguments);
    load(slot.value, scratch.swap_scalar_value);
    auto& answer = newSlot<double>(result);
    return store(implementation.swap_scalar(scratch.swap_scalar_value), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_swap_vector(Contract& implementation, Scratch& scratch,
                                  const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<scenarios::AllKindsSwapVectorArguments>(arguments);
    load(slot.value, scratch.swap_vector_value);
    auto& answer = newSlot<std::array<double, 3>>(result);
    return store(implementation.swap_vector(scratch.swap_vector_value), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_swap_record(Contract& implementation, Scratch& scratch,
                                  const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<scenarios::AllKindsSwapRecordArguments>(arguments);
    load(slot.value, scratch.swap_record_value);
    auto& answer = newSlot<robots::PosePrmSlot>(result);
    return store(implementation.swap_record(scratch.swap_record_value), answer)
        ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_swap_text(Contract& implementation, Scratch& scratch,
                                const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<scenarios::AllKindsSwapTextArguments>(arguments);
    load(slot.value, scratch.swap_text_value);
    auto& answer = newSlot<suture::BoundedText<31>>(result);
    return store(implementation.swap_text(scratch.swap_text_value), answer)
        ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<scenarios::AllKinds>::execute(std::uint16_t command, const std::byte* arguments,
                                            std::byte* result) {
  using ::scenarios::AllKindsCommand;
  switch (command) {
    case AllKindsCommand::clear: return Dispatch::execute_clear(implementation_);
    case AllKindsCommand::set_scalar:
      return Dispatch::execute_set_scalar(implementation_, scratch_, arguments);
    case AllKindsCommand::set_vector:
      return Dispatch::execute_set_vector(implementation_, scratch_, arguments);
    case AllKindsCommand::set_record:
      return Dispatch::execute_set_record(implementation_, scratch_, arguments);
    case AllKindsCommand::set_text:
      return Dispatch::execute_set_text(implementation_, scratch_, arguments);
    case AllKindsCommand::scalar: return Dispatch::execute_scalar(implementation_, result);
    case AllKindsCommand::vector: return Dispatch::execute_vector(implementation_, result);
    case AllKindsCommand::record: return Dispatch::execute_record(implementation_, result);
    case AllKindsCommand::text: return Dispatch::execute_text(implementation_, result);
    case AllKindsCommand::twice_scalar:
      return Dispatch::execute_twice_scalar(implementation_, scratch_, arguments, result);
    case AllKindsCommand::twice_vector:
      return Dispatch::execute_twice_vector(implementation_, scratch_, arguments, result);
    case AllKindsCommand::twice_record:
      return Dispatch::execute_twice_record(implementation_, scratch_, arguments, result);
    case AllKindsCommand::twice_text:
      return Dispatch::execute_twice_text(implementation_, scratch_, arguments, result);
    case AllKindsCommand::take_scalar:
      return Dispatch::execute_take_scalar(implementation_, result);
    case AllKindsCommand::take_vector:
      return Dispatch::execute_take_vector(implementation_, result);
    case AllKindsCommand::take_record:
      return Dispatch::execute_take_record(implementation_, result);
    case AllKindsCommand::take_text: return Dispatch::execute_take_text(implementation_, result);
    case AllKindsCommand::swap_scalar:
      return Dispatch::execute_swap_scalar(implementation_, scratch_, arguments, result);
    case AllKindsCommand::swap_vector:
      return Dispatch::execute_swap_vector(implementation_, scratch_, arguments, result);
    case AllKindsCommand::swap_record:
      return Dispatch::execute_swap_record(implementation_, scratch_, arguments, result);
    case AllKindsCommand::swap_text:
      return Dispatch::execute_swap_text(implementation_, scratch_, arguments, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
