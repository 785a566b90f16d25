// This writes the self-description: what the header declares, for people and for tools.

#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/emit/text/parts.h"
#include "compiler/emit/text/reachable_types.h"
#include "compiler/emit/wire/wire_nodes.h"
#include "compiler/emit/wire/wire_places.h"
#include "compiler/lock/major_versions.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

using Json = nlohmann::ordered_json;
using model::Type;
using Shape = Type::Shape;
using Bounds = std::optional<std::pair<double, double>>;

std::string scalarName(model::Scalar scalar) { return std::string(lock::capnpScalar(scalar)); }

Json typeOf(const Type& type);

Json typesOf(const Type& type) {
  Json types = Json::array();
  for (const Type& element : type.element) types.push_back(typeOf(element));
  return types;
}

Json durationOf(const Type& type) {
  Json json{{"kind", "duration"},
            {"period",
             std::to_string(type.periodNumerator) + "/" + std::to_string(type.periodDenominator)}};
  const model::Scalar scalar = lock::wireScalar(type);
  if (scalar != model::Scalar::Int64) json["scalar"] = scalarName(scalar);
  return json;
}

Json anyMatrixOf(const Type& type) {
  Json json{{"kind", "any matrix"}, {"scalar", scalarName(type.scalar)}};
  const auto bound = [](const std::optional<unsigned>& one) { return one ? Json(*one) : Json(); };
  if (type.capacity || type.columnCapacity) {
    json["capacity"] = {bound(type.capacity), bound(type.columnCapacity)};
  }
  return json;
}

/// Describes an optional, a tuple, a variant, a map or a matrix whose size is open.
Json compositeOf(const Type& type) {
  switch (type.shape) {
    case Shape::Optional: return {{"kind", "optional"}, {"element", typeOf(type.element[0])}};
    case Shape::Tuple: return {{"kind", "tuple"}, {"elements", typesOf(type)}};
    case Shape::Variant: return {{"kind", "variant"}, {"alternatives", typesOf(type)}};
    case Shape::AnyMatrix: return anyMatrixOf(type);
    case Shape::Map: {
      Json json{
          {"kind", "map"}, {"key", typeOf(type.element[0])}, {"value", typeOf(type.element[1])}};
      if (type.capacity) json["capacity"] = *type.capacity;
      return json;
    }
    default: return {{"kind", "nothing"}};
  }
}

Json typeOf(const Type& type) {
  const auto bounded = [&type](Json json) {
    if (type.capacity) json["capacity"] = *type.capacity;
    return json;
  };
  switch (type.shape) {
    case Shape::Scalar: return {{"kind", scalarName(type.scalar)}};
    case Shape::Enum: return {{"kind", "enum"}, {"name", type.name}};
    case Shape::Struct: return {{"kind", "struct"}, {"name", type.name}};
    case Shape::Text: return bounded({{"kind", "text"}});
    case Shape::List:
      return bounded(
          {{"kind", type.distinct ? "set" : "list"}, {"element", typeOf(type.element[0])}});
    case Shape::Array:
      return {{"kind", "array"}, {"element", typeOf(type.element[0])}, {"length", type.rows}};
    case Shape::Matrix:
      return {{"kind", "matrix"},
              {"scalar", scalarName(type.scalar)},
              {"rows", type.rows},
              {"columns", type.columns}};
    case Shape::Quaternion: return {{"kind", "quaternion"}, {"scalar", scalarName(type.scalar)}};
    case Shape::Isometry: return {{"kind", "isometry"}, {"scalar", scalarName(type.scalar)}};
    case Shape::Affine: return {{"kind", "affine"}, {"scalar", scalarName(type.scalar)}};
    case Shape::Duration: return durationOf(type);
    case Shape::TimePoint:
      return {{"kind", "time"},
              {"clock", type.clock == model::Clock::Steady ? "steady" : "system"}};
    default: break;
  }
  return compositeOf(type);
}

/// Describes the type, and says if its numbers are one block of bytes on the wire by bulk().
Json wireTypeOf(const Type& type) {
  Json json = typeOf(type);
  if (type.bulk) json["bulk"] = true;
  return json;
}

/// Adds the number of a command or an event on the wire, which peers compare when they connect.
void addOrdinal(Json& json, const std::optional<unsigned>& ordinal) {
  if (ordinal) json["ordinal"] = *ordinal;
}

