// Written by suturec from shapes/open.h. Do not edit.
#include "shapes/open.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace shapes {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(Root::value), std::int32_t>);
static_assert(std::is_same_v<decltype(Root::children), std::vector<shapes::Root>>);
static_assert(std::is_same_v<decltype(Root::shadow), std::unique_ptr<shapes::Root>>);
static_assert(std::is_same_v<decltype(Root::branches), std::vector<shapes::Branch>>);
static_assert(std::is_same_v<decltype(Branch::length), double>);
static_assert(std::is_same_v<decltype(Branch::roots), std::map<std::string, shapes::Root>>);
static_assert(std::is_same_v<decltype(Open::name), std::string>);
static_assert(std::is_same_v<decltype(Open::samples), std::vector<double>>);
static_assert(std::is_same_v<decltype(Open::bytes), std::vector<std::uint8_t>>);
static_assert(std::is_same_v<decltype(Open::block), std::vector<float>>);
static_assert(std::is_same_v<decltype(Open::flags), std::vector<bool>>);
static_assert(std::is_same_v<decltype(Open::path), std::deque<shapes::Point>>);
static_assert(std::is_same_v<decltype(Open::pair), std::array<std::string, 2>>);
static_assert(std::is_same_v<decltype(Open::words), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(Open::shorts), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(Open::keys), std::set<std::string>>);
static_assert(std::is_same_v<decltype(Open::series),
                             std::map<std::string, std::vector<shapes::Point>>>);
static_assert(std::is_same_v<decltype(Open::note), std::optional<std::string>>);
static_assert(std::is_same_v<decltype(Open::either),
                             std::variant<std::monostate, std::string, shapes::Point>>);
static_assert(std::is_same_v<decltype(Open::entry), std::tuple<std::int32_t, std::string>>);
static_assert(std::is_same_v<decltype(Open::joints), Eigen::VectorXd>);
static_assert(std::is_same_v<decltype(Open::any), Eigen::MatrixXd>);
static_assert(std::is_same_v<decltype(Open::wide), Eigen::MatrixXd>);
static_assert(std::is_same_v<decltype(Open::cloud), std::vector<Eigen::Vector3d>>);
static_assert(std::is_same_v<decltype(Open::image), Eigen::MatrixXd>);
static_assert(std::is_same_v<decltype(Open::root), Root>);

}  // namespace

bool store(const Root& value, RootSlot& slot) {
  bool fits = true;
  fits &= store(value.value, slot.value);
  fits &= store(value.children, slot.children);
  fits &= store(value.shadow, slot.shadow);
  fits &= store(value.branches, slot.branches);
  return fits;
}

void load(const RootSlot& slot, Root& value) {
  load(slot.value, value.value);
  load(slot.children, value.children);
  load(slot.shadow, value.shadow);
  load(slot.branches, value.branches);
}

bool store(const Branch& value, BranchSlot& slot) {
  bool fits = true;
  fits &= store(value.length, slot.length);
  fits &= store(value.roots, slot.roots);
  return fits;
}

void load(const BranchSlot& slot, Branch& value) {
  load(slot.length, value.length);
  load(slot.roots, value.roots);
}

bool store(const Open& value, OpenSlot& slot) {
  bool fits = true;
  fits &= store(value.name, slot.name);
  fits &= store(value.samples, slot.samples);
  fits &= store(value.bytes, slot.bytes);
  fits &= store(value.block, slot.block);
  fits &= store(value.flags, slot.flags);
  fits &= store(value.path, slot.path);
  fits &= store(value.pair, slot.pair);
  fits &= store(value.words, slot.words);
  fits &= store(value.shorts, slot.shorts);
  fits &= store(value.keys, slot.keys);
  fits &= store(value.series, slot.series);
  fits &= store(value.note, slot.note);
  fits &= store(value.either, slot.either);
  fits &= store(value.entry, slot.entry);
  fits &= store(value.joints, slot.joints);
  fits &= store(value.any, slot.any);
  fits &= store(value.wide, slot.wide);
  fits &= store(value.cloud, slot.cloud);
  fits &= store(value.image, slot.image);
  fits &= store(value.root, slot.root);
  return fits;
}

