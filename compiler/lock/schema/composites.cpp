#include "compiler/lock/schema/composites.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::lock {
namespace {

using model::Type;
using Shape = Type::Shape;

/// Holds all that a wire name needs to know of its surroundings.
struct Place {
  const model::Lookup& lookup;
  const model::Header& inside;
};

std::string nameOf(const Type& type, const Place& place);

std::string joined(const Type& type, const char* separator, const Place& place) {
  std::string text;
  for (const Type& element : type.element) {
    text += (text.empty() ? "" : separator) + nameOf(element, place);
  }
  return text;
}

/// Puts the namespace in front if it is not the header's.
std::string declared(const Type& type, const Place& place) {
  const model::Struct* const record = place.lookup.findStruct(type.name);
  const model::Enum* const enumeration = place.lookup.findEnum(type.name);
  const model::Header* const home = place.lookup.headerOf(type.name);
  std::string name = record        ? record->wireName
                     : enumeration ? enumeration->wireName
                                   : model::unqualified(type.name);
  if (home == nullptr || home->cxxNamespace == place.inside.cxxNamespace) return name;
  return model::titleCase(model::camelCase(model::unqualified(home->cxxNamespace))) + name;
}

std::string matrix(const Type& type) {
  const std::string named = namedEigenType(type);
  if (!named.empty()) return named.substr(named.find(':') + 1);
  return "Matrix" + std::to_string(type.rows) + "x" + std::to_string(type.columns) + "Of" +
         std::string(capnpScalar(type.scalar));
}

std::string sequence(const Type& type, const Place& place) {
  const bool bytes = wireType(type, place.lookup, place.inside) == "Data";
  return bytes ? "Data" : (type.distinct ? "SetOf" : "ListOf") + joined(type, "", place);
}

std::string duration(const Type& type) {
  return "Duration" + std::to_string(type.periodNumerator) + "Per" +
         std::to_string(type.periodDenominator) + std::string(capnpScalar(wireScalar(type)));
}

std::string nameOf(const Type& type, const Place& place) {
  switch (type.shape) {
    case Shape::Scalar: return std::string(capnpScalar(type.scalar));
    case Shape::Enum:
    case Shape::Struct: return declared(type, place);
    case Shape::Text: return "Text";
    case Shape::Array: return "Array" + std::to_string(type.rows) + "Of" + joined(type, "", place);
    case Shape::List: return sequence(type, place);
    case Shape::Matrix: return matrix(type);
    case Shape::Quaternion: return "Quat";
    case Shape::Isometry: return "Pose";
    case Shape::Affine: return "Affine";
    case Shape::Duration: return duration(type);
    case Shape::TimePoint: return type.clock == model::Clock::Steady ? "SteadyTime" : "SystemTime";
    case Shape::Optional: return "Optional" + joined(type, "", place);
    case Shape::Map: return "EntryOf" + joined(type, "To", place);
    case Shape::Tuple: return "TupleOf" + joined(type, "And", place);
    case Shape::Variant: return "EitherOf" + joined(type, "Or", place);
    case Shape::Nothing: return "Nothing";
    case Shape::AnyMatrix:
      return (type.bulk ? "BulkMatrixOf" : "AnyMatrixOf") + std::string(capnpScalar(type.scalar));
  }
  return "";
}

std::string decapitalised(std::string name) {
  if (!name.empty()) name[0] = static_cast<char>(name[0] | 0x20);
  return name;
}

/// Names the alternatives by type, so that their order does not matter; the second of a type gets
/// its index.
std::vector<std::string> alternativeNames(const Type& type, const Place& place) {
  std::vector<std::string> names;
  std::map<std::string, unsigned> seen;
  for (const Type& element : type.element) {
    const std::string name = decapitalised(nameOf(element, place));
    const bool again = seen[name]++ > 0;
    names.push_back(again ? name + "At" + std::to_string(names.size()) : name);
  }
  return names;
}

}  // namespace

bool isComposite(const Type& type) {
  return type.shape == Shape::Optional || type.shape == Shape::Map || type.shape == Shape::Tuple ||
         type.shape == Shape::Variant || type.shape == Shape::AnyMatrix;
}

std::string prefixOf(const model::Header& header) {
  if (!header.wirePrefix.empty()) return header.wirePrefix;
  const std::string stem = model::plainPath(model::stemOf(header.path));
  std::string result, last;
  for (std::size_t begin = 0; begin <= stem.size();) {
    const std::size_t end = std::min(stem.find('/', begin), stem.size());
    const std::string piece = stem.substr(begin, end - begin);
    if (piece != last) result += model::titleCase(model::camelCase(piece));
    last = piece;
    begin = end + 1;
  }
  const bool isName = result.empty() || std::isdigit(static_cast<unsigned char>(result[0])) == 0;
  return isName ? result : "Header" + result;
}

std::string compositeName(const Type& type, const model::Lookup& lookup,
                          const model::Header& inside) {
  return prefixOf(inside) + nameOf(type, {lookup, inside});
}

std::vector<std::string> compositeMembers(const Type& type, const model::Lookup& lookup,
                                          const model::Header& inside) {
  std::vector<std::string> names;
  switch (type.shape) {
    case Shape::Optional: names = {"some"}; return names;
    case Shape::Map: names = {"key", "value"}; return names;
    case Shape::Variant: return alternativeNames(type, {lookup, inside});
    default: break;
  }
  for (const Type& element : type.element) {
    names.push_back("item" + std::to_string(&element - type.element.data()));
  }
  return names;
}

void forEachComposite(const Type& type, const std::function<void(const Type&)>& visit) {
  for (const Type& element : type.element) forEachComposite(element, visit);
  if (isComposite(type)) visit(type);
}

void forEachComposite(const model::Header& header,
                      const std::function<bool(const model::Struct&)>& counts,
                      const std::function<void(const model::Type&, const model::Source&)>& visit) {
  const auto look = [&](const Type& type, const model::Source& source) {
    forEachComposite(type, [&](const Type& composite) { visit(composite, source); });
  };
  for (const model::Struct& record : header.structs) {
    if (!counts(record)) continue;
    for (const model::Field& field : record.fields) look(field.type, field.source);
  }
  for (const model::Interface& interface : header.interfaces) {
    for (const model::Command& command : interface.commands) {
      for (const model::Parameter& one : command.parameters) look(one.type, one.source);
      if (command.result) look(*command.result, command.source);
    }
    for (const model::Event& event : interface.events) {
      for (const Type& payload : event.payload) look(payload, event.source);
    }
  }
}

}  // namespace suture::compiler::lock
