// Written by suturec from strand/strand_view.h. Do not edit.
#include "strand/strand_view.suture.h"

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
static_assert(std::is_same_v<decltype(StrandState::nodes), Eigen::Matrix<double, 3, 61>>);
static_assert(std::is_same_v<decltype(StrandState::left_length), double>);
static_assert(std::is_same_v<decltype(StrandState::left_tension), double>);
static_assert(std::is_same_v<decltype(StrandState::right_tension), double>);
static_assert(std::is_same_v<decltype(StrandState::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(StrandState::valid), bool>);

}  // namespace

bool store(const StrandState& value, StrandStateSlot& slot) {
  bool fits = true;
  fits &= store(value.nodes, slot.nodes);
  fits &= store(value.left_length, slot.left_length);
  fits &= store(value.left_tension, slot.left_tension);
  fits &= store(value.right_tension, slot.right_tension);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const StrandStateSlot& slot, StrandState& value) {
  load(slot.nodes, value.nodes);
  load(slot.left_length, value.left_length);
  load(slot.left_tension, value.left_tension);
  load(slot.right_tension, value.right_tension);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(StrandStateSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isValid(const StrandStateSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.nodes)) return suture::refusedAt(path, "nodes");
  if (!isValid(slot.left_length)) return suture::refusedAt(path, "left_length");
  if (!isValid(slot.left_tension)) return suture::refusedAt(path, "left_tension");
  return isValid(slot.right_tension) || suture::refusedAt(path, "right_tension");
}

// Defined in strand/strand_view.wire.cpp.
const suture::codec::Codec& strandViewCodec();

namespace {

constexpr suture::CommandInfo kStrandViewCommands[] = {
    {.name = "strand",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<StrandStateSlot>,
     .depth = 16,
     .column = StrandViewColumn::strand,
     .acceptsResult = suture::checkSlot<StrandStateSlot, isValid>,
     .shiftResult = suture::shiftSlot<StrandStateSlot>},
};

// The self-description, as in strand/strand_view.suture.json.
constexpr char kStrandViewDescription[] = R"json(
{"name": "robots::StrandView", "hash": "3d0e0f11a53e375943417b4b324a46bf", "commands": [{
"name": "strand", "kind": "read", "ordinal": 1,
"doc": "Returns the strand as it is at the end of the simulation's last cycle, which is its stamp.",
"result": {"type": {"kind": "struct", "name": "robots::StrandState"}}, "queue": 16}], "events": [],
"enums": [], "structs": [{"name": "robots::StrandState", "fields": [{"name": "nodes",
"doc": "Go from the left tip over the knot, which is the middle column, to the right tip, in the\nscene's frame.",
"type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 61}, "unit": "m"}, {
"name": "left_length", "wire": "leftLength",
"doc": "The strand has this length between the left tip and the knot.", "type": {"kind": "Float64"
}, "unit": "m", "default": 0.0}, {"name": "left_tension", "wire": "leftTension",
"doc": "The tensions pull at the links beside the knot, from either side.", "type": {
"kind": "Float64"}, "unit": "N", "default": 0.0}, {"name": "right_tension", "wire": "rightTension",
"type": {"kind": "Float64"}, "unit": "N", "default": 0.0}, {"name": "stamp", "type": {
"kind": "time", "clock": "steady"}}, {"name": "valid",
"doc": "This is false before both tips are known, and apart from each other.", "type": {
"kind": "Bool"}, "default": false}]}], "wire": [{"id": "@0xffcefa0bd4f32fb9", "kind": "interface",
"name": "StrandView", "cxx": "robots::StrandView", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xf34a05754eaad965"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "strand", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xa7b70b5e253db6a2"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xf34a05754eaad965", "kind": "interface",
"name": "StrandViewEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xe319b7f6e1bccccd"}]}]}, {"id": "@0xe319b7f6e1bccccd", "kind": "struct",
"name": "StrandViewStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "strand", "is": "@0xa7b70b5e253db6a2"}]}, {"id": "@0xa7b70b5e253db6a2", "kind": "struct",
"name": "StrandState", "members": [{"at": 0, "name": "nodes",
"is": "List(Float64) unit \"m\" shape \"3x61\""}, {"at": 1, "name": "leftLength",
"is": "Float64 unit \"m\""}, {"at": 2, "name": "leftTension", "is": "Float64 unit \"N\""}, {
"at": 3, "name": "rightTension", "is": "Float64 unit \"N\""}, {"at": 4, "name": "stamp",
"is": "Int64 clock \"steady\""}, {"at": 5, "name": "valid", "is": "Bool"}]}]})json";

}  // namespace
}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::StrandView>() {
  static constexpr InterfaceInfo kInfo{
      .name = "robots::StrandView",
      .hash = "3d0e0f11a53e375943417b4b324a46bf",
      .description = robots::kStrandViewDescription,
      .commands = robots::kStrandViewCommands,
      .events = {},
      .codec = &robots::strandViewCodec,
  };
  return kInfo;
}

// A function for each command of robots::StrandView, so that a stack in a debugger names it.
struct Provided<robots::StrandView>::Dispatch {
  static Errc execute_strand(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<robots::StrandStateSlot>(result);
    return store(implementation.strand(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<robots::StrandView>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                           std::byte* result) {
  using ::robots::StrandViewCommand;
  switch (command) {
    case StrandViewCommand::strand: return Dispatch::execute_strand(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