void load(const OpenSlot& slot, Open& value) {
  load(slot.name, value.name);
  load(slot.samples, value.samples);
  load(slot.bytes, value.bytes);
  load(slot.block, value.block);
  load(slot.flags, value.flags);
  load(slot.path, value.path);
  load(slot.pair, value.pair);
  load(slot.words, value.words);
  load(slot.shorts, value.shorts);
  load(slot.keys, value.keys);
  load(slot.series, value.series);
  load(slot.note, value.note);
  load(slot.either, value.either);
  load(slot.entry, value.entry);
  load(slot.joints, value.joints);
  load(slot.any, value.any);
  load(slot.wide, value.wide);
  load(slot.cloud, value.cloud);
  load(slot.image, value.image);
  load(slot.root, value.root);
}

void reserve(const OpenSlot*, Open& value) {
  suture::reserveFor<decltype(OpenSlot::words)>(value.words);
}

bool store(const std::string& key, const Open& value, ArchivePutArguments& slot) {
  return store(key, slot.key) && store(value, slot.value);
}

bool store(const std::string& text, ArchiveRemarkArguments& slot) { return store(text, slot.text); }

bool store(const std::string& pattern, ArchiveFindArguments& slot) {
  return store(pattern, slot.pattern);
}

bool store(const Open& value, ArchiveReplaceArguments& slot) { return store(value, slot.value); }

bool store(const std::string& value, const Root& value2, ArchiveGrownPayload& slot) {
  return store(value, slot.value) && store(value2, slot.value2);
}

void load(const ArchiveGrownPayload& slot, std::string& value, Root& value2) {
  load(slot.value, value);
  load(slot.value2, value2);
}

bool isValid(const RootSlot& slot, suture::FieldPath* path) {
  if (!suture::allOf(slot.children, path, [path](const RootSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "children");
  }
  if (!isValid(slot.shadow, path)) return suture::refusedAt(path, "shadow");
  if (!suture::allOf(slot.branches, path, [path](const BranchSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "branches");
  }
  return true;
}

bool isValid(const BranchSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.length, 0, 10)) return suture::refusedAt(path, "length");
  return isValid(slot.roots, path) || suture::refusedAt(path, "roots");
}

