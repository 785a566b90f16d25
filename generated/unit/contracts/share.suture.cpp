// Written by suturec from unit/contracts/share.h. Do not edit.
#include "unit/contracts/share.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <limits>
#include <type_traits>

namespace contracts {

using suture::isValid;
using suture::load;
using suture::store;

bool store(const bool& all, ShareSharesArguments& slot) { return store(all, slot.all); }

bool store(const double& wanted, ShareTakeArguments& slot) { return store(wanted, slot.wanted); }

// Defined in unit/contracts/share.wire.cpp.
const suture::codec::Codec& shareCodec();

namespace {

bool acceptsShareShareResult(const double& slot, suture::FieldPath*) {
  return suture::inRange(slot, 0, 1);
}

bool acceptsShareSharesResult(const std::int32_t& slot, suture::FieldPath*) {
  return suture::inRange(slot, 0, 1);
}

bool acceptsShareTake(const ShareTakeArguments& slot, suture::FieldPath* path) {
  return isValid(slot.wanted) || suture::refusedAt(path, "wanted");
}

bool acceptsShareTakeResult(const double& slot, suture::FieldPath*) {
  return suture::inRange(slot, 0, 1);
}

bool acceptsShareReachResult(const double& slot, suture::FieldPath*) {
  return suture::inRange(slot, 0, std::numeric_limits<double>::infinity());
}

constexpr suture::CommandInfo kShareCommands[] = {
    {.name = "share",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = ShareColumn::share,
     .acceptsResult = suture::checkSlot<double, acceptsShareShareResult>},
    {.name = "shares",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<ShareSharesArguments>,
     .resultSize = suture::slotSize<std::int32_t>,
     .depth = 16,
     .acceptsResult = suture::checkSlot<std::int32_t, acceptsShareSharesResult>},
    {.name = "take",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<ShareTakeArguments>,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .accepts = suture::checkSlot<ShareTakeArguments, acceptsShareTake>,
     .acceptsResult = suture::checkSlot<double, acceptsShareTakeResult>},
    {.name = "reach",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<double>,
     .depth = 16,
     .column = ShareColumn::reach,
     .acceptsResult = suture::checkSlot<double, acceptsShareReachResult>},
};

// The self-description, as in unit/contracts/share.suture.json.
constexpr char kShareDescription[] = R"json(
{"name": "contracts::Share", "hash": "24b07ee8040a6cd1db8f86c280245892", "commands": [{
"name": "share", "kind": "read", "ordinal": 1, "result": {"type": {"kind": "Float64"}, "range": [
0.0, 1.0]}, "queue": 16}, {"name": "shares", "kind": "qualified read", "ordinal": 2, "parameters": [
{"name": "all", "type": {"kind": "Bool"}}], "result": {"type": {"kind": "Int32"}, "range": [0.0, 1.0
]}, "queue": 16}, {"name": "take", "kind": "write with return", "ordinal": 3, "parameters": [{
"name": "wanted", "type": {"kind": "Float64"}}], "result": {"type": {"kind": "Float64"}, "range": [
0.0, 1.0]}, "queue": 16}, {"name": "reach", "kind": "read", "ordinal": 4, "result": {"type": {
"kind": "Float64"}, "range": [0.0, "inf"]}, "queue": 16}], "events": [], "enums": [], "structs": [],
"wire": [{"id": "@0xbc44383dfd74184a", "kind": "interface", "name": "Share",
"cxx": "contracts::Share", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0x83261bdaea7017eb"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "share", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Float64"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 2,
"name": "shares", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "all",
"is": "Bool"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Int32"}]}, {"at": 3, "name": "take", "is": "kind \"writeReturn\"",
"parameters": [{"at": 0, "name": "wanted", "is": "Float64"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Float64"}]}, {
"at": 4, "name": "reach", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Float64"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0x83261bdaea7017eb", "kind": "interface",
"name": "ShareEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xf191a55d39c3919f"}]}]}, {"id": "@0xf191a55d39c3919f", "kind": "struct",
"name": "ShareStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "share", "is": "Float64"}, {"at": 4, "name": "reach", "is": "Float64"}]}]})json";

}  // namespace
}  // namespace contracts

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<contracts::Share>() {
  static constexpr InterfaceInfo kInfo{
      .name = "contracts::Share",
      .hash = "24b07ee8040a6cd1db8f86c280245892",
      .description = contracts::kShareDescription,
      .commands = contracts::kShareCommands,
      .events = {},
      .codec = &contracts::shareCodec,
  };
  return kInfo;
}

// A function for each command of contracts::Share, so that a stack in a debugger names it.
struct Provided<contracts::Share>::Dispatch {
  static Errc execute_share(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.share(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_shares(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                             std::byte* result) {
    const auto& slot = slotIn<contracts::ShareSharesArguments>(arguments);
    load(slot.all, scratch.shares_all);
    auto& answer = newSlot<std::int32_t>(result);
    return store(implementation.shares(scratch.shares_all), answer) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_take(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                           std::byte* result) {
    const auto& slot = slotIn<contracts::ShareTakeArguments>(arguments);
    load(slot.wanted, scratch.take_wanted);
    auto& answer = newSlot<double>(result);
    return store(implementation.take(scratch.take_wanted), answer) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_reach(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<double>(result);
    return store(implementation.reach(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<contracts::Share>::execute(std::uint16_t command, const std::byte* arguments,
                                         std::byte* result) {
  using ::contracts::ShareCommand;
  switch (command) {
    case ShareCommand::share: return Dispatch::execute_share(implementation_, result);
    case ShareCommand::shares:
      return Dispatch::execute_shares(implementation_, scratch_, arguments, result);
    case ShareCommand::take:
      return Dispatch::execute_take(implementation_, scratch_, arguments, result);
    case ShareCommand::reach: return Dispatch::execute_reach(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
