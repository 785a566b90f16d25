#include "compiler/emit/text/context.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <set>

#include "compiler/emit/text/code.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {

using model::Scalar;
using model::Type;
using Shape = Type::Shape;

std::string relative(const std::string& name, const std::string& inNamespace) {
  const std::string prefix = inNamespace + "::";
  return !inNamespace.empty() && name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

std::string rooted(const std::string& name) { return rooted(name, model::namespaceOf(name)); }

std::string rooted(const std::string& name, const std::string& itsNamespace) {
  return (itsNamespace.empty() ? "::" : "") + name;
}

std::string namespaceOf(const model::Struct& declaration, const Context& context) {
  return declaration.foreignNamespace.value_or(context.header.cxxNamespace);
}

namespace {

/// Names what is generated as within a namespace.
std::string generatedIn(const std::string& inNamespace, const std::string& name) {
  return inNamespace.empty() ? name : relative(rooted(name), inNamespace);
}

}  // namespace

std::string slotStruct(const std::string& structName, const model::Lookup& lookup) {
  return generatedName(structName, lookup) + "Slot";
}

std::string cxxScalar(Scalar scalar) {
  switch (scalar) {
    case Scalar::Bool: return "bool";
    case Scalar::Int8: return "std::int8_t";
    case Scalar::Int16: return "std::int16_t";
    case Scalar::Int32: return "std::int32_t";
    case Scalar::Int64: return "std::int64_t";
    case Scalar::UInt8: return "std::uint8_t";
    case Scalar::UInt16: return "std::uint16_t";
    case Scalar::UInt32: return "std::uint32_t";
    case Scalar::UInt64: return "std::uint64_t";
    case Scalar::Float32: return "float";
    case Scalar::Float64: return "double";
  }
  return "void";
}

std::string slotType(const Type& type, const Context& context, const std::string& inNamespace) {
  const auto array = [](const std::string& element, unsigned length) {
    return "std::array<" + element + ", " + std::to_string(length) + ">";
  };
  const auto bound = [](std::optional<unsigned> capacity) {
    return capacity.value_or(0) == 0 ? std::string("suture::kUnbounded")
                                     : std::to_string(*capacity);
  };
  const bool open = type.capacity.value_or(0) == 0;
  const auto all = [&](const char* name) {
    std::string arguments;
    for (const Type& element : type.element) {
      if (!arguments.empty()) arguments += ", ";
      arguments += slotType(element, context, inNamespace);
    }
    return std::string(name) + "<" + arguments + ">";
  };
  switch (type.shape) {
    case Shape::Scalar:
      return type.scalar == Scalar::Bool ? "std::uint8_t" : cxxScalar(type.scalar);
    case Shape::Enum: return context.lookup.findEnum(type.name)->underlyingType;
    case Shape::Struct: return generatedIn(inNamespace, slotStruct(type.name, context.lookup));
    case Shape::Text:
      return open ? "suture::OpenText" : "suture::BoundedText<" + bound(type.capacity) + ">";
    case Shape::Array: return array(slotType(type.element[0], context, inNamespace), type.rows);
    case Shape::List:
    case Shape::Map: {
      const std::string element = elementSlot(type, context, inNamespace);
      return open ? "suture::OpenList<" + element + ">"
                  : "suture::BoundedList<" + element + ", " + bound(type.capacity) + ">";
    }
    case Shape::Matrix: return array(cxxScalar(type.scalar), type.rows * type.columns);
    case Shape::Quaternion: return array(cxxScalar(type.scalar), 4);
    case Shape::Isometry:
    case Shape::Affine: return array(cxxScalar(type.scalar), 12);
    case Shape::Duration: return cxxScalar(lock::wireScalar(type));
    case Shape::TimePoint: return "std::int64_t";
    case Shape::Optional:
      return all(holdsRecursive(type, context.lookup) ? "suture::OpenOptional"
                                                      : "suture::SlotOptional");
    case Shape::Tuple: return all("suture::SlotTuple");
    case Shape::Variant: return all("suture::SlotVariant");
    case Shape::Nothing: return "suture::SlotNothing";
    case Shape::AnyMatrix:
      if (open && type.columnCapacity.value_or(0) == 0) {
        return "suture::OpenMatrix<" + cxxScalar(type.scalar) + ">";
      }
      return "suture::BoundedMatrix<" + cxxScalar(type.scalar) + ", " + bound(type.capacity) +
             ", " + bound(type.columnCapacity) + ">";
  }
  return "void";
}

std::string cxxType(const Type& type, const std::string& inNamespace) {
  return relative(type.spelling, inNamespace);
}

std::string elementSlot(const Type& type, const Context& context, const std::string& inNamespace) {
  std::string first = slotType(type.element.front(), context, inNamespace);
  if (type.shape != Shape::Map) return first;
  return "suture::SlotEntry<" + first + ", " + slotType(type.element.back(), context, inNamespace) +
         ">";
}

std::string access(const model::Struct& owner, const model::Field& field, const std::string& object,
                   bool isConst, const std::string& inNamespace) {
  if (field.isHidden) {
    return "suture::Members<" + relative(owner.name, inNamespace) + ">::" + field.name + "(" +
           object + ")";
  }
  if (field.isPacked) {
    return "suture::unpacked(" + object + ", &" + relative(owner.name, inNamespace) +
           "::" + field.name + ").value";
  }
  if (!field.isBase) return object + "." + field.name;
  return std::string("static_cast<") + (isConst ? "const " : "") +
         cxxType(field.type, inNamespace) + "&>(" + object + ")";
}

std::string changeField(const model::Struct& owner, const model::Field& field,
                        const std::string& before, const std::string& after,
                        const std::string& inNamespace) {
  if (!field.isPacked) {
    return before + access(owner, field, "value", false, inNamespace) + after + ";";
  }
  return "suture::changePacked(value, &" + relative(owner.name, inNamespace) + "::" + field.name +
         ", " + kBreak + "[&](auto& field) { " + before + "field" + after + "; });";
}

namespace {

/// Walks into each struct once; one that is being walked through leads back to itself.
class Bounds {
 public:
  explicit Bounds(const model::Lookup& lookup) : lookup_(lookup) {}

  bool all(const model::Struct& record) {
    const auto [known, isNew] = bounded_.emplace(record.name, false);
    if (!isNew) return known->second;
    return known->second =
               std::all_of(record.fields.begin(), record.fields.end(),
                           [this](const model::Field& field) { return all(field.type); });
  }

  bool all(const Type& type) {
    const bool matrix = type.shape == Shape::AnyMatrix;
    const bool sized = type.shape == Shape::Text || type.shape == Shape::List ||
                       type.shape == Shape::Map || matrix;
    if (sized && type.capacity.value_or(0) == 0) return false;
    if (matrix && type.columnCapacity.value_or(0) == 0) return false;
    if (type.shape == Shape::Struct) return all(*lookup_.findStruct(type.name));
    return std::all_of(type.element.begin(), type.element.end(),
                       [this](const Type& element) { return all(element); });
  }

 private:
  const model::Lookup& lookup_;
  std::map<std::string, bool> bounded_;  // false for those that are being walked through
};

}  // namespace

bool isBounded(const Type& type, const model::Lookup& lookup) { return Bounds(lookup).all(type); }

namespace {

/// Finds the structs that a type holds, each once.
class Held {
 public:
  explicit Held(const model::Lookup& lookup) : lookup_(lookup) {}

  void add(const model::Struct& record) {
    for (const model::Field& field : record.fields) add(field.type);
  }
  bool contains(const std::string& name) const { return names_.contains(name); }

 private:
  void add(const Type& type) {
    if (type.shape == Shape::Struct && names_.insert(type.name).second) {
      add(*lookup_.findStruct(type.name));
    }
    for (const Type& element : type.element) add(element);
  }

  const model::Lookup& lookup_;
  std::set<std::string> names_;
};

}  // namespace

bool isRecursive(const model::Struct& declaration, const model::Lookup& lookup) {
  Held held(lookup);
  held.add(declaration);
  return held.contains(declaration.name);
}

bool holdsRecursive(const model::Type& type, const model::Lookup& lookup) {
  if (type.shape != Shape::Optional || type.element[0].shape != Shape::Struct) return false;
  return isRecursive(*lookup.findStruct(type.element[0].name), lookup);
}

std::string qualifier(const std::string& declared, const Context& context) {
  const model::Header* const header = context.lookup.headerOf(declared);
  const bool here = header == nullptr || header->cxxNamespace == context.header.cxxNamespace;
  return here ? "" : header->cxxNamespace + "::";
}

std::string prefixOf(const model::Interface& interface, const Context& context) {
  return model::unqualified(generatedName(interface.name, context.lookup));
}

std::string argumentsStruct(const model::Interface& interface, const model::Command& command,
                            const Context& context) {
  return model::argumentsStruct(interface, command, context.lookup);
}

std::string payloadSlot(const model::Interface& interface, const model::Event& event,
                        const Context& context, const std::string& inNamespace) {
  if (event.payload.size() == 1) return slotType(event.payload[0], context, inNamespace);
  return generatedIn(inNamespace, model::payloadStruct(interface, event, context.lookup));
}

std::string openNamespace(const std::string& name) {
  return name.empty() ? "" : "namespace " + name + " {\n";
}

std::string closeNamespace(const std::string& name) {
  return name.empty() ? "" : "}  // namespace " + name + "\n";
}

std::string banner(const model::Header& header) {
  return "// Written by suturec from " + header.path + ". Do not edit.\n";
}

namespace {

std::string groupedDigits(std::string digits) {
  const std::size_t sign = digits.front() == '-' ? 1 : 0;
  for (std::size_t i = digits.size(); i > sign + 3;) {
    i -= 3;
    digits.insert(i, "'");
  }
  return digits;
}

}  // namespace

std::string grouped(std::int64_t number) { return groupedDigits(std::to_string(number)); }

std::string valueText(const model::Enum& type, const model::Enumerator& enumerator) {
  return type.underlying == Scalar::UInt64
             ? std::to_string(static_cast<std::uint64_t>(enumerator.value))
             : std::to_string(enumerator.value);
}

namespace {

/// Tells if the value is the one that no literal of C++ spells.
bool isLowestNumber(const model::Enum& type, const model::Enumerator& enumerator) {
  return type.underlying == Scalar::Int64 &&
         enumerator.value == std::numeric_limits<std::int64_t>::min();
}

}  // namespace

bool hasLowestNumber(const model::Enum& type) {
  return std::any_of(type.enumerators.begin(), type.enumerators.end(),
                     [&](const auto& one) { return isLowestNumber(type, one); });
}

std::string valueLiteral(const model::Enum& type, const model::Enumerator& enumerator) {
  if (isLowestNumber(type, enumerator)) return "std::numeric_limits<std::int64_t>::min()";
  const bool wide = type.underlying == Scalar::UInt32 || type.underlying == Scalar::UInt64;
  return groupedDigits(valueText(type, enumerator)) + (wide ? "u" : "");
}

}  // namespace suture::compiler::emit
