#include "compiler/check/type_tree.h"

#include <limits>

namespace suture::compiler::check {
namespace {

using Shape = model::Type::Shape;

bool walkFrom(const Place& place, const model::Lookup& lookup,
              const std::function<bool(const Place&)>& visit) {
  if (!visit(place)) return false;
  for (const model::Type& element : place.type.element) {
    if (!walkFrom({element, place.path + "[]", place.field}, lookup, visit)) return false;
  }
  const model::Struct* type =
      place.type.shape == Shape::Struct ? lookup.findStruct(place.type.name) : nullptr;
  if (!type) return true;
  for (const model::Field& field : type->fields) {
    const std::string path = place.path.empty() ? field.name : place.path + "." + field.name;
    if (!walkFrom({field.type, path, &field}, lookup, visit)) return false;
  }
  return true;
}

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

}  // namespace

bool walk(const model::Type& type, const model::Lookup& lookup,
          const std::function<bool(const Place&)>& visit) {
  return walkFrom({type, "", nullptr}, lookup, visit);
}

bool ownsHeap(const model::Type& type, const model::Lookup& lookup) {
  return !walk(type, lookup, [](const Place& place) {
    return place.type.shape != Shape::Text && place.type.shape != Shape::List;
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
      return plus(kLength,
                  times(type.capacity.value_or(0), flatSize(type.element.front(), lookup)));
    case Shape::Matrix: return times(times(type.rows, type.columns), scalarSize(type.scalar));
    case Shape::Quaternion: return 32;
    case Shape::Isometry: return 96;
    case Shape::Duration:
    case Shape::TimePoint: return 8;
  }
  return 0;
}

}  // namespace suture::compiler::check