bool isValid(const OpenSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.samples, path)) return suture::refusedAt(path, "samples");
  if (!isValid(slot.block, path)) return suture::refusedAt(path, "block");
  if (!suture::allOf(slot.path, path, [path](const PointSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "path");
  }
  if (!isValid(slot.series, path)) return suture::refusedAt(path, "series");
  if (!isValid(slot.either, path)) return suture::refusedAt(path, "either");
  if (!isValid(slot.joints, path)) return suture::refusedAt(path, "joints");
  if (!suture::allOf(slot.any, nullptr, [](double element) {
    return suture::inRange(element, -1, 1);
  })) {
    return suture::refusedAt(path, "any");
  }
  if (!isValid(slot.wide)) return suture::refusedAt(path, "wide");
  if (!suture::allOf(slot.cloud, path, [path](const std::array<double, 3>& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "cloud");
  }
  if (!isValid(slot.image)) return suture::refusedAt(path, "image");
  return isValid(slot.root, path) || suture::refusedAt(path, "root");
}

// Defined in shapes/open.wire.cpp.
const suture::codec::Codec& archiveCodec();

namespace {

bool acceptsArchivePut(const ArchivePutArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsArchiveReplace(const ArchiveReplaceArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsArchiveGrownEvent(const ArchiveGrownPayload& slot, suture::FieldPath* path) {
  return isValid(slot.value2, path) || suture::refusedAt(path, "value2");
}

constexpr suture::CommandInfo kArchiveCommands[] = {
    {.name = "put",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArchivePutArguments>,
     .depth = 16,
     .sharedArguments = true,
     .accepts = suture::checkSlot<ArchivePutArguments, acceptsArchivePut>},
    {.name = "remark",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<ArchiveRemarkArguments>,
     .depth = 16,
     .latest = true,
     .sharedArguments = true},
    {.name = "newest",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<OpenSlot>,
     .depth = 16,
     .column = ArchiveColumn::newest,
     .sharedResult = true,
     .acceptsResult = suture::checkSlot<OpenSlot, isValid>},
    {.name = "find",
     .kind = suture::CommandKind::QualifiedRead,
     .argumentsSize = suture::slotSize<ArchiveFindArguments>,
     .resultSize = suture::slotSize<suture::OpenList<suture::OpenText>>,
     .depth = 16,
     .sharedArguments = true,
     .sharedResult = true},
    {.name = "replace",
     .kind = suture::CommandKind::WriteReturn,
     .argumentsSize = suture::slotSize<ArchiveReplaceArguments>,
     .resultSize = suture::slotSize<OpenSlot>,
     .depth = 16,
     .sharedArguments = true,
     .sharedResult = true,
     .accepts = suture::checkSlot<ArchiveReplaceArguments, acceptsArchiveReplace>,
     .acceptsResult = suture::checkSlot<OpenSlot, isValid>},
};

constexpr suture::EventInfo kArchiveEvents[] = {
    {.name = "renamed",
     .payloadSize = suture::slotSize<suture::OpenText>,
     .depth = 16,
     .latched = true,
     .sharedPayload = true},
    {.name = "grown",
     .payloadSize = suture::slotSize<ArchiveGrownPayload>,
     .depth = 16,
     .sharedPayload = true,
     .accepts = suture::checkSlot<ArchiveGrownPayload, acceptsArchiveGrownEvent>},
    {.name = "changed",
     .payloadSize = suture::slotSize<OpenSlot>,
     .depth = 16,
     .latest = true,
     .sharedPayload = true,
     .accepts = suture::checkSlot<OpenSlot, isValid>},
};

// The self-description, as in shapes/open.suture.json.
constexpr char kArchiveDescription[] = R"json(
{"name": "shapes::Archive", "doc": "What a device may offer.",
"hash": "edf51db6763ba6c59e6fa31b08344c89", "commands": [{"name": "put", "kind": "write",
"ordinal": 1, "doc": "Keeps `value` under `key`.", "parameters": [{"name": "key", "type": {
"kind": "text"}}, {"name": "value", "type": {"kind": "struct", "name": "shapes::Open"}}],
"queue": 16}, {"name": "remark", "kind": "write", "ordinal": 2, "parameters": [{"name": "text",
"type": {"kind": "text"}}], "queue": 16, "latest": true}, {"name": "newest", "kind": "read",
"ordinal": 3, "result": {"type": {"kind": "struct", "name": "shapes::Open"}}, "queue": 16}, {
"name": "find", "kind": "qualified read", "ordinal": 4, "parameters": [{"name": "pattern", "type": {
"kind": "text"}}], "result": {"type": {"kind": "list", "element": {"kind": "text"}}}, "queue": 16},
{"name": "replace", "kind": "write with return", "ordinal": 5, "parameters": [{"name": "value",
"type": {"kind": "struct", "name": "shapes::Open"}}], "result": {"type": {"kind": "struct",
"name": "shapes::Open"}}, "queue": 16}], "events": [{"name": "renamed", "kind": "write",
"ordinal": 1, "payload": {"type": {"kind": "text"}}, "queue": 16, "latched": true}, {
"name": "grown", "kind": "write", "ordinal": 2, "payload": [{"name": "value", "type": {
"kind": "text"}}, {"name": "value2", "type": {"kind": "struct", "name": "shapes::Root"}}],
"queue": 16}, {"name": "changed", "kind": "write", "ordinal": 3, "payload": {"type": {
"kind": "struct", "name": "shapes::Open"}}, "queue": 16, "latest": true}], "enums": [], "structs": [
{"name": "shapes::Point", "doc": "Parts of other types.", "fields": [{"name": "x", "type": {
"kind": "Float64"}, "unit": "m", "range": [-10.0, 10.0], "default": 0.0}, {"name": "y", "type": {
"kind": "Float64"}, "default": 0.0}]}, {"name": "shapes::Branch", "fields": [{"name": "length",
"type": {"kind": "Float64"}, "unit": "m", "range": [0.0, 10.0], "default": 0.0}, {"name": "roots",
"type": {"kind": "map", "key": {"kind": "text"}, "value": {"kind": "struct", "name": "shapes::Root"
}}}]}, {"name": "shapes::Root", "doc": "Holds itself, and another that holds it.", "fields": [{
"name": "value", "type": {"kind": "Int32"}, "default": 0}, {"name": "children", "type": {
"kind": "list", "element": {"kind": "struct", "name": "shapes::Root"}}}, {"name": "shadow",
"type": {"kind": "optional", "element": {"kind": "struct", "name": "shapes::Root"}}}, {
"name": "branches", "type": {"kind": "list", "element": {"kind": "struct", "name": "shapes::Branch"
}}}]}, {"name": "shapes::Open", "doc": "Each level that may lack its bound, all of it or a part.",
"fields": [{"name": "name", "type": {"kind": "text"}}, {"name": "samples", "type": {"kind": "list",
"element": {"kind": "Float64"}}}, {"name": "bytes", "type": {"kind": "list", "element": {
"kind": "UInt8"}}}, {"name": "block", "type": {"kind": "list", "element": {"kind": "Float32"},
"bulk": true}}, {"name": "flags", "type": {"kind": "list", "element": {"kind": "Bool"}}}, {
"name": "path", "type": {"kind": "list", "element": {"kind": "struct", "name": "shapes::Point"}}}, {
"name": "pair", "type": {"kind": "array", "element": {"kind": "text"}, "length": 2}}, {
"name": "words", "type": {"kind": "list", "element": {"kind": "text"}, "capacity": 2}}, {
"name": "shorts", "type": {"kind": "list", "element": {"kind": "text", "capacity": 3}}}, {
"name": "keys", "type": {"kind": "set", "element": {"kind": "text"}}}, {"name": "series", "type": {
"kind": "map", "key": {"kind": "text"}, "value": {"kind": "list", "element": {"kind": "struct",
"name": "shapes::Point"}}}}, {"name": "note", "type": {"kind": "optional", "element": {
"kind": "text"}}}, {"name": "either", "type": {"kind": "variant", "alternatives": [{
"kind": "nothing"}, {"kind": "text"}, {"kind": "struct", "name": "shapes::Point"}]}}, {
"name": "entry", "type": {"kind": "tuple", "elements": [{"kind": "Int32"}, {"kind": "text"}]}}, {
"name": "joints", "type": {"kind": "list", "element": {"kind": "Float64"}}}, {"name": "any",
"type": {"kind": "any matrix", "scalar": "Float64"}, "range": [-1.0, 1.0]}, {"name": "wide",
"type": {"kind": "any matrix", "scalar": "Float64", "capacity": [2, null]}}, {"name": "cloud",
"type": {"kind": "list", "element": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1
}}}, {"name": "image", "type": {"kind": "any matrix", "scalar": "Float64", "bulk": true}}, {
"name": "root", "type": {"kind": "struct", "name": "shapes::Root"}}]}], "wire": [{
"id": "@0x82933d261358e2a1", "kind": "interface", "name": "Archive", "cxx": "shapes::Archive",
"members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0, "name": "events",
"is": "@0xbd8392db1e3ed150"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2,
"name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "put", "is": "kind \"write\"",
"parameters": [{"at": 0, "name": "key", "is": "Text"}, {"at": 1, "name": "value",
"is": "@0xc2c5885ffab9947b"}, {"at": 2, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "remark", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "text",
"is": "Text"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 3,
"name": "newest", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xc2c5885ffab9947b"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4, "name": "find",
"is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "pattern", "is": "Text"}, {
"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value",
"is": "List(Text)"}]}, {"at": 5, "name": "replace", "is": "kind \"writeReturn\"", "parameters": [{
"at": 0, "name": "value", "is": "@0xc2c5885ffab9947b"}, {"at": 1, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xc2c5885ffab9947b"
}]}]}, {"id": "@0xbd8392db1e3ed150", "kind": "interface", "name": "ArchiveEvents", "members": [{
"at": 0, "name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xb725b4164d7d1953"}]}, {
"at": 1, "name": "renamed", "parameters": [{"at": 0, "name": "value", "is": "Text"}, {"at": 1,
"name": "stamp", "is": "Int64"}]}, {"at": 2, "name": "grown", "parameters": [{"at": 0,
"name": "value", "is": "Text"}, {"at": 1, "name": "value2", "is": "@0xb6460a48efc46784"}, {"at": 2,
"name": "stamp", "is": "Int64"}]}, {"at": 3, "name": "changed", "parameters": [{"at": 0,
"name": "value", "is": "@0xc2c5885ffab9947b"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xb725b4164d7d1953", "kind": "struct", "name": "ArchiveStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "newest", "is": "@0xc2c5885ffab9947b"}]}, {
"id": "@0xc2c5885ffab9947b", "kind": "struct", "name": "Open", "members": [{"at": 0, "name": "name",
"is": "Text"}, {"at": 1, "name": "samples", "is": "List(Float64)"}, {"at": 2, "name": "bytes",
"is": "Data"}, {"at": 3, "name": "block", "is": "Data bulk \"Float32\""}, {"at": 4, "name": "flags",
"is": "List(Bool)"}, {"at": 5, "name": "path", "is": "List(@0xb51a57f43829556b)"}, {"at": 6,
"name": "pair", "is": "List(Text) shape \"2\""}, {"at": 7, "name": "words", "is": "List(Text)"}, {
"at": 8, "name": "shorts", "is": "List(Text)"}, {"at": 9, "name": "keys", "is": "List(Text)"}, {
"at": 10, "name": "series", "is": "List(@0xa8c3533e6eb12f51)"}, {"at": 11, "name": "note",
"is": "@0xf3c25d3461f00058"}, {"at": 12, "name": "either", "is": "@0xbb3bebe320b04d4f"}, {"at": 13,
"name": "entry", "is": "@0x869c92dc4e541a10"}, {"at": 14, "name": "joints", "is": "List(Float64)"},
{"at": 15, "name": "any", "is": "@0xcf0d7516d71f233a"}, {"at": 16, "name": "wide",
"is": "@0xcf0d7516d71f233a"}, {"at": 17, "name": "cloud", "is": "List(Float64) shape \"*,3x1\""}, {
"at": 18, "name": "image", "is": "@0x891c2f0f0cffc982"}, {"at": 19, "name": "root",
"is": "@0xb6460a48efc46784"}]}, {"id": "@0xb51a57f43829556b", "kind": "struct", "name": "Point",
"members": [{"at": 0, "name": "x", "is": "Float64 unit \"m\""}, {"at": 1, "name": "y",
"is": "Float64"}]}, {"id": "@0xa8c3533e6eb12f51", "kind": "struct",
"name": "ShapesOpenEntryOfTextToListOfPoint", "members": [{"at": 0, "name": "key", "is": "Text"}, {
"at": 1, "name": "value", "is": "List(@0xb51a57f43829556b)"}]}, {"id": "@0xf3c25d3461f00058",
"kind": "union", "name": "ShapesOpenOptionalText", "members": [{"at": 0, "name": "none",
"is": "Void"}, {"at": 1, "name": "some", "is": "Text"}]}, {"id": "@0xbb3bebe320b04d4f",
"kind": "union", "name": "ShapesOpenEitherOfNothingOrTextOrPoint", "members": [{"at": 0,
"name": "nothing", "is": "Void"}, {"at": 1, "name": "text", "is": "Text"}, {"at": 2,
"name": "point", "is": "@0xb51a57f43829556b"}]}, {"id": "@0x869c92dc4e541a10", "kind": "struct",
"name": "ShapesOpenTupleOfInt32AndText", "members": [{"at": 0, "name": "item0", "is": "Int32"}, {
"at": 1, "name": "item1", "is": "Text"}]}, {"id": "@0xcf0d7516d71f233a", "kind": "struct",
"name": "ShapesOpenAnyMatrixOfFloat64", "members": [{"at": 0, "name": "rows", "is": "UInt32"}, {
"at": 1, "name": "columns", "is": "UInt32"}, {"at": 2, "name": "data", "is": "List(Float64)"}]}, {
"id": "@0x891c2f0f0cffc982", "kind": "struct", "name": "ShapesOpenBulkMatrixOfFloat64", "members": [
{"at": 0, "name": "rows", "is": "UInt32"}, {"at": 1, "name": "columns", "is": "UInt32"}, {"at": 2,
"name": "data", "is": "Data bulk \"Float64\""}]}, {"id": "@0xb6460a48efc46784", "kind": "struct",
"name": "Root", "members": [{"at": 0, "name": "value", "is": "Int32"}, {"at": 1, "name": "children",
"is": "List(@0xb6460a48efc46784)"}, {"at": 2, "name": "shadow", "is": "@0x91179475335c1f6c"}, {
"at": 3, "name": "branches", "is": "List(@0xd99efb214b19eb29)"}]}, {"id": "@0x91179475335c1f6c",
"kind": "union", "name": "ShapesOpenOptionalRoot", "members": [{"at": 0, "name": "none",
"is": "Void"}, {"at": 1, "name": "some", "is": "@0xb6460a48efc46784"}]}, {
"id": "@0xd99efb214b19eb29", "kind": "struct", "name": "Branch", "members": [{"at": 0,
"name": "length", "is": "Float64 unit \"m\""}, {"at": 1, "name": "roots",
"is": "List(@0xbc7d41300052e004)"}]}, {"id": "@0xbc7d41300052e004", "kind": "struct",
"name": "ShapesOpenEntryOfTextToRoot", "members": [{"at": 0, "name": "key", "is": "Text"}, {
"at": 1, "name": "value", "is": "@0xb6460a48efc46784"}]}]})json";

}  // namespace
}  // namespace shapes

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<shapes::Archive>() {
  static constexpr InterfaceInfo kInfo{
      .name = "shapes::Archive",
      .hash = "edf51db6763ba6c59e6fa31b08344c89",
      .description = shapes::kArchiveDescription,
      .commands = shapes::kArchiveCommands,
      .events = shapes::kArchiveEvents,
      .codec = &shapes::archiveCodec,
  };
  return kInfo;
}

