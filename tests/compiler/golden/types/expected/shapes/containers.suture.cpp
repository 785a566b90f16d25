// Written by suturec from shapes/containers.h. Do not edit.
#include "shapes/containers.suture.h"

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
static_assert(std::is_same_v<std::underlying_type_t<Level>, std::int16_t>);
static_assert(static_cast<std::int16_t>(Level::Unknown) == -1);
static_assert(static_cast<std::int16_t>(Level::Low) == 10);
static_assert(static_cast<std::int16_t>(Level::High) == 300);
static_assert(std::is_same_v<decltype(Point::x), double>);
static_assert(std::is_same_v<decltype(Point::y), double>);
static_assert(std::is_same_v<decltype(Sequences::bytes), std::vector<std::byte>>);
static_assert(std::is_same_v<decltype(Sequences::one), std::byte>);
static_assert(std::is_same_v<decltype(Sequences::row), double[3]>);
static_assert(std::is_same_v<decltype(Sequences::grid), std::int32_t[2][3]>);
static_assert(std::is_same_v<decltype(Sequences::corners), Point[2]>);
static_assert(std::is_same_v<decltype(Sequences::path), std::deque<shapes::Point>>);
static_assert(std::is_same_v<decltype(Sequences::bits), std::deque<bool>>);
static_assert(std::is_same_v<decltype(Sequences::flags), std::vector<bool>>);
static_assert(std::is_same_v<decltype(Sequences::numbers), std::set<std::int32_t, std::less<>>>);
static_assert(std::is_same_v<decltype(Sequences::words), std::unordered_set<std::string>>);
static_assert(std::is_same_v<decltype(Sequences::levels), std::set<shapes::Level>>);
static_assert(std::is_same_v<decltype(Sequences::gains),
                             std::map<std::string, double, std::less<>>>);
static_assert(std::is_same_v<decltype(Sequences::points),
                             std::unordered_map<std::uint16_t, shapes::Point>>);
static_assert(std::is_same_v<decltype(Sequences::series),
                             std::map<std::string, std::vector<float>>>);
static_assert(std::is_same_v<decltype(Sequences::shares), std::map<shapes::Level, double>>);
static_assert(std::is_same_v<decltype(Choices::gain), std::optional<double>>);
static_assert(std::is_same_v<decltype(Choices::share), std::optional<double>>);
static_assert(std::is_same_v<decltype(Choices::answer), std::optional<bool>>);
static_assert(std::is_same_v<decltype(Choices::frame), std::optional<std::string>>);
static_assert(std::is_same_v<decltype(Choices::target), std::optional<shapes::Point>>);
static_assert(std::is_same_v<decltype(Choices::polygon),
                             std::optional<std::vector<shapes::Point>>>);
static_assert(std::is_same_v<decltype(Choices::twice), std::optional<std::optional<std::int32_t>>>);
static_assert(std::is_same_v<decltype(Choices::seen), std::vector<std::optional<Eigen::Vector3d>>>);
static_assert(std::is_same_v<decltype(Choices::entry), std::pair<std::int32_t, double>>);
static_assert(std::is_same_v<decltype(Choices::triple),
                             std::tuple<bool, std::string, shapes::Point>>);
static_assert(std::is_same_v<decltype(Choices::either),
                             std::variant<std::monostate, double, shapes::Point, std::string, double>>);
static_assert(std::is_same_v<decltype(Choices::nested),
                             std::variant<shapes::Level, std::optional<shapes::Point>>>);
static_assert(std::is_same_v<decltype(Choices::owned), std::unique_ptr<shapes::Point>>);
static_assert(std::is_same_v<decltype(Choices::rated), std::pair<double, shapes::Level>>);
static_assert(std::is_same_v<decltype(Matrices::joints), Eigen::VectorXd>);
static_assert(std::is_same_v<decltype(Matrices::row), Eigen::RowVectorXd>);
static_assert(std::is_same_v<decltype(Matrices::any), Eigen::MatrixXd>);
static_assert(std::is_same_v<decltype(Matrices::counts),
                             Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic>>);
static_assert(std::is_same_v<decltype(Matrices::columns),
                             Eigen::Matrix<double, 3, Eigen::Dynamic>>);
static_assert(std::is_same_v<decltype(Matrices::limited),
                             Eigen::Matrix<float, Eigen::Dynamic, 1, 0, 5, 1>>);
