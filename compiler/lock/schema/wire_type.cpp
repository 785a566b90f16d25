#include "compiler/lock/schema/wire_type.h"

#include <vector>

#include "compiler/lock/schema/composites.h"
#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {
namespace {

using model::Type;
using Shape = Type::Shape;

std::string list(const std::string& element) { return "List(" + element + ")"; }

std::string wireNameOf(const std::string& name, const model::Lookup& lookup) {
  if (const model::Enum* const one = lookup.findEnum(name)) return one->wireName;
  if (const model::Struct* const one = lookup.findStruct(name)) return one->wireName;
  if (const model::Interface* const one = lookup.findInterface(name)) return one->wireName;
  return "";
}

/// Returns what a flat list of an Eigen type's coefficients has to say of itself.
std::string flatShape(const Type& type, bool inFlatList) {
  if (type.shape == Shape::Affine) return "affine";
  if (!namedEigenType(type).empty() && !inFlatList) return "";
  if (type.shape == Shape::Quaternion) return "wxyz";
  if (type.shape == Shape::Isometry) return "3x4";
  if (type.shape != Shape::Matrix) return "";
  return std::to_string(type.rows) + "x" + std::to_string(type.columns);
}

/// Returns one entry for each level, such as "*,3,6x7", or "" if every level is open or says its
/// own length.
std::string shapeOf(const Type& type) {
  std::string shape;
  bool fixed = false;
  bool inFlatList = false;
  const Type* level = &type;
  while (level->shape == Shape::Array || level->shape == Shape::List) {
    if (!shape.empty()) shape += ',';
    const bool isArray = level->shape == Shape::Array;
    shape += isArray ? std::to_string(level->rows) : "*";
    fixed = fixed || isArray;
    inFlatList = isFlatList(*level);
    level = &level->element.front();
  }
  const std::string flat = flatShape(*level, inFlatList);
  if (!shape.empty() && !flat.empty()) shape += ',';
  return fixed || !flat.empty() ? shape + flat : "";
}

/// Collects the bounds of the type and of all it is made of, outside in.
void collectCapacities(const Type& type, std::vector<std::optional<unsigned>>& bounds) {
  const bool matrix = type.shape == Shape::AnyMatrix;
  const bool sized =
      type.shape == Shape::List || type.shape == Shape::Text || type.shape == Shape::Map || matrix;
  if (sized) bounds.push_back(type.capacity);
  if (matrix) bounds.push_back(type.columnCapacity);
  for (const Type& element : type.element) collectCapacities(element, bounds);
}

/// Returns one number for each level that may have a bound, such as "[8, 0]", or "" if none is
/// bounded.
std::string capacities(const Type& type) {
  std::vector<std::optional<unsigned>> bounds;
  collectCapacities(type, bounds);
  std::string numbers;
  bool bounded = false;
  for (const std::optional<unsigned>& bound : bounds) {
    if (!numbers.empty()) numbers += ", ";
    numbers += std::to_string(bound.value_or(0));
    bounded = bounded || bound.has_value();
  }
  return bounded ? "[" + numbers + "]" : "";
}

/// Returns the levels of lists whose elements differ from each other, such as "[0]" for a set, or
/// "" if there are none.
std::string distinctLevels(const Type& type) {
  std::string levels;
  unsigned depth = 0;
  for (const Type* level = &type; level->shape == Shape::Array || level->shape == Shape::List;
       level = &level->element.front(), ++depth) {
    if (level->distinct) levels += (levels.empty() ? "" : ", ") + std::to_string(depth);
  }
  return levels.empty() ? "" : "[" + levels + "]";
}

}  // namespace

std::string namedEigenType(const Type& type) {
  if (type.scalar != model::Scalar::Float64) return "";
  if (type.shape == Shape::Quaternion) return "/suture/types.capnp:Quat";
  if (type.shape == Shape::Isometry || type.shape == Shape::Affine) {
    return "/suture/types.capnp:Pose";
  }
  if (type.shape != Shape::Matrix) return "";
  if (type.columns == 1 && type.rows >= 2 && type.rows <= 4) {
    return "/suture/types.capnp:Vec" + std::to_string(type.rows);
  }
  if (type.rows == type.columns && (type.rows == 3 || type.rows == 4)) {
    return "/suture/types.capnp:Mat" + std::to_string(type.rows);
  }
  return "";
}

bool isFlatList(const Type& type) {
  if (type.shape != Shape::List) return false;
  const Type& element = type.element.front();
  return element.shape == Shape::Matrix && element.columns == 1;
}

