// Written by suturec from bench/block_loop.h. Do not edit.
#include "bench/block_loop.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace bench {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(SmallBlock::bytes), std::vector<std::uint8_t>>);
static_assert(std::is_same_v<decltype(LargeBlock::bytes), std::vector<std::uint8_t>>);

}  // namespace

bool store(const SmallBlock& value, SmallBlockSlot& slot) {
  bool fits = true;
  fits &= store(value.bytes, slot.bytes);
  return fits;
}

void load(const SmallBlockSlot& slot, SmallBlock& value) {
  load(slot.bytes, value.bytes);
}

void reserve(const SmallBlockSlot*, SmallBlock& value) {
  suture::reserveFor<decltype(SmallBlockSlot::bytes)>(value.bytes);
}

bool store(const LargeBlock& value, LargeBlockSlot& slot) {
  bool fits = true;
  fits &= store(value.bytes, slot.bytes);
  return fits;
}

void load(const LargeBlockSlot& slot, LargeBlock& value) {
  load(slot.bytes, value.bytes);
}

void reserve(const LargeBlockSlot*, LargeBlock& value) {
  suture::reserveFor<decltype(LargeBlockSlot::bytes)>(value.bytes);
}

bool store(const SmallBlock& block, SmallBlocksBounceArguments& slot) {
  return store(block, slot.block);
}

bool store(const LargeBlock& block, LargeBlocksBounceArguments& slot) {
  return store(block, slot.block);
}

bool isValid(const SmallBlockSlot&, suture::FieldPath*) {
  return true;
}

bool isValid(const LargeBlockSlot&, suture::FieldPath*) {
  return true;
}

// Defined in bench/block_loop.wire.cpp.
const suture::codec::Codec& smallBlocksCodec();
const suture::codec::Codec& largeBlocksCodec();

namespace {

bool acceptsSmallBlocksBounce(const SmallBlocksBounceArguments& slot, suture::FieldPath* path) {
  return isValid(slot.block, path) || suture::refusedAt(path, "block");
}

constexpr suture::CommandInfo kSmallBlocksCommands[] = {
    {.name = "bounce",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<SmallBlocksBounceArguments>,
     .depth = 2,
     .accepts = suture::checkSlot<SmallBlocksBounceArguments, acceptsSmallBlocksBounce>},
};

constexpr suture::EventInfo kSmallBlocksEvents[] = {
    {.name = "echo",
     .payloadSize = suture::slotSize<SmallBlockSlot>,
     .depth = 2,
     .accepts = suture::checkSlot<SmallBlockSlot, isValid>},
};

// The self-description, as in bench/block_loop.suture.json.
constexpr char kSmallBlocksDescription[] = R"json(
{"name": "bench::SmallBlocks", "hash": "9644ae191aee8643817b33285b8929dd", "commands": [{
"name": "bounce", "kind": "write", "ordinal": 1,
"doc": "Client, server, client: sends the block back as the event echo.", "parameters": [{
"name": "block", "type": {"kind": "struct", "name": "bench::SmallBlock"}}], "queue": 2}],
"events": [{"name": "echo", "kind": "write", "ordinal": 1, "payload": {"type": {"kind": "struct",
"name": "bench::SmallBlock"}}, "queue": 2}], "enums": [], "structs": [{"name": "bench::SmallBlock",
"doc": "As large as a pose.", "fields": [{"name": "bytes", "type": {"kind": "list", "element": {
"kind": "UInt8"}, "capacity": 120}}]}], "wire": [{"id": "@0xa0a4d60db53264a8", "kind": "interface",
"name": "SmallBlocks", "cxx": "bench::SmallBlocks", "members": [{"at": 0, "name": "subscribe",
"parameters": [{"at": 0, "name": "events", "is": "@0xf92746b2d211fcbe"}, {"at": 1,
"name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1,
"name": "bounce", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "block",
"is": "@0xbed5520df9ca5c0d"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}]}, {
"id": "@0xf92746b2d211fcbe", "kind": "interface", "name": "SmallBlocksEvents", "members": [{
"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xb2befd803231da25"}]}, {
"at": 1, "name": "echo", "parameters": [{"at": 0, "name": "value", "is": "@0xbed5520df9ca5c0d"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xb2befd803231da25", "kind": "struct",
"name": "SmallBlocksStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}]}, {
"id": "@0xbed5520df9ca5c0d", "kind": "struct", "name": "SmallBlock", "members": [{"at": 0,
"name": "bytes", "is": "Data"}]}]})json";

bool acceptsLargeBlocksBounce(const LargeBlocksBounceArguments& slot, suture::FieldPath* path) {
  return isValid(slot.block, path) || suture::refusedAt(path, "block");
}

constexpr suture::BoundedLevel kLargeBlocksBounceArgumentsLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 1048576>>(offsetof(LargeBlocksBounceArguments,
                                                                         block.bytes)),
};

constexpr suture::CommandInfo kLargeBlocksCommands[] = {
    {.name = "bounce",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<LargeBlocksBounceArguments>,
     .depth = 2,
     .accepts = suture::checkSlot<LargeBlocksBounceArguments, acceptsLargeBlocksBounce>,
     .argumentsLevels = kLargeBlocksBounceArgumentsLevels},
};

constexpr suture::BoundedLevel kLargeBlocksEchoPayloadLevels[] = {
    suture::levelAt<suture::BoundedList<std::uint8_t, 1048576>>(offsetof(LargeBlockSlot, bytes)),
};

constexpr suture::EventInfo kLargeBlocksEvents[] = {
    {.name = "echo",
     .payloadSize = suture::slotSize<LargeBlockSlot>,
     .depth = 2,
     .accepts = suture::checkSlot<LargeBlockSlot, isValid>,
     .payloadLevels = kLargeBlocksEchoPayloadLevels},
};

// The self-description, as in bench/block_loop.suture.json.
constexpr char kLargeBlocksDescription[] = R"json(
{"name": "bench::LargeBlocks", "hash": "e0200f5ded74b3c42339f7d72e4da4d0", "commands": [{
"name": "bounce", "kind": "write", "ordinal": 1,
"doc": "Client, server, client: sends the block back as the event echo.", "parameters": [{
"name": "block", "type": {"kind": "struct", "name": "bench::LargeBlock"}}], "queue": 2}],
"events": [{"name": "echo", "kind": "write", "ordinal": 1, "payload": {"type": {"kind": "struct",
"name": "bench::LargeBlock"}}, "queue": 2}], "enums": [], "structs": [{"name": "bench::LargeBlock",
"doc": "As large as an image at most.", "fields": [{"name": "bytes", "type": {"kind": "list",
"element": {"kind": "UInt8"}, "capacity": 1048576}}]}], "wire": [{"id": "@0xc823fae657e6cd4d",
"kind": "interface", "name": "LargeBlocks", "cxx": "bench::LargeBlocks", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xde18174f4b5898cb"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "bounce", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "block",
"is": "@0xb5fa8205b68955f8"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}]}, {
"id": "@0xde18174f4b5898cb", "kind": "interface", "name": "LargeBlocksEvents", "members": [{
"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xc00ca2fc276d186f"}]}, {
"at": 1, "name": "echo", "parameters": [{"at": 0, "name": "value", "is": "@0xb5fa8205b68955f8"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xc00ca2fc276d186f", "kind": "struct",
"name": "LargeBlocksStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}]}, {
"id": "@0xb5fa8205b68955f8", "kind": "struct", "name": "LargeBlock", "members": [{"at": 0,
"name": "bytes", "is": "Data"}]}]})json";

}  // namespace
}  // namespace bench

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<bench::SmallBlocks>() {
  static constexpr InterfaceInfo kInfo{
      .name = "bench::SmallBlocks",
      .hash = "9644ae191aee8643817b33285b8929dd",
      .description = bench::kSmallBlocksDescription,
      .commands = bench::kSmallBlocksCommands,
      .events = bench::kSmallBlocksEvents,
      .codec = &bench::smallBlocksCodec,
  };
  return kInfo;
}