static_assert(std::is_same_v<decltype(Matrices::fixed), Eigen::Matrix<double, 4, 5>>);
static_assert(std::is_same_v<decltype(Matrices::cloud), std::vector<Eigen::Vector3d>>);
static_assert(std::is_same_v<decltype(Matrices::wrenches), std::deque<Eigen::Matrix<float, 6, 1>>>);
static_assert(std::is_same_v<decltype(Matrices::scaled), Eigen::Affine3d>);
static_assert(std::is_same_v<decltype(Matrices::wait),
                             std::chrono::duration<double, std::ratio<1, 1000>>>);

}  // namespace

bool store(const Point& value, PointSlot& slot) {
  bool fits = true;
  fits &= store(value.x, slot.x);
  fits &= store(value.y, slot.y);
  return fits;
}

void load(const PointSlot& slot, Point& value) {
  load(slot.x, value.x);
  load(slot.y, value.y);
}

bool store(const Sequences& value, SequencesSlot& slot) {
  bool fits = true;
  fits &= store(value.bytes, slot.bytes);
  fits &= store(value.one, slot.one);
  fits &= store(value.row, slot.row);
  fits &= store(value.grid, slot.grid);
  fits &= store(value.corners, slot.corners);
  fits &= store(value.path, slot.path);
  fits &= store(value.bits, slot.bits);
  fits &= store(value.flags, slot.flags);
  fits &= store(value.numbers, slot.numbers);
  fits &= store(value.words, slot.words);
  fits &= store(value.levels, slot.levels);
  fits &= store(value.gains, slot.gains);
  fits &= store(value.points, slot.points);
  fits &= store(value.series, slot.series);
  fits &= store(value.shares, slot.shares);
  return fits;
}

void load(const SequencesSlot& slot, Sequences& value) {
  load(slot.bytes, value.bytes);
  load(slot.one, value.one);
  load(slot.row, value.row);
  load(slot.grid, value.grid);
  load(slot.corners, value.corners);
  load(slot.path, value.path);
  load(slot.bits, value.bits);
  load(slot.flags, value.flags);
  load(slot.numbers, value.numbers);
  load(slot.words, value.words);
  load(slot.levels, value.levels);
  load(slot.gains, value.gains);
  load(slot.points, value.points);
  load(slot.series, value.series);
  load(slot.shares, value.shares);
}

void reserve(const SequencesSlot*, Sequences& value) {
  suture::reserveFor<decltype(SequencesSlot::bytes)>(value.bytes);
  suture::reserveFor<decltype(SequencesSlot::flags)>(value.flags);
}

bool store(const Choices& value, ChoicesSlot& slot) {
  bool fits = true;
  fits &= store(value.gain, slot.gain);
  fits &= store(value.share, slot.share);
  fits &= store(value.answer, slot.answer);
  fits &= store(value.frame, slot.frame);
  fits &= store(value.target, slot.target);
  fits &= store(value.polygon, slot.polygon);
  fits &= store(value.twice, slot.twice);
  fits &= store(value.seen, slot.seen);
  fits &= store(value.entry, slot.entry);
  fits &= store(value.triple, slot.triple);
  fits &= store(value.either, slot.either);
  fits &= store(value.nested, slot.nested);
  fits &= store(value.owned, slot.owned);
  fits &= store(value.rated, slot.rated);
  return fits;
}

void load(const ChoicesSlot& slot, Choices& value) {
  load(slot.gain, value.gain);
  load(slot.share, value.share);
  load(slot.answer, value.answer);
  load(slot.frame, value.frame);
  load(slot.target, value.target);
  load(slot.polygon, value.polygon);
  load(slot.twice, value.twice);
  load(slot.seen, value.seen);
  load(slot.entry, value.entry);
  load(slot.triple, value.triple);
  load(slot.either, value.either);
  load(slot.nested, value.nested);
  load(slot.owned, value.owned);
  load(slot.rated, value.rated);
}

void reserve(const ChoicesSlot*, Choices& value) {
  suture::reserveFor<decltype(ChoicesSlot::seen)>(value.seen);
}

bool store(const Matrices& value, MatricesSlot& slot) {
  bool fits = true;
  fits &= store(value.joints, slot.joints);
  fits &= store(value.row, slot.row);
  fits &= store(value.any, slot.any);
  fits &= store(value.counts, slot.counts);
  fits &= store(value.columns, slot.columns);
  fits &= store(value.limited, slot.limited);
  fits &= store(value.fixed, slot.fixed);
  fits &= store(value.cloud, slot.cloud);
  fits &= store(value.wrenches, slot.wrenches);
  fits &= store(value.scaled, slot.scaled);
  fits &= store(value.wait, slot.wait);
  return fits;
}

