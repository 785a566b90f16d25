// Written by suturec from 03_own_data_type/tracker.h. Do not edit.
#include "03_own_data_type/tracker.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace tracking {

using suture::isValid;
using suture::load;
using suture::store;

// Defined in 03_own_data_type/tracker.wire.cpp.
const suture::codec::Codec& trackerCodec();

namespace {

constexpr suture::CommandInfo kTrackerCommands[] = {
    {.name = "observation",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<ObservationSlot>,
     .depth = 16,
     .column = TrackerColumn::observation,
     .acceptsResult = suture::checkSlot<ObservationSlot, isValid>},
};

// The self-description, as in 03_own_data_type/tracker.suture.json.
constexpr char kTrackerDescription[] = R"json(
{"name": "tracking::Tracker", "hash": "f75b729ffec40c77a2db866f16980374", "commands": [{
"name": "observation", "kind": "read", "ordinal": 1,
"doc": "Returns the newest observation; never waits for anyone.", "result": {"type": {
"kind": "struct", "name": "tracking::Observation"}}, "queue": 16}], "events": [], "enums": [{
"name": "tracking::Visibility", "underlying": "UInt8", "enumerators": [{"name": "Hidden",
"value": 0, "wire": "hidden"}, {"name": "Partial", "value": 1, "wire": "partial"}, {"name": "Full",
"value": 2, "wire": "full"}]}], "structs": [{"name": "tracking::Marker", "fields": [{
"name": "number", "type": {"kind": "UInt32"}, "default": 0}, {"name": "position", "type": {
"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}, "unit": "m"}]}, {
"name": "tracking::Observation",
"doc": "An Observation is what a tracking camera knows of a surgical instrument at one moment, in the\ncamera's frame.",
"fields": [{"name": "instrument", "type": {"kind": "text", "capacity": 31}}, {"name": "visibility",
"type": {"kind": "enum", "name": "tracking::Visibility"}, "default": "Hidden"}, {"name": "tip",
"doc": "The tip of the instrument has this pose.", "type": {"kind": "isometry", "scalar": "Float64"
}, "unit": "m"}, {"name": "markers", "doc": "The camera sees these markers.", "type": {
"kind": "list", "element": {"kind": "struct", "name": "tracking::Marker"}, "capacity": 8}}, {
"name": "jaw_angle", "wire": "jawAngle", "doc": "The jaws of the instrument are open this far.",
"type": {"kind": "Float64"}, "unit": "rad", "range": [0.0, 1.6], "default": 0.0}]}], "wire": [{
"id": "@0xfadff631147631f3", "kind": "interface", "name": "Tracker", "cxx": "tracking::Tracker",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xbe3f6f6614035211"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "observation", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xb007f771f460d934"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xbe3f6f6614035211", "kind": "interface", "name": "TrackerEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xfa119c601108b062"}]}]}, {
"id": "@0xfa119c601108b062", "kind": "struct", "name": "TrackerStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "observation", "is": "@0xb007f771f460d934"}]
}, {"id": "@0xb007f771f460d934", "kind": "struct", "name": "Observation", "members": [{"at": 0,
"name": "instrument", "is": "Text"}, {"at": 1, "name": "visibility", "is": "@0xbbada0527d771775"}, {
"at": 2, "name": "tip", "is": "/suture/types.capnp:Pose unit \"m\""}, {"at": 3, "name": "markers",
"is": "List(@0x8dd86c5318c04d7e)"}, {"at": 4, "name": "jawAngle", "is": "Float64 unit \"rad\""}]}, {
"id": "@0xbbada0527d771775", "kind": "enum", "name": "Visibility", "members": [{"at": 0,
"name": "hidden"}, {"at": 1, "name": "partial"}, {"at": 2, "name": "full"}]}, {
"id": "@0x8dd86c5318c04d7e", "kind": "struct", "name": "Marker", "members": [{"at": 0,
"name": "number", "is": "UInt32"}, {"at": 1, "name": "position",
"is": "/suture/types.capnp:Vec3 unit \"m\""}]}]})json";

}  // namespace
}  // namespace tracking

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<tracking::Tracker>() {
  static constexpr InterfaceInfo kInfo{
      .name = "tracking::Tracker",
      .hash = "f75b729ffec40c77a2db866f16980374",
      .description = tracking::kTrackerDescription,
      .commands = tracking::kTrackerCommands,
      .events = {},
      .codec = &tracking::trackerCodec,
  };
  return kInfo;
}

// A function for each command of tracking::Tracker, so that a stack in a debugger names it.
struct Provided<tracking::Tracker>::Dispatch {
  static Errc execute_observation(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<tracking::ObservationSlot>(result);
    return store(implementation.observation(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<tracking::Tracker>::execute(std::uint16_t command, const std::byte* /*arguments*/,
                                          std::byte* result) {
  using ::tracking::TrackerCommand;
  switch (command) {
    case TrackerCommand::observation: return Dispatch::execute_observation(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