std::string bulkScalar(const Type& type) {
  if (!type.bulk) return "";
  return std::string(capnpScalar(type.element.empty() ? type.scalar : type.element[0].scalar));
}

model::Scalar wireScalar(const Type& type) {
  const bool real = type.scalar == model::Scalar::Float32 || type.scalar == model::Scalar::Float64;
  if (type.shape != Shape::Duration) return type.scalar;
  return real ? model::Scalar::Float64 : model::Scalar::Int64;
}

std::string_view capnpScalar(model::Scalar scalar) {
  switch (scalar) {
    case model::Scalar::Bool: return "Bool";
    case model::Scalar::Int8: return "Int8";
    case model::Scalar::Int16: return "Int16";
    case model::Scalar::Int32: return "Int32";
    case model::Scalar::Int64: return "Int64";
    case model::Scalar::UInt8: return "UInt8";
    case model::Scalar::UInt16: return "UInt16";
    case model::Scalar::UInt32: return "UInt32";
    case model::Scalar::UInt64: return "UInt64";
    case model::Scalar::Float32: return "Float32";
    case model::Scalar::Float64: return "Float64";
  }
  return "Void";
}

std::string declaredType(const std::string& name, const model::Lookup& lookup,
                         const model::Header& inside) {
  const model::Header* const header = lookup.headerOf(name);
  const std::string wireName = wireNameOf(name, lookup);
  if (header == nullptr || wireName.empty()) return name;
  return header->path == inside.path ? wireName : "/" + lockPath(header->path) + ":" + wireName;
}

std::string wireType(const Type& type, const model::Lookup& lookup, const model::Header& inside) {
  if (type.bulk && type.shape != Shape::AnyMatrix) return "Data";
  switch (type.shape) {
    case Shape::Scalar: return std::string(capnpScalar(type.scalar));
    case Shape::Enum:
    case Shape::Struct: return declaredType(type.name, lookup, inside);
    case Shape::Text: return "Text";
    case Shape::List: {
      const Type& element = type.element.front();
      const bool bytes = element.shape == Shape::Scalar && element.scalar == model::Scalar::UInt8;
      if (bytes && !type.distinct) return "Data";
      if (isFlatList(type)) return list(std::string(capnpScalar(element.scalar)));
      return list(wireType(element, lookup, inside));
    }
    case Shape::Array: return list(wireType(type.element.front(), lookup, inside));
    case Shape::Matrix:
    case Shape::Quaternion:
    case Shape::Isometry:
    case Shape::Affine: {
      const std::string named = namedEigenType(type);
      return named.empty() ? list(std::string(capnpScalar(type.scalar))) : named;
    }
    case Shape::Duration: return std::string(capnpScalar(wireScalar(type)));
    case Shape::TimePoint: return "Int64";
    case Shape::Optional:
    case Shape::Tuple:
    case Shape::Variant:
    case Shape::AnyMatrix: return compositeName(type, lookup, inside);
    case Shape::Map: return list(compositeName(type, lookup, inside));
    case Shape::Nothing: return "Void";
  }
  return "Void";
}

std::map<std::string, std::string> typeAnnotations(const Type& type) {
  std::map<std::string, std::string> result;
  const auto add = [&result](const char* name, const std::string& argument) {
    if (!argument.empty()) result.emplace(name, argument);
  };
  const Type* leaf = &type;
  while (leaf->shape == Shape::Array || leaf->shape == Shape::List) leaf = &leaf->element.front();
  if (leaf->shape == Shape::Duration) {
    add("period", quoted(std::to_string(leaf->periodNumerator) + "/" +
                         std::to_string(leaf->periodDenominator)));
  }
  if (leaf->shape == Shape::TimePoint) {
    add("clock", quoted(leaf->clock == model::Clock::Steady ? "steady" : "system"));
  }
  const std::string shape = shapeOf(type);
  if (!shape.empty()) add("shape", quoted(shape));
  if (type.shape != Shape::AnyMatrix)
    add("bulk", bulkScalar(type).empty() ? "" : quoted(bulkScalar(type)));
  add("capacity", capacities(type));
  add("distinct", distinctLevels(type));
  return result;
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\' || c == '\n') result += '\\';
    result += c == '\n' ? 'n' : c;
  }
  return result + '"';
}

std::string unquoted(std::string_view literal) {
  std::string text;
  for (std::size_t i = 1; i + 1 < literal.size(); ++i) {
    const bool isEscape = literal[i] == '\\' && i + 2 < literal.size();
    if (isEscape) ++i;
    text += isEscape && literal[i] == 'n' ? '\n' : literal[i];
  }
  return text;
}

}  // namespace suture::compiler::lock