void load(const MatricesSlot& slot, Matrices& value) {
  load(slot.joints, value.joints);
  load(slot.row, value.row);
  load(slot.any, value.any);
  load(slot.counts, value.counts);
  load(slot.columns, value.columns);
  load(slot.limited, value.limited);
  load(slot.fixed, value.fixed);
  load(slot.cloud, value.cloud);
  load(slot.wrenches, value.wrenches);
  load(slot.scaled, value.scaled);
  load(slot.wait, value.wait);
}

void reserve(const MatricesSlot*, Matrices& value) {
  suture::reserveFor<decltype(MatricesSlot::cloud)>(value.cloud);
}

bool store(const Sequences& value, StorePutArguments& slot) { return store(value, slot.value); }

bool store(const std::optional<double>& gain, StoreChooseArguments& slot) {
  return store(gain, slot.gain);
}

bool isKnownLevel(std::int16_t slot) {
  switch (static_cast<Level>(slot)) {
    case Level::Unknown:
    case Level::Low:
    case Level::High:
      return true;
  }
  return false;
}

bool isValid(const PointSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.x, -10, 10)) return suture::refusedAt(path, "x");
  return isValid(slot.y) || suture::refusedAt(path, "y");
}

bool isValid(const SequencesSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.row, path)) return suture::refusedAt(path, "row");
  if (!suture::allOf(slot.corners, path, [path](const PointSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "corners");
  }
  if (!suture::allOf(slot.path, path, [path](const PointSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "path");
  }
  if (!suture::allOf(slot.levels, path, [](const std::int16_t& element) {
    return isKnownLevel(element);
  })) {
    return suture::refusedAt(path, "levels");
  }
  if (!isValid(slot.gains, path)) return suture::refusedAt(path, "gains");
  if (!isValid(slot.points, path)) return suture::refusedAt(path, "points");
  if (!isValid(slot.series, path)) return suture::refusedAt(path, "series");
  if (!suture::allOf(slot.shares, path, [](const suture::SlotEntry<std::int16_t, double>& element) {
    return isKnownLevel(element.key) && suture::inRange(element.value, 0, 1);
  })) {
    return suture::refusedAt(path, "shares");
  }
  return true;
}

bool isValid(const ChoicesSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.gain, path)) return suture::refusedAt(path, "gain");
  if (!suture::allOf(slot.share, path, [](const double& element) {
    return suture::inRange(element, 0, 1);
  })) {
    return suture::refusedAt(path, "share");
  }
  if (!isValid(slot.target, path)) return suture::refusedAt(path, "target");
  if (!isValid(slot.polygon, path)) return suture::refusedAt(path, "polygon");
  if (!suture::allOf(slot.seen, path,
                     [path](const suture::SlotOptional<std::array<double, 3>>& element) {
                       return isValid(element, path);
                     })) {
    return suture::refusedAt(path, "seen");
  }
  if (!isValid(slot.entry, path)) return suture::refusedAt(path, "entry");
  if (!isValid(slot.triple, path)) return suture::refusedAt(path, "triple");
  if (!isValid(slot.either, path)) return suture::refusedAt(path, "either");
  if (!suture::theOneOf(slot.nested, path, isKnownLevel, suture::Valid{path})) {
    return suture::refusedAt(path, "nested");
  }
  if (!isValid(slot.owned, path)) return suture::refusedAt(path, "owned");
  return suture::allItems(slot.rated, path, suture::Valid{path}, isKnownLevel) ||
      suture::refusedAt(path, "rated");
}

