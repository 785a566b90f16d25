#include "compiler/model/flat_size.h"

#include <algorithm>
#include <limits>
#include <string>
#include <unordered_map>

namespace suture::compiler::model {
namespace {

using Shape = Type::Shape;

std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  return b != 0 && a > kMost / b ? kMost : a * b;
}

std::uint64_t plus(std::uint64_t a, std::uint64_t b) {
  return a + b < a ? std::numeric_limits<std::uint64_t>::max() : a + b;
}

std::uint64_t scalarSize(Scalar scalar) {
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

/// Counts each struct once, because a type may lead to it by very many ways.
class Sizes {
 public:
  explicit Sizes(const Lookup& lookup) : lookup_(lookup) {}

  std::uint64_t of(const Type& type) {
    constexpr std::uint64_t kLength = 4;
    switch (type.shape) {
      case Shape::Scalar: return scalarSize(type.scalar);
      case Shape::Enum: return 8;
      case Shape::Struct: return ofStruct(type.name);
      case Shape::Text: return plus(kLength, type.capacity.value_or(0));
      case Shape::Array: return times(type.rows, of(type.element.front()));
      case Shape::List:
      case Shape::Map: return plus(kLength, times(type.capacity.value_or(0), sumOf(type)));
      case Shape::Matrix: return times(times(type.rows, type.columns), scalarSize(type.scalar));
      case Shape::Quaternion: return 32;
      case Shape::Isometry:
      case Shape::Affine: return 96;
      case Shape::Duration:
      case Shape::TimePoint: return 8;
      case Shape::Optional: return plus(1, sumOf(type));
      case Shape::Tuple: return sumOf(type);
      case Shape::Variant: return plus(kLength, largestOf(type));
      case Shape::Nothing: return 1;
      case Shape::AnyMatrix:
        return plus(2 * kLength,
                    times(times(type.capacity.value_or(0), type.columnCapacity.value_or(0)),
                          scalarSize(type.scalar)));
    }
    return 0;
  }

 private:
  std::uint64_t ofStruct(const std::string& name) {
    if (const auto known = structs_.find(name); known != structs_.end()) return known->second;
    std::uint64_t size = 0;
    if (const Struct* const type = lookup_.findStruct(name)) {
      for (const Field& field : type->fields) size = plus(size, of(field.type));
    }
    return structs_[name] = size;
  }

  std::uint64_t sumOf(const Type& type) {
    std::uint64_t size = 0;
    for (const Type& element : type.element) size = plus(size, of(element));
    return size;
  }

  std::uint64_t largestOf(const Type& type) {
    std::uint64_t size = 0;
    for (const Type& element : type.element) size = std::max(size, of(element));
    return size;
  }

  const Lookup& lookup_;
  std::unordered_map<std::string, std::uint64_t> structs_;
};

}  // namespace

std::uint64_t flatSize(const Type& type, const Lookup& lookup) { return Sizes(lookup).of(type); }

}  // namespace suture::compiler::model