void addDoc(Json& json, const model::Documentation& doc) {
  if (!doc.text.empty()) json["doc"] = doc.text;
}

// JSON has no number for infinity, so that it becomes a text.
Json realJson(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

void addValue(Json& json, const Type& type, const std::string& unit, const Bounds& range) {
  json["type"] = wireTypeOf(type);
  if (!unit.empty()) json["unit"] = unit;
  if (range) json["range"] = {realJson(range->first), realJson(range->second)};
}

void addLifecycle(Json& json, const model::Lifecycle& lifecycle) {
  if (lifecycle.since) json["since"] = *lifecycle.since;
  if (!lifecycle.deprecated.empty()) json["deprecated"] = lifecycle.deprecated;
}

/// Adds the name that the schema gives it, where that is another.
void addWireName(Json& json, const std::string& name, const std::string& wireName) {
  if (name != wireName) json["wire"] = wireName;
}

Json enumOf(const model::Enum& declaration) {
  Json json{{"name", declaration.name}};
  addWireName(json, model::unqualified(declaration.name), declaration.wireName);
  addDoc(json, declaration.doc);
  addLifecycle(json, declaration.lifecycle);
  json["underlying"] = scalarName(declaration.underlying);
  for (const model::Enumerator& enumerator : declaration.enumerators) {
    Json one{{"name", enumerator.name}, {"value", Json::parse(valueText(declaration, enumerator))}};
    addWireName(one, enumerator.name, enumerator.wireName);
    if (enumerator.fallback) one["fallback"] = true;
    addDoc(one, enumerator.doc);
    addLifecycle(one, enumerator.lifecycle);
    json["enumerators"].push_back(std::move(one));
  }
  return json;
}

Json structOf(const model::Struct& declaration) {
  Json json{{"name", declaration.name}};
  addWireName(json, model::unqualified(declaration.name), declaration.wireName);
  addDoc(json, declaration.doc);
  addLifecycle(json, declaration.lifecycle);
  json["fields"] = Json::array();
  for (const model::Field& field : declaration.fields) {
    Json one{{"name", field.name}};
    addWireName(one, field.name, field.wireName);
    addDoc(one, field.doc);
    addValue(one, field.type, field.unit, field.range);
    addLifecycle(one, field.lifecycle);
    if (!field.defaultJson.empty()) one["default"] = Json::parse(field.defaultJson);
    json["fields"].push_back(std::move(one));
  }
  return json;
}

const char* kindName(model::CommandKind kind) {
  switch (kind) {
    case model::CommandKind::Void: return "void";
    case model::CommandKind::Write: return "write";
    case model::CommandKind::Read: return "read";
    case model::CommandKind::QualifiedRead: return "qualified read";
    case model::CommandKind::VoidReturn: return "void with return";
    case model::CommandKind::WriteReturn: return "write with return";
  }
  return "";
}

double seconds(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

/// Adds which contract declared it, since which version, and if it is deprecated.
void addOrigin(Json& json, const std::string& inheritedFrom, const model::Lifecycle& lifecycle) {
  if (!inheritedFrom.empty()) json["from"] = inheritedFrom;
  addLifecycle(json, lifecycle);
}

Json commandOf(const model::Command& command) {
  Json json{{"name", command.name}, {"kind", kindName(command.kind)}};
  addOrdinal(json, command.ordinal);
  addWireName(json, command.name, command.wireName);
  addDoc(json, command.doc);
  for (const model::Parameter& parameter : command.parameters) {
    Json one{{"name", parameter.name}};
    addWireName(one, parameter.name, parameter.wireName);
    addValue(one, parameter.type, parameter.unit, parameter.range);
    json["parameters"].push_back(std::move(one));
  }
  if (command.result) {
    addValue(json["result"], *command.result, command.resultUnit, command.resultRange);
  }
  json["queue"] = command.queue;
  if (command.latest) json["latest"] = true;
  if (command.ttlNanoseconds) json["ttl"] = seconds(*command.ttlNanoseconds);
  if (command.deadlineNanoseconds) json["deadline"] = seconds(*command.deadlineNanoseconds);
  if (command.optional) json["optional"] = true;
  if (command.concurrent) json["concurrent"] = true;
  if (command.direct) json["direct"] = true;
  addOrigin(json, command.inheritedFrom, command.lifecycle);
  return json;
}

Json eventOf(const model::Event& event) {
  Json json{{"name", event.name}, {"kind", event.payload.empty() ? "void" : "write"}};
  addOrdinal(json, event.ordinal);
  addWireName(json, event.name, event.wireName);
  addDoc(json, event.doc);
  for (std::size_t i = 0; i < event.payload.size(); ++i) {
    const model::Limits limits = i < event.limits.size() ? event.limits[i] : model::Limits{};
    const bool alone = event.payload.size() == 1;
    Json one = alone ? Json::object() : Json{{"name", lock::payloadName(i)}};
    addValue(one, event.payload[i], limits.unit, limits.range);
    if (alone) {
      json["payload"] = std::move(one);
    } else {
      json["payload"].push_back(std::move(one));
    }
  }
  json["queue"] = event.queue;
  if (event.latest) json["latest"] = true;
  if (event.latched) json["latched"] = true;
  addOrigin(json, event.inheritedFrom, event.lifecycle);
  return json;
}

/// Adds the number by which a subscription asks for each event. `numbers` is empty if these are the
/// places of the events.
void addNumbers(Json& events, const std::vector<unsigned>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) events[i]["number"] = numbers[i];
}

Json interfaceOf(const model::Interface& interface, const Context& context) {
  Json json{{"name", interface.name}};
  addWireName(json, model::unqualified(interface.name), interface.wireName);
  addDoc(json, interface.doc);
  json["hash"] = context.hashes.at(interface.name);
  const std::string& core = context.cores.at(interface.name);
  if (json["hash"] != core) json["core"] = core;
  if (interface.version > 1) json["version"] = interface.version;
  const unsigned major = lock::majorOf(context.schemas, interface.name);
  if (major > 1) json["major"] = major;
  if (!interface.base.empty()) json["base"] = interface.base;
  if (interface.crtk) json["crtk"] = true;
  addOrigin(json, "", interface.lifecycle);
  json["commands"] = Json::array();
  for (const model::Command& command : interface.commands) {
    json["commands"].push_back(commandOf(command));
  }
  json["events"] = Json::array();
  for (const model::Event& event : interface.events) json["events"].push_back(eventOf(event));
  addNumbers(json["events"], wireEvents(context, interface));
  return json;
}

Json componentOf(const model::Component& component) {
  Json json{{"name", component.name},
            {"base", component.base == model::ComponentBase::Task ? "task" : "device"}};
  addDoc(json, component.doc);
  if (component.parameters) json["parameters"] = *component.parameters;
  json["provided"] = json["required"] = Json::array();
  for (const model::Port& port : component.ports) {
    Json one{{"name", port.name}, {"member", port.member}, {"interface", port.interface}};
    if (port.optional) one["optional"] = true;
    if (port.maxAgeNanoseconds) one["max_age"] = seconds(*port.maxAgeNanoseconds);
    json[port.provided ? "provided" : "required"].push_back(std::move(one));
  }
  return json;
}

template <class Declarations, class Describe>
void addAll(Json& json, const char* key, const Declarations& declarations,
            const Describe& describeOne) {
  json[key] = Json::array();
  for (const auto& declaration : declarations) json[key].push_back(describeOne(declaration));
}

}  // namespace

std::string emitJson(const Context& context) {
  const model::Header& header = context.header;
  Json json{{"header", header.path}, {"namespace", header.cxxNamespace}};
  if (lock::needsLock(header)) json["schema"] = lock::lockPath(header.path);
  addAll(json, "enums", header.enums, enumOf);
  addAll(json, "structs", header.structs, structOf);
  addAll(json, "interfaces", header.interfaces,
         [&](const model::Interface& interface) { return interfaceOf(interface, context); });
  addAll(json, "components", header.components, componentOf);
  return json.dump(2) + "\n";
}

std::string describe(const Context& context, const model::Interface& interface) {
  Reached reached(context.lookup);
  reached.add(interface);
  Json json = interfaceOf(interface, context);
  json["enums"] = Json::array();
  json["structs"] = Json::array();
  for (const model::Enum* const one : reached.enums()) json["enums"].push_back(enumOf(*one));
  for (const model::Struct* const one : reached.structs()) {
    json["structs"].push_back(structOf(*one));
  }
  json["wire"] = wireNodes(context, interface);
  return json.dump(2);
}

}  // namespace suture::compiler::emit