bool isValid(const MatricesSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.joints, path)) return suture::refusedAt(path, "joints");
  if (!isValid(slot.row, path)) return suture::refusedAt(path, "row");
  if (!isValid(slot.any)) return suture::refusedAt(path, "any");
  if (!suture::allOf(slot.columns, path, [path](const std::array<double, 3>& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "columns");
  }
  if (!isValid(slot.limited, path)) return suture::refusedAt(path, "limited");
  if (!isValid(slot.fixed)) return suture::refusedAt(path, "fixed");
  if (!suture::allOf(slot.cloud, path, [path](const std::array<double, 3>& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "cloud");
  }
  if (!suture::allOf(slot.wrenches, path, [path](const std::array<float, 6>& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "wrenches");
  }
  if (!isValid(slot.scaled)) return suture::refusedAt(path, "scaled");
  return isValid(slot.wait) || suture::refusedAt(path, "wait");
}

// Defined in shapes/containers.wire.cpp.
const suture::codec::Codec& storeCodec();

namespace {

bool acceptsStorePut(const StorePutArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsStoreChoose(const StoreChooseArguments& slot, suture::FieldPath* path) {
  return isValid(slot.gain, path) || suture::refusedAt(path, "gain");
}

bool acceptsStoreReadingResult(const suture::SlotTuple<double, std::int16_t>& slot,
                               suture::FieldPath* path) {
  return suture::allItems(slot, path, suture::Valid{path}, isKnownLevel);
}

bool acceptsStoreChangedEvent(const suture::SlotVariant<double, PointSlot>& slot,
                              suture::FieldPath* path) {
  return isValid(slot, path);
}

constexpr suture::CommandInfo kStoreCommands[] = {
    {.name = "put",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<StorePutArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<StorePutArguments, acceptsStorePut>},
    {.name = "choose",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<StoreChooseArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<StoreChooseArguments, acceptsStoreChoose>},
    {.name = "sequences",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<SequencesSlot>,
     .depth = 16,
     .column = StoreColumn::sequences,
     .acceptsResult = suture::checkSlot<SequencesSlot, isValid>},
    {.name = "choices",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<ChoicesSlot>,
     .depth = 16,
     .column = StoreColumn::choices,
     .acceptsResult = suture::checkSlot<ChoicesSlot, isValid>},
    {.name = "matrices",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<MatricesSlot>,
     .depth = 16,
     .column = StoreColumn::matrices,
     .acceptsResult = suture::checkSlot<MatricesSlot, isValid>},
    {.name = "reading",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<suture::SlotTuple<double, std::int16_t>>,
     .depth = 16,
     .column = StoreColumn::reading,
     .acceptsResult = suture::checkSlot<suture::SlotTuple<double, std::int16_t>, acceptsStoreReadingResult>},
};

constexpr suture::EventInfo kStoreEvents[] = {
    {.name = "changed",
     .payloadSize = suture::slotSize<suture::SlotVariant<double, PointSlot>>,
     .depth = 16,
     .accepts = suture::checkSlot<suture::SlotVariant<double, PointSlot>, acceptsStoreChangedEvent>},
};

// The self-description, as in shapes/containers.suture.json.
constexpr char kStoreDescription[] = R"json(
{"name": "shapes::Store", "doc": "Composites right in a contract.",
"hash": "e9d3a1f58314be00d17d84e627a75b81", "commands": [{"name": "put", "kind": "write",
"ordinal": 1, "parameters": [{"name": "value", "type": {"kind": "struct",
"name": "shapes::Sequences"}}], "queue": 16}, {"name": "choose", "kind": "write", "ordinal": 2,
"parameters": [{"name": "gain", "type": {"kind": "optional", "element": {"kind": "Float64"}}}],
"queue": 16}, {"name": "sequences", "kind": "read", "ordinal": 3, "result": {"type": {
"kind": "struct", "name": "shapes::Sequences"}}, "queue": 16}, {"name": "choices", "kind": "read",
"ordinal": 4, "result": {"type": {"kind": "struct", "name": "shapes::Choices"}}, "queue": 16}, {
"name": "matrices", "kind": "read", "ordinal": 5, "result": {"type": {"kind": "struct",
"name": "shapes::Matrices"}}, "queue": 16}, {"name": "reading", "kind": "read", "ordinal": 6,
"result": {"type": {"kind": "tuple", "elements": [{"kind": "Float64"}, {"kind": "enum",
"name": "shapes::Level"}]}}, "queue": 16}], "events": [{"name": "changed", "kind": "write",
"ordinal": 1, "payload": {"type": {"kind": "variant", "alternatives": [{"kind": "Float64"}, {
"kind": "struct", "name": "shapes::Point"}]}}, "queue": 16}], "enums": [{"name": "shapes::Level",
"doc": "Sparse, negative, and ready for what later versions add.", "underlying": "Int16",
"enumerators": [{"name": "Unknown", "value": -1, "wire": "unknown", "fallback": true}, {
"name": "Low", "value": 10, "wire": "low"}, {"name": "High", "value": 300, "wire": "high"}]}],
"structs": [{"name": "shapes::Point", "doc": "Parts of other types.", "fields": [{"name": "x",
"type": {"kind": "Float64"}, "unit": "m", "range": [-10.0, 10.0], "default": 0.0}, {"name": "y",
"type": {"kind": "Float64"}, "default": 0.0}]}, {"name": "shapes::Sequences",
"doc": "Sequences, sets and maps.", "fields": [{"name": "bytes", "type": {"kind": "list",
"element": {"kind": "UInt8"}, "capacity": 8}}, {"name": "one", "type": {"kind": "UInt8"}}, {
"name": "row", "type": {"kind": "array", "element": {"kind": "Float64"}, "length": 3}}, {
"name": "grid", "type": {"kind": "array", "element": {"kind": "array", "element": {"kind": "Int32"
}, "length": 3}, "length": 2}}, {"name": "corners", "type": {"kind": "array", "element": {
"kind": "struct", "name": "shapes::Point"}, "length": 2}}, {"name": "path", "type": {
"kind": "list", "element": {"kind": "struct", "name": "shapes::Point"}, "capacity": 3}}, {
"name": "bits", "type": {"kind": "list", "element": {"kind": "Bool"}, "capacity": 4}}, {
"name": "flags", "type": {"kind": "list", "element": {"kind": "Bool"}, "capacity": 4}}, {
"name": "numbers", "type": {"kind": "set", "element": {"kind": "Int32"}, "capacity": 4}}, {
"name": "words", "type": {"kind": "set", "element": {"kind": "text", "capacity": 6}, "capacity": 3}
}, {"name": "levels", "type": {"kind": "set", "element": {"kind": "enum", "name": "shapes::Level"},
"capacity": 3}}, {"name": "gains", "type": {"kind": "map", "key": {"kind": "text", "capacity": 6},
"value": {"kind": "Float64"}, "capacity": 3}}, {"name": "points", "type": {"kind": "map", "key": {
"kind": "UInt16"}, "value": {"kind": "struct", "name": "shapes::Point"}, "capacity": 3}}, {
"name": "series", "type": {"kind": "map", "key": {"kind": "text", "capacity": 4}, "value": {
"kind": "list", "element": {"kind": "Float32"}, "capacity": 3}, "capacity": 2}}, {"name": "shares",
"type": {"kind": "map", "key": {"kind": "enum", "name": "shapes::Level"}, "value": {
"kind": "Float64"}, "capacity": 3}, "range": [0.0, 1.0]}]}, {"name": "shapes::Choices",
"doc": "What holds one thing or another, or some of each.", "fields": [{"name": "gain", "type": {
"kind": "optional", "element": {"kind": "Float64"}}}, {"name": "share", "type": {
"kind": "optional", "element": {"kind": "Float64"}}, "range": [0.0, 1.0]}, {"name": "answer",
"type": {"kind": "optional", "element": {"kind": "Bool"}}}, {"name": "frame", "type": {
"kind": "optional", "element": {"kind": "text", "capacity": 8}}}, {"name": "target", "type": {
"kind": "optional", "element": {"kind": "struct", "name": "shapes::Point"}}}, {"name": "polygon",
"type": {"kind": "optional", "element": {"kind": "list", "element": {"kind": "struct",
"name": "shapes::Point"}, "capacity": 2}}}, {"name": "twice", "type": {"kind": "optional",
"element": {"kind": "optional", "element": {"kind": "Int32"}}}}, {"name": "seen", "type": {
"kind": "list", "element": {"kind": "optional", "element": {"kind": "matrix", "scalar": "Float64",
"rows": 3, "columns": 1}}, "capacity": 3}}, {"name": "entry", "type": {"kind": "tuple",
"elements": [{"kind": "Int32"}, {"kind": "Float64"}]}}, {"name": "triple", "type": {
"kind": "tuple", "elements": [{"kind": "Bool"}, {"kind": "text", "capacity": 4}, {"kind": "struct",
"name": "shapes::Point"}]}}, {"name": "either", "type": {"kind": "variant", "alternatives": [{
"kind": "nothing"}, {"kind": "Float64"}, {"kind": "struct", "name": "shapes::Point"}, {
"kind": "text", "capacity": 4}, {"kind": "Float64"}]}}, {"name": "nested", "type": {
"kind": "variant", "alternatives": [{"kind": "enum", "name": "shapes::Level"}, {"kind": "optional",
"element": {"kind": "struct", "name": "shapes::Point"}}]}}, {"name": "owned", "type": {
"kind": "optional", "element": {"kind": "struct", "name": "shapes::Point"}}}, {"name": "rated",
"type": {"kind": "tuple", "elements": [{"kind": "Float64"}, {"kind": "enum", "name": "shapes::Level"
}]}}]}, {"name": "shapes::Matrices", "doc": "Eigen types of all kinds.", "fields": [{
"name": "joints", "type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 4},
"unit": "rad"}, {"name": "row", "type": {"kind": "list", "element": {"kind": "Float64"},
"capacity": 3}}, {"name": "any", "type": {"kind": "any matrix", "scalar": "Float64", "capacity": [
2, 3]}}, {"name": "counts", "type": {"kind": "any matrix", "scalar": "Int32", "capacity": [2, 2]}},
{"name": "columns", "type": {"kind": "list", "element": {"kind": "matrix", "scalar": "Float64",
"rows": 3, "columns": 1}, "capacity": 4}}, {"name": "limited", "type": {"kind": "list", "element": {
"kind": "Float32"}, "capacity": 5}}, {"name": "fixed", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 4, "columns": 5}}, {"name": "cloud", "type": {"kind": "list",
"element": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}, "capacity": 3}}, {
"name": "wrenches", "type": {"kind": "list", "element": {"kind": "matrix", "scalar": "Float32",
"rows": 6, "columns": 1}, "capacity": 3}}, {"name": "scaled", "type": {"kind": "affine",
"scalar": "Float64"}}, {"name": "wait", "type": {"kind": "duration", "period": "1/1000",
"scalar": "Float64"}, "default": 0.0}]}], "wire": [{"id": "@0xbb0be3e4bb1e6be9",
"kind": "interface", "name": "Store", "cxx": "shapes::Store", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xe1e2cc5c73c90fe5"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "put", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xdd7a64a833e189af"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "choose", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "gain",
"is": "@0x9a6cebde1c465fb4"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 3, "name": "sequences", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xdd7a64a833e189af"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4, "name": "choices", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xbda4c87a7b3da61e"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 5, "name": "matrices", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xd5b880c1c2797353"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 6, "name": "reading", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xfdb609e41c4ccca5"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xe1e2cc5c73c90fe5", "kind": "interface", "name": "StoreEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xca120faf75e33fa7"}]}, {"at": 1,
"name": "changed", "parameters": [{"at": 0, "name": "value", "is": "@0x8f220204a5e1de49"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xca120faf75e33fa7", "kind": "struct",
"name": "StoreStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "sequences", "is": "@0xdd7a64a833e189af"}, {"at": 4, "name": "choices",
"is": "@0xbda4c87a7b3da61e"}, {"at": 5, "name": "matrices", "is": "@0xd5b880c1c2797353"}, {"at": 6,
"name": "reading", "is": "@0xfdb609e41c4ccca5"}]}, {"id": "@0xdd7a64a833e189af", "kind": "struct",
"name": "Sequences", "members": [{"at": 0, "name": "bytes", "is": "Data"}, {"at": 1, "name": "one",
"is": "UInt8"}, {"at": 2, "name": "row", "is": "List(Float64) shape \"3\""}, {"at": 3,
"name": "grid", "is": "List(List(Int32)) shape \"2,3\""}, {"at": 4, "name": "corners",
"is": "List(@0xb51a57f43829556b) shape \"2\""}, {"at": 5, "name": "path",
"is": "List(@0xb51a57f43829556b)"}, {"at": 6, "name": "bits", "is": "List(Bool)"}, {"at": 7,
"name": "flags", "is": "List(Bool)"}, {"at": 8, "name": "numbers", "is": "List(Int32)"}, {"at": 9,
"name": "words", "is": "List(Text)"}, {"at": 10, "name": "levels", "is": "List(@0xa46142666f1d7c70)"
}, {"at": 11, "name": "gains", "is": "List(@0xe48709dcb204eab3)"}, {"at": 12, "name": "points",
"is": "List(@0x802b99a8ef527e43)"}, {"at": 13, "name": "series", "is": "List(@0xe8944577cbd7d345)"
}, {"at": 14, "name": "shares", "is": "List(@0xd457ac67cfb958f3)"}]}, {"id": "@0xb51a57f43829556b",
"kind": "struct", "name": "Point", "members": [{"at": 0, "name": "x", "is": "Float64 unit \"m\""}, {
"at": 1, "name": "y", "is": "Float64"}]}, {"id": "@0xa46142666f1d7c70", "kind": "enum",
"name": "Level", "members": [{"at": 0, "name": "unknown"}, {"at": 1, "name": "low"}, {"at": 2,
"name": "high"}]}, {"id": "@0xe48709dcb204eab3", "kind": "struct",
"name": "ShapesContainersEntryOfTextToFloat64", "members": [{"at": 0, "name": "key", "is": "Text"},
{"at": 1, "name": "value", "is": "Float64"}]}, {"id": "@0x802b99a8ef527e43", "kind": "struct",
"name": "ShapesContainersEntryOfUInt16ToPoint", "members": [{"at": 0, "name": "key", "is": "UInt16"
}, {"at": 1, "name": "value", "is": "@0xb51a57f43829556b"}]}, {"id": "@0xe8944577cbd7d345",
"kind": "struct", "name": "ShapesContainersEntryOfTextToListOfFloat32", "members": [{"at": 0,
"name": "key", "is": "Text"}, {"at": 1, "name": "value", "is": "List(Float32)"}]}, {
"id": "@0xd457ac67cfb958f3", "kind": "struct", "name": "ShapesContainersEntryOfLevelToFloat64",
"members": [{"at": 0, "name": "key", "is": "@0xa46142666f1d7c70"}, {"at": 1, "name": "value",
"is": "Float64"}]}, {"id": "@0xbda4c87a7b3da61e", "kind": "struct", "name": "Choices", "members": [
{"at": 0, "name": "gain", "is": "@0x9a6cebde1c465fb4"}, {"at": 1, "name": "share",
"is": "@0x9a6cebde1c465fb4"}, {"at": 2, "name": "answer", "is": "@0x87471a777724acdf"}, {"at": 3,
"name": "frame", "is": "@0xa13ea2f47ac175b5"}, {"at": 4, "name": "target",
"is": "@0x93456d793990e99b"}, {"at": 5, "name": "polygon", "is": "@0x87412f55480b65f2"}, {"at": 6,
"name": "twice", "is": "@0x997d382cf61c2bb6"}, {"at": 7, "name": "seen",
"is": "List(@0x93f6eb2708268fd2)"}, {"at": 8, "name": "entry", "is": "@0xa8fca31255af753f"}, {
"at": 9, "name": "triple", "is": "@0xd1cc96f9d5534dc0"}, {"at": 10, "name": "either",
"is": "@0xaf3aba732f52a3c6"}, {"at": 11, "name": "nested", "is": "@0xb44eaa716e9d1cae"}, {"at": 12,
"name": "owned", "is": "@0x93456d793990e99b"}, {"at": 13, "name": "rated",
"is": "@0xfdb609e41c4ccca5"}]}, {"id": "@0x9a6cebde1c465fb4", "kind": "union",
"name": "ShapesContainersOptionalFloat64", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "Float64"}]}, {"id": "@0x87471a777724acdf", "kind": "union",
"name": "ShapesContainersOptionalBool", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "Bool"}]}, {"id": "@0xa13ea2f47ac175b5", "kind": "union",
"name": "ShapesContainersOptionalText", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "Text"}]}, {"id": "@0x93456d793990e99b", "kind": "union",
"name": "ShapesContainersOptionalPoint", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "@0xb51a57f43829556b"}]}, {"id": "@0x87412f55480b65f2",
"kind": "union", "name": "ShapesContainersOptionalListOfPoint", "members": [{"at": 0,
"name": "none", "is": "Void"}, {"at": 1, "name": "some", "is": "List(@0xb51a57f43829556b)"}]}, {
"id": "@0x997d382cf61c2bb6", "kind": "union", "name": "ShapesContainersOptionalOptionalInt32",
"members": [{"at": 0, "name": "none", "is": "Void"}, {"at": 1, "name": "some",
"is": "@0x89f4ac8eee93a31a"}]}, {"id": "@0x89f4ac8eee93a31a", "kind": "union",
"name": "ShapesContainersOptionalInt32", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "Int32"}]}, {"id": "@0x93f6eb2708268fd2", "kind": "union",
"name": "ShapesContainersOptionalVec3", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "/suture/types.capnp:Vec3"}]}, {"id": "@0xa8fca31255af753f",
"kind": "struct", "name": "ShapesContainersTupleOfInt32AndFloat64", "members": [{"at": 0,
"name": "item0", "is": "Int32"}, {"at": 1, "name": "item1", "is": "Float64"}]}, {
"id": "@0xd1cc96f9d5534dc0", "kind": "struct", "name": "ShapesContainersTupleOfBoolAndTextAndPoint",
"members": [{"at": 0, "name": "item0", "is": "Bool"}, {"at": 1, "name": "item1", "is": "Text"}, {
"at": 2, "name": "item2", "is": "@0xb51a57f43829556b"}]}, {"id": "@0xaf3aba732f52a3c6",
"kind": "union", "name": "ShapesContainersEitherOfNothingOrFloat64OrPointOrTextOrFloat64",
"members": [{"at": 0, "name": "nothing", "is": "Void"}, {"at": 1, "name": "float64", "is": "Float64"
}, {"at": 2, "name": "point", "is": "@0xb51a57f43829556b"}, {"at": 3, "name": "text", "is": "Text"
}, {"at": 4, "name": "float64At4", "is": "Float64"}]}, {"id": "@0xb44eaa716e9d1cae",
"kind": "union", "name": "ShapesContainersEitherOfLevelOrOptionalPoint", "members": [{"at": 0,
"name": "level", "is": "@0xa46142666f1d7c70"}, {"at": 1, "name": "optionalPoint",
"is": "@0x93456d793990e99b"}]}, {"id": "@0xfdb609e41c4ccca5", "kind": "struct",
"name": "ShapesContainersTupleOfFloat64AndLevel", "members": [{"at": 0, "name": "item0",
"is": "Float64"}, {"at": 1, "name": "item1", "is": "@0xa46142666f1d7c70"}]}, {
"id": "@0xd5b880c1c2797353", "kind": "struct", "name": "Matrices", "members": [{"at": 0,
"name": "joints", "is": "List(Float64) unit \"rad\""}, {"at": 1, "name": "row",
"is": "List(Float64)"}, {"at": 2, "name": "any", "is": "@0xe30c2c9ae5b373ec"}, {"at": 3,
"name": "counts", "is": "@0xcf91b55ab5eb9027"}, {"at": 4, "name": "columns",
"is": "List(Float64) shape \"*,3x1\""}, {"at": 5, "name": "limited", "is": "List(Float32)"}, {
"at": 6, "name": "fixed", "is": "List(Float64) shape \"4x5\""}, {"at": 7, "name": "cloud",
"is": "List(Float64) shape \"*,3x1\""}, {"at": 8, "name": "wrenches",
"is": "List(Float32) shape \"*,6x1\""}, {"at": 9, "name": "scaled",
"is": "/suture/types.capnp:Pose shape \"affine\""}, {"at": 10, "name": "wait",
"is": "Float64 period \"1/1000\""}]}, {"id": "@0xe30c2c9ae5b373ec", "kind": "struct",
"name": "ShapesContainersAnyMatrixOfFloat64", "members": [{"at": 0, "name": "rows", "is": "UInt32"
}, {"at": 1, "name": "columns", "is": "UInt32"}, {"at": 2, "name": "data", "is": "List(Float64)"}]
}, {"id": "@0xcf91b55ab5eb9027", "kind": "struct", "name": "ShapesContainersAnyMatrixOfInt32",
"members": [{"at": 0, "name": "rows", "is": "UInt32"}, {"at": 1, "name": "columns", "is": "UInt32"
}, {"at": 2, "name": "data", "is": "List(Int32)"}]}, {"id": "@0x8f220204a5e1de49", "kind": "union",
"name": "ShapesContainersEitherOfFloat64OrPoint", "members": [{"at": 0, "name": "float64",
"is": "Float64"}, {"at": 1, "name": "point", "is": "@0xb51a57f43829556b"}]}]})json";

}  // namespace
}  // namespace shapes

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<shapes::Store>() {
  static constexpr InterfaceInfo kInfo{
      .name = "shapes::Store",
      .hash = "e9d3a1f58314be00d17d84e627a75b81",
      .description = shapes::kStoreDescription,
      .commands = shapes::kStoreCommands,
      .events = shapes::kStoreEvents,
      .codec = &shapes::storeCodec,
  };
  return kInfo;
}

