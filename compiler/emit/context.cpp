#include "compiler/emit/context.h"

#include <algorithm>

#include "compiler/model/naming.h"

namespace suture::compiler::emit {

using model::Scalar;
using model::Type;
using Shape = Type::Shape;

std::string relative(const std::string& name, const std::string& inNamespace) {
  const std::string prefix = inNamespace + "::";
  return !inNamespace.empty() && name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

std::string slotStruct(const std::string& structName, const model::Lookup& lookup) {
  const model::Header* const header = lookup.headerOf(structName);
  const std::string home = header == nullptr ? "" : header->cxxNamespace;
  std::string flat = relative(structName, home);
  for (std::size_t at; (at = flat.find("::")) != std::string::npos;) flat.erase(at, 2);
  return (home.empty() ? "" : home + "::") + flat + "Slot";
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
  switch (type.shape) {
    case Shape::Scalar:
      return type.scalar == Scalar::Bool ? "std::uint8_t" : cxxScalar(type.scalar);
    case Shape::Enum: return cxxScalar(context.lookup.findEnum(type.name)->underlying);
    case Shape::Struct: return relative(slotStruct(type.name, context.lookup), inNamespace);
    case Shape::Text: return "suture::BoundedText<" + std::to_string(*type.capacity) + ">";
    case Shape::Array: return array(slotType(type.element[0], context, inNamespace), type.rows);
    case Shape::List:
      return "suture::BoundedList<" + slotType(type.element[0], context, inNamespace) + ", " +
             std::to_string(*type.capacity) + ">";
    case Shape::Matrix: return array(cxxScalar(type.scalar), type.rows * type.columns);
    case Shape::Quaternion: return array(cxxScalar(type.scalar), 4);
    case Shape::Isometry: return array(cxxScalar(type.scalar), 12);
    case Shape::Duration:
    case Shape::TimePoint: return "std::int64_t";
  }
  return "void";
}

std::string cxxType(const Type& type, const std::string& inNamespace) {
  return relative(type.spelling, inNamespace);
}

bool isBounded(const Type& type, const model::Lookup& lookup) {
  const bool sized = type.shape == Shape::Text || type.shape == Shape::List;
  if (sized && !type.capacity) return false;
  if (type.shape == Shape::Struct) return isBounded(*lookup.findStruct(type.name), lookup);
  return type.element.empty() || isBounded(type.element[0], lookup);
}

bool isBounded(const model::Struct& declaration, const model::Lookup& lookup) {
  return std::all_of(declaration.fields.begin(), declaration.fields.end(),
                     [&](const model::Field& field) { return isBounded(field.type, lookup); });
}

std::string pascalCase(const std::string& cxxName) {
  return model::titleCase(model::camelCase(cxxName));
}

std::string prefixOf(const model::Interface& interface) {
  return model::unqualified(interface.name);
}

namespace {

/// "robots::ArmServoCp" + `ending`, of the contract that declares the member.
std::string memberStruct(const std::string& contract, const std::string& inheritedFrom,
                         const std::string& member, const char* ending) {
  return (inheritedFrom.empty() ? contract : inheritedFrom) + pascalCase(member) + ending;
}

}  // namespace

std::string argumentsStruct(const model::Interface& interface, const model::Command& command) {
  return memberStruct(interface.name, command.inheritedFrom, command.name, "Arguments");
}

std::string payloadSlot(const model::Interface& interface, const model::Event& event,
                        const Context& context, const std::string& inNamespace) {
  if (event.payload.size() == 1) return slotType(event.payload[0], context, inNamespace);
  return relative(memberStruct(interface.name, event.inheritedFrom, event.name, "Payload"),
                  inNamespace);
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

std::string grouped(std::int64_t number) {
  std::string digits = std::to_string(number);
  const std::size_t sign = number < 0 ? 1 : 0;
  for (std::size_t i = digits.size(); i > sign + 3;) {
    i -= 3;
    digits.insert(i, "'");
  }
  return digits;
}

}  // namespace suture::compiler::emit