auto Provided<shapes::Archive>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(shapes::ArchivePutArguments::value)>(scratch.put_value);
  reserveFor<decltype(shapes::ArchiveReplaceArguments::value)>(scratch.replace_value);
  return scratch;
}

// A function for each command of shapes::Archive, so that a stack in a debugger names it.
struct Provided<shapes::Archive>::Dispatch {
  static Errc execute_put(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<shapes::ArchivePutArguments>(arguments);
    load(slot.key, scratch.put_key);
    load(slot.value, scratch.put_value);
    implementation.put(scratch.put_key, scratch.put_value);
    return Errc{};
  }

  static Errc execute_remark(Contract& implementation, Scratch& scratch,
                             const std::byte* arguments) {
    const auto& slot = slotIn<shapes::ArchiveRemarkArguments>(arguments);
    load(slot.text, scratch.remark_text);
    implementation.remark(scratch.remark_text);
    return Errc{};
  }

  static Errc execute_newest(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<shapes::OpenSlot>(result);
    return store(implementation.newest(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_find(Contract& implementation, Scratch& scratch, const std::byte* arguments,
                           std::byte* result) {
    const auto& slot = slotIn<shapes::ArchiveFindArguments>(arguments);
    load(slot.pattern, scratch.find_pattern);
    auto& answer = newSlot<suture::OpenList<suture::OpenText>>(result);
    return store(implementation.find(scratch.find_pattern), answer) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_replace(Contract& implementation, Scratch& scratch,
                              const std::byte* arguments, std::byte* result) {
    const auto& slot = slotIn<shapes::ArchiveReplaceArguments>(arguments);
    load(slot.value, scratch.replace_value);
    auto& answer = newSlot<shapes::OpenSlot>(result);
    return store(implementation.replace(scratch.replace_value), answer) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<shapes::Archive>::execute(std::uint16_t command, const std::byte* arguments,
                                        std::byte* result) {
  using ::shapes::ArchiveCommand;
  switch (command) {
    case ArchiveCommand::put: return Dispatch::execute_put(implementation_, scratch_, arguments);
    case ArchiveCommand::remark:
      return Dispatch::execute_remark(implementation_, scratch_, arguments);
    case ArchiveCommand::newest: return Dispatch::execute_newest(implementation_, result);
    case ArchiveCommand::find:
      return Dispatch::execute_find(implementation_, scratch_, arguments, result);
    case ArchiveCommand::replace:
      return Dispatch::execute_replace(implementation_, scratch_, arguments, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