auto Provided<shapes::Store>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(shapes::StorePutArguments::value)>(scratch.put_value);
  return scratch;
}

// A function for each command of shapes::Store, so that a stack in a debugger names it.
struct Provided<shapes::Store>::Dispatch {
  static Errc execute_put(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<shapes::StorePutArguments>(arguments);
    load(slot.value, scratch.put_value);
    implementation.put(scratch.put_value);
    return Errc{};
  }

  static Errc execute_choose(Contract& implementation, Scratch& scratch,
                             const std::byte* arguments) {
    const auto& slot = slotIn<shapes::StoreChooseArguments>(arguments);
    load(slot.gain, scratch.choose_gain);
    implementation.choose(scratch.choose_gain);
    return Errc{};
  }

  static Errc execute_sequences(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<shapes::SequencesSlot>(result);
    return store(implementation.sequences(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_choices(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<shapes::ChoicesSlot>(result);
    return store(implementation.choices(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_matrices(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<shapes::MatricesSlot>(result);
    return store(implementation.matrices(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_reading(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<suture::SlotTuple<double, std::int16_t>>(result);
    return store(implementation.reading(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<shapes::Store>::execute(std::uint16_t command, const std::byte* arguments,
                                      std::byte* result) {
  using ::shapes::StoreCommand;
  switch (command) {
    case StoreCommand::put: return Dispatch::execute_put(implementation_, scratch_, arguments);
    case StoreCommand::choose:
      return Dispatch::execute_choose(implementation_, scratch_, arguments);
    case StoreCommand::sequences: return Dispatch::execute_sequences(implementation_, result);
    case StoreCommand::choices: return Dispatch::execute_choices(implementation_, result);
    case StoreCommand::matrices: return Dispatch::execute_matrices(implementation_, result);
    case StoreCommand::reading: return Dispatch::execute_reading(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
