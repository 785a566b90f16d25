#include <suture/base/errors.h>
#include <suture/record/slot_layout.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

namespace suture {
namespace {

using nlohmann::json;

std::size_t roundUp(std::size_t value, std::size_t alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

template <class T>
T valueAt(const std::byte* memory) {
  T value;
  std::memcpy(&value, memory, sizeof(T));
  return value;
}

/// "1/1000" is a thousandth.
double secondsOf(const std::string& period) {
  const std::size_t slash = period.find('/');
  return std::stod(period.substr(0, slash)) / std::stod(period.substr(slash + 1));
}

json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

const json& named(const json& list, const std::string& name) {
  for (const json& one : list) {
    if (one.at("name") == name) return one;
  }
  throw SetupError("the layout of '" + name + "'", "its contract does not describe it",
                   "Generate the contract's code again");
}

}  // namespace

SlotLayout::SlotLayout(const json& type, const json& contract) {
  try {
    readType(type, contract);
  } catch (const json::exception& error) {
    throw SetupError("the layout of a type", std::string("its description reads ") + error.what(),
                     "Generate the contract's code again");
  }
  finish();
}

SlotLayout SlotLayout::ofFields(const json& fields, const json& contract) {
  SlotLayout all;
  all.kind_ = Kind::Struct;
  for (const json& field : fields) {
    all.addPart(field.at("name"), SlotLayout(field.at("type"), contract));
  }
  all.finish();
  return all;
}

// An empty struct has one byte; every other ends at a multiple of its alignment.
void SlotLayout::finish() { size_ = std::max<std::size_t>(roundUp(size_, alignment_), 1); }

void SlotLayout::addPart(std::string name, SlotLayout layout) {
  alignment_ = std::max(alignment_, layout.alignment_);
  const std::size_t offset = roundUp(size_, layout.alignment_);
  size_ = offset + layout.size_;
  parts_.push_back({std::move(name), offset, std::make_shared<SlotLayout>(std::move(layout))});
}

// Lays out `count` elements, one after the other, behind what is there already.
void SlotLayout::repeat(SlotLayout element, std::size_t count) {
  const std::size_t rest = (count - std::min<std::size_t>(count, 1)) * element.size_;
  count_ = count;
  addPart("", std::move(element));
  size_ += rest;
}

void SlotLayout::readType(const json& type, const json& contract) {
  const std::string kind = type.at("kind");
  const auto inner = [&](const char* key) { return SlotLayout(type.at(key), contract); };
  // Lays out what begins with how many of its elements count.
  const auto counted = [&](Kind as, SlotLayout element) {
    kind_ = as;
    size_ = alignment_ = sizeof(std::uint32_t);
    repeat(std::move(element), type.at("capacity").get<std::size_t>());
  };
  if (kind == "struct") {
    *this = ofFields(named(contract.at("structs"), type.at("name")).at("fields"), contract);
  } else if (kind == "enum") {
    readEnum(type.at("name"), contract);
  } else if (kind == "text") {
    counted(Kind::Text, SlotLayout(json{{"kind", "Int8"}}, contract));
  } else if (kind == "list" || kind == "set") {
    counted(Kind::List, inner("element"));
  } else if (kind == "map") {
    const json entry = {{{"name", "key"}, {"type", type.at("key")}},
                        {{"name", "value"}, {"type", type.at("value")}}};
    counted(Kind::Map, ofFields(entry, contract));
  } else if (kind == "array") {
    kind_ = Kind::Array;
    repeat(inner("element"), type.at("length").get<std::size_t>());
  } else if (kind == "optional") {
    kind_ = Kind::Optional;
    size_ = 1;
    addPart("", inner("element"));
  } else if (kind == "tuple") {
    readTuple(type.at("elements"), 0, contract);
  } else if (kind == "variant") {
    readVariant(type.at("alternatives"), contract);
  } else if (kind == "time") {
    readScalar("Int64");
  } else if (kind == "duration") {
    readScalar(type.value("scalar", "Int64"));
    if (kind_ == Kind::Int64) {
      kind_ = Kind::Nanoseconds;
    } else {
      seconds_ = secondsOf(type.value("period", "1/1"));
    }
  } else if (kind == "nothing") {
    kind_ = Kind::Nothing;
  } else if (type.contains("scalar")) {
    readMatrix(type);
  } else {
    readScalar(kind);
  }
}

void SlotLayout::readScalar(const std::string& name) {
  struct Row {
    const char* name;
    Kind kind;
    std::size_t size;
  };
  static constexpr Row kScalars[] = {
      {"Bool", Kind::Bool, 1},       {"Int8", Kind::Int8, 1},      {"Int16", Kind::Int16, 2},
      {"Int32", Kind::Int32, 4},     {"Int64", Kind::Int64, 8},    {"UInt8", Kind::UInt8, 1},
      {"UInt16", Kind::UInt16, 2},   {"UInt32", Kind::UInt32, 4},  {"UInt64", Kind::UInt64, 8},
      {"Float32", Kind::Float32, 4}, {"Float64", Kind::Float64, 8}};
  const auto found = std::find_if(std::begin(kScalars), std::end(kScalars),
                                  [&](const Row& row) { return name == row.name; });
  if (found == std::end(kScalars)) {
    throw SetupError("the layout of a type", "its kind is '" + name + "', which is not known here",
                     "Build this program and the contract's code from the same release");
  }
  kind_ = found->kind;
  size_ = alignment_ = found->size;
}

void SlotLayout::readEnum(const std::string& name, const json& contract) {
  const json& declaration = named(contract.at("enums"), name);
  kind_ = Kind::Enum;
  addPart("", SlotLayout(json{{"kind", declaration.at("underlying")}}, contract));
  for (const json& one : declaration.at("enumerators")) {
    enumerators_.emplace_back(one.at("value").get<std::int64_t>(), one.at("name"));
  }
}

void SlotLayout::readMatrix(const json& type) {
  const std::string kind = type.at("kind");
  SlotLayout scalar(json{{"kind", type.at("scalar")}}, {});
  if (kind == "any matrix") {
    kind_ = Kind::AnyMatrix;
    size_ = 2 * sizeof(std::uint32_t);
    alignment_ = sizeof(std::uint32_t);
    columns_ = type.at("capacity").at(1);
    repeat(std::move(scalar), type.at("capacity").at(0).get<std::size_t>() * columns_);
  } else if (kind == "matrix") {
    columns_ = type.at("columns");
    kind_ = columns_ == 1 ? Kind::Array : Kind::Rows;
    repeat(std::move(scalar), type.at("rows").get<std::size_t>() * columns_);
  } else if (kind == "quaternion") {
    kind_ = Kind::Array;
    repeat(std::move(scalar), 4);
  } else {  // isometry, affine
    kind_ = Kind::Transform;
    columns_ = 4;
    repeat(std::move(scalar), 12);
  }
}

// A SlotTuple is its first element, and a SlotTuple of the others.
void SlotLayout::readTuple(const json& elements, std::size_t from, const json& contract) {
  kind_ = Kind::Tuple;
  addPart("", SlotLayout(elements.at(from), contract));
  if (from + 1 < elements.size()) {
    SlotLayout tail;
    tail.readTuple(elements, from + 1, contract);
    tail.finish();
    addPart("", std::move(tail));
  }
}

// The alternatives share one place behind the index.
void SlotLayout::readVariant(const json& alternatives, const json& contract) {
  kind_ = Kind::Variant;
  size_ = alignment_ = sizeof(std::uint32_t);
  std::size_t largest = 0;
  for (const json& one : alternatives) {
    SlotLayout layout(one, contract);
    largest = std::max(largest, layout.size_);
    alignment_ = std::max(alignment_, layout.alignment_);
    parts_.push_back({"", 0, std::make_shared<SlotLayout>(std::move(layout))});
  }
  const std::size_t offset = roundUp(sizeof(std::uint32_t), alignment_);
  for (Part& part : parts_) part.offset = offset;
  size_ = offset + largest;
}

json SlotLayout::toJson(const std::byte* slot) const {
  const auto count = [&] { return std::min<std::size_t>(valueAt<std::uint32_t>(slot), count_); };
  const std::byte* first = parts_.empty() ? slot : slot + parts_.front().offset;
  switch (kind_) {
    case Kind::Struct: return structToJson(slot);
    case Kind::Text: return std::string(reinterpret_cast<const char*>(first), count());
    case Kind::List:
    case Kind::Map: return listToJson(first, count());
    case Kind::Array: return listToJson(first, count_);
    case Kind::Rows: return rowsToJson(first, count_ / columns_, columns_);
    case Kind::AnyMatrix: {
      const std::size_t rows = valueAt<std::uint32_t>(slot),
                        columns = valueAt<std::uint32_t>(slot + 4);
      const bool fits = columns == 0 || rows <= count_ / columns;
      return fits ? rowsToJson(first, rows, columns) : json(nullptr);
    }
    case Kind::Transform: return rowsToJson(first, 3, 4);
    case Kind::Optional:
      return valueAt<std::uint8_t>(slot) == 0 ? json(nullptr) : element().toJson(first);
    case Kind::Tuple: return tupleToJson(slot);
    case Kind::Variant: {
      const std::size_t index = valueAt<std::uint32_t>(slot);
      if (index >= parts_.size()) return nullptr;
      return {{"index", index}, {"value", parts_[index].layout->toJson(first)}};
    }
    default: return scalarToJson(slot);
  }
}

json SlotLayout::scalarToJson(const std::byte* slot) const {
  switch (kind_) {
    case Kind::Bool: return valueAt<std::uint8_t>(slot) != 0;
    case Kind::Int8: return valueAt<std::int8_t>(slot);
    case Kind::Int16: return valueAt<std::int16_t>(slot);
    case Kind::Int32: return valueAt<std::int32_t>(slot);
    case Kind::Int64: return valueAt<std::int64_t>(slot);
    case Kind::UInt8: return valueAt<std::uint8_t>(slot);
    case Kind::UInt16: return valueAt<std::uint16_t>(slot);
    case Kind::UInt32: return valueAt<std::uint32_t>(slot);
    case Kind::UInt64: return valueAt<std::uint64_t>(slot);
    case Kind::Float32: return number(seconds_ * valueAt<float>(slot));
    case Kind::Float64: return number(seconds_ * valueAt<double>(slot));
    case Kind::Nanoseconds: return static_cast<double>(valueAt<std::int64_t>(slot)) * 1e-9;
    case Kind::Enum: {
      json value = element().toJson(slot);
      for (const auto& [known, name] : enumerators_) {
        if (value == known) return name;
      }
      return value;
    }
    default: return nullptr;
  }
}

json SlotLayout::structToJson(const std::byte* slot) const {
  json out = json::object();
  for (const Part& part : parts_) out[part.name] = part.layout->toJson(slot + part.offset);
  return out;
}

// A map is a list of pairs, or an object where its keys are texts.
json SlotLayout::listToJson(const std::byte* first, std::size_t count) const {
  json list = json::array();
  for (std::size_t i = 0; i < count; ++i) {
    const std::byte* memory = first + i * element().size_;
    if (kind_ != Kind::Map) {
      list.push_back(element().toJson(memory));
      continue;
    }
    json key = element().parts_[0].layout->toJson(memory + element().parts_[0].offset);
    json value = element().parts_[1].layout->toJson(memory + element().parts_[1].offset);
    list.push_back(json::array({std::move(key), std::move(value)}));
  }
  if (kind_ != Kind::Map || element().parts_[0].layout->kind_ != Kind::Text) return list;
  json object = json::object();
  for (json& pair : list) object[pair[0].get<std::string>()] = std::move(pair[1]);
  return object;
}

// Slots keep matrices column after column.
json SlotLayout::rowsToJson(const std::byte* first, std::size_t rows, std::size_t columns) const {
  json out = json::array();
  for (std::size_t row = 0; row < rows; ++row) {
    json line = json::array();
    for (std::size_t column = 0; column < columns; ++column) {
      line.push_back(element().toJson(first + (column * rows + row) * element().size_));
    }
    out.push_back(std::move(line));
  }
  return out;
}

json SlotLayout::tupleToJson(const std::byte* slot) const {
  json out = json::array({parts_[0].layout->toJson(slot + parts_[0].offset)});
  if (parts_.size() > 1) {
    for (json& one : parts_[1].layout->tupleToJson(slot + parts_[1].offset))
      out.push_back(std::move(one));
  }
  return out;
}

}  // namespace suture
