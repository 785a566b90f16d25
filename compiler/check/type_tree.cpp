#include "compiler/check/type_tree.h"

#include <algorithm>
#include <limits>
#include <set>

namespace suture::compiler::check {
namespace {

using Shape = model::Type::Shape;

class Walk {
 public:
  Walk(const model::Lookup& lookup, const std::function<bool(const Place&)>& visit)
      : lookup_(lookup), visit_(visit) {}

  bool from(Place place) {
    const bool isStruct = place.type.shape == Shape::Struct;
    place.recursive = isStruct && open_.contains(place.type.name);
    if (!visit_(place)) return false;
    for (const model::Type& element : place.type.element) {
      if (!from({element, place.path + "[]", place.field})) return false;
    }
    const model::Struct* type = isStruct ? lookup_.findStruct(place.type.name) : nullptr;
    if (!type || place.recursive) return true;
    open_.insert(type->name);
    const bool whole = fields(*type, place.path);
    open_.erase(type->name);
    return whole;
  }

 private:
  bool fields(const model::Struct& type, const std::string& prefix) {
    for (const model::Field& field : type.fields) {
      const std::string path = prefix.empty() ? field.name : prefix + "." + field.name;
      if (!from({field.type, path, &field})) return false;
    }
    return true;
  }

  const model::Lookup& lookup_;
  const std::function<bool(const Place&)>& visit_;
  std::set<std::string> open_;
};

std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  return b != 0 && a > kMost / b ? kMost : a * b;
}

std::uint64_t plus(std::uint64_t a, std::uint64_t b) {
  return a + b < a ? std::numeric_limits<std::uint64_t>::max() : a + b;
}

std::uint64_t scalarSize(model::Scalar scalar) {
  using model::Scalar;
  switch (scalar) {
    case Scalar::Bool:
    case Scalar::Int8:
    case Scalar::UInt8: return 1;
    case Scalar::Int16:
    case Scalar::UInt16: return 2;
    case Scalar::Int32:
    case Scalar::UInt32:
    case Scalar::Float32: return 4;
    default: return 8;
  }
}

std::uint64_t structSize(const model::Struct* type, const model::Lookup& lookup) {
  std::uint64_t size = 0;
  if (!type) return size;
  for (const model::Field& field : type->fields) size = plus(size, flatSize(field.type, lookup));
  return size;
}

std::uint64_t sumOf(const model::Type& type, const model::Lookup& lookup) {
  std::uint64_t size = 0;
  for (const model::Type& element : type.element) size = plus(size, flatSize(element, lookup));
  return size;
}

std::uint64_t largestOf(const model::Type& type, const model::Lookup& lookup) {
  std::uint64_t size = 0;
  for (const model::Type& element : type.element) {
    size = std::max(size, flatSize(element, lookup));
  }
  return size;
}

}  // namespace

bool isSized(const model::Type& type) {
  return type.shape == Shape::Text || type.shape == Shape::List || type.shape == Shape::Map ||
         type.shape == Shape::AnyMatrix;
}

bool isOpen(const model::Type& type) {
  const bool matrix = type.shape == Shape::AnyMatrix;
  return isSized(type) &&
         (type.capacity.value_or(0) == 0 || (matrix && type.columnCapacity.value_or(0) == 0));
}

bool walk(const model::Type& type, const model::Lookup& lookup,
          const std::function<bool(const Place&)>& visit) {
  return Walk(lookup, visit).from({type, "", nullptr});
}

bool ownsHeap(const model::Type& type, const model::Lookup& lookup) {
  return !walk(type, lookup, [](const Place& place) {
    // Among optionals, std::unique_ptr alone: only its spelling tells them apart.
    const bool pointer =
        place.type.shape == Shape::Optional && place.type.spelling.starts_with("std::unique_ptr");
    return !isSized(place.type) && !pointer;
  });
}

std::uint64_t flatSize(const model::Type& type, const model::Lookup& lookup) {
  constexpr std::uint64_t kLength = 4;
  switch (type.shape) {
    case Shape::Scalar: return scalarSize(type.scalar);
    case Shape::Enum: return 8;
    case Shape::Struct: return structSize(lookup.findStruct(type.name), lookup);
    case Shape::Text: return plus(kLength, type.capacity.value_or(0));
    case Shape::Array: return times(type.rows, flatSize(type.element.front(), lookup));
    case Shape::List:
    case Shape::Map: return plus(kLength, times(type.capacity.value_or(0), sumOf(type, lookup)));
    case Shape::Matrix: return times(times(type.rows, type.columns), scalarSize(type.scalar));
    case Shape::Quaternion: return 32;
    case Shape::Isometry:
    case Shape::Affine: return 96;
    case Shape::Duration:
    case Shape::TimePoint: return 8;
    case Shape::Optional: return plus(1, sumOf(type, lookup));
    case Shape::Tuple: return sumOf(type, lookup);
    case Shape::Variant: return plus(kLength, largestOf(type, lookup));
    case Shape::Nothing: return 1;
    case Shape::AnyMatrix:
      return plus(2 * kLength,
                  times(times(type.capacity.value_or(0), type.columnCapacity.value_or(0)),
                        scalarSize(type.scalar)));
  }
  return 0;
}

}  // namespace suture::compiler::check