template <>
const InterfaceInfo& interfaceInfo<bench::LargeBlocks>() {
  static constexpr InterfaceInfo kInfo{
      .name = "bench::LargeBlocks",
      .hash = "e0200f5ded74b3c42339f7d72e4da4d0",
      .description = bench::kLargeBlocksDescription,
      .commands = bench::kLargeBlocksCommands,
      .events = bench::kLargeBlocksEvents,
      .codec = &bench::largeBlocksCodec,
  };
  return kInfo;
}

auto Provided<bench::SmallBlocks>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(bench::SmallBlocksBounceArguments::block)>(scratch.bounce_block);
  return scratch;
}

auto Provided<bench::LargeBlocks>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(bench::LargeBlocksBounceArguments::block)>(scratch.bounce_block);
  return scratch;
}

// A function for each command of bench::SmallBlocks, so that a stack in a debugger names it.
struct Provided<bench::SmallBlocks>::Dispatch {
  static Errc execute_bounce(Contract& implementation, Scratch& scratch,
                             const std::byte* arguments) {
    const auto& slot = slotIn<bench::SmallBlocksBounceArguments>(arguments);
    load(slot.block, scratch.bounce_block);
    implementation.bounce(scratch.bounce_block);
    return Errc{};
  }
};

Errc Provided<bench::SmallBlocks>::execute(std::uint16_t command, const std::byte* arguments,
                                           std::byte* /*result*/) {
  using ::bench::SmallBlocksCommand;
  switch (command) {
    case SmallBlocksCommand::bounce:
      return Dispatch::execute_bounce(implementation_, scratch_, arguments);
  }
  return Errc::Invalid;
}

// A function for each command of bench::LargeBlocks, so that a stack in a debugger names it.
struct Provided<bench::LargeBlocks>::Dispatch {
  static Errc execute_bounce(Contract& implementation, Scratch& scratch,
                             const std::byte* arguments) {
    const auto& slot = slotIn<bench::LargeBlocksBounceArguments>(arguments);
    load(slot.block, scratch.bounce_block);
    implementation.bounce(scratch.bounce_block);
    return Errc{};
  }
};

Errc Provided<bench::LargeBlocks>::execute(std::uint16_t command, const std::byte* arguments,
                                           std::byte* /*result*/) {
  using ::bench::LargeBlocksCommand;
  switch (command) {
    case LargeBlocksCommand::bounce:
      return Dispatch::execute_bounce(implementation_, scratch_, arguments);
  }
  return Errc::Invalid;
}

}  // namespace suture
