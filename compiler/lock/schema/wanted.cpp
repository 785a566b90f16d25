#include "compiler/lock/schema/wanted.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "compiler/lock/schema/composites.h"
#include "compiler/lock/schema/default_value.h"
#include "compiler/lock/schema/sha256.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::lock {
namespace {

using Shape = model::Type::Shape;

/// These annotations name what a node stands for.
constexpr std::array<const char*, 3> kIdentities{"cxx", "eventsOf", "stateOf"};

Member plain(std::string name, std::string type, std::string doc = "") {
  Member member;
  member.name = std::move(name);
  member.type = std::move(type);
  member.doc = std::move(doc);
  return member;
}

Member method(std::string name, std::string doc) {
  Member member = plain(std::move(name), "", std::move(doc));
  member.isMethod = true;
  return member;
}

void addCxxName(Member& member, const std::string& cxxName) {
  if (cxxName != member.name) member.annotations.emplace("cxx", quoted(cxxName));
}

void addLifecycle(Annotations& annotations, const model::Lifecycle& lifecycle) {
  if (lifecycle.since) annotations.emplace("since", std::to_string(*lifecycle.since));
  if (!lifecycle.deprecated.empty()) {
    annotations.emplace("deprecated", quoted(lifecycle.deprecated));
  }
}

using Bounds = std::optional<std::pair<double, double>>;

Annotations valueAnnotations(const model::Type& type, const std::string& unit,
                             const Bounds& range) {
  Annotations result = typeAnnotations(type);
  if (!unit.empty()) result.emplace("unit", quoted(unit));
  if (range) {
    result.emplace("range", "(lowest = " + capnpNumber(range->first) +
                                ", highest = " + capnpNumber(range->second) + ")");
  }
  return result;
}

WantedNode startNode(Node::Kind kind, const std::string& cxxName, std::string wireName,
                     std::string title, const model::Source& source) {
  WantedNode result;
  result.node.kind = kind;
  result.node.name = std::move(wireName);
  result.cxxName = cxxName;
  result.title = std::move(title);
  result.source = source;
  return result;
}

WantedNode wantedEnum(const model::Enum& declaration) {
  WantedNode result = startNode(Node::Kind::Enum, declaration.name, declaration.wireName,
                                "enum '" + declaration.name + "'", declaration.source);
  result.node.annotations = {{"cxx", quoted(declaration.name)},
                             {"underlying", quoted(capnpScalar(declaration.underlying))}};
  addLifecycle(result.node.annotations, declaration.lifecycle);
  result.was = model::formerName(declaration.name, declaration.was);
  result.node.doc = declaration.doc.text;
  for (const model::Enumerator& enumerator : declaration.enumerators) {
    Member member = plain(enumerator.wireName, "", enumerator.doc.text);
    addCxxName(member, enumerator.name);
    member.annotations.emplace("value", std::to_string(enumerator.value));
    if (enumerator.fallback) member.annotations.emplace("fallback", "");
    addLifecycle(member.annotations, enumerator.lifecycle);
    result.members.push_back({std::move(member),
                              "enumerator '" + declaration.name + "::" + enumerator.name + "'",
                              enumerator.was, enumerator.source});
  }
  return result;
}

WantedMember wantedField(const model::Struct& owner, const model::Field& field,
                         const model::Lookup& lookup, const model::Header& header) {
  Member member = plain(field.wireName, wireType(field.type, lookup, header), field.doc.text);
  member.annotations = valueAnnotations(field.type, field.unit, field.range);
  member.defaultValue = capnpDefault(field, lookup);
  addLifecycle(member.annotations, field.lifecycle);
  addCxxName(member, field.name);
  return {std::move(member), "field '" + owner.name + "::" + field.name + "'", field.was,
          field.source};
}

WantedNode wantedStruct(const model::Struct& declaration, const model::Lookup& lookup,
                        const model::Header& header) {
  WantedNode result = startNode(Node::Kind::Struct, declaration.name, declaration.wireName,
                                "struct '" + declaration.name + "'", declaration.source);
  result.node.annotations = {{"cxx", quoted(declaration.name)}};
  addLifecycle(result.node.annotations, declaration.lifecycle);
  result.was = model::formerName(declaration.name, declaration.was);
  result.node.doc = declaration.doc.text;
  for (const model::Field& field : declaration.fields) {
    result.members.push_back(wantedField(declaration, field, lookup, header));
  }
  return result;
}

void addMember(WantedNode& node, Member member) {
  node.members.push_back({std::move(member), node.title, std::nullopt, node.source});
}

/// Returns the member for the coefficients of a matrix of any size.
Member matrixData(const model::Type& type) {
  const std::string scalar(capnpScalar(type.scalar));
  Member data = plain("data", type.bulk ? "Data" : "List(" + scalar + ")", "Column after column.");
  if (type.bulk) data.annotations.emplace("bulk", quoted(scalar));
  return data;
}

/// Returns the struct of a composite. The field states the bounds, not the struct, because two
/// types of one wire form share it.
WantedNode wantedComposite(const model::Type& type, const model::Source& source,
                           const model::Lookup& lookup, const model::Header& header) {
  const std::string name = compositeName(type, lookup, header);
  WantedNode result =
      startNode(Node::Kind::Struct, "", name, "the wire form of '" + type.spelling + "'", source);
  result.node.isUnion = type.shape == Shape::Optional || type.shape == Shape::Variant;
  if (type.shape == Shape::Optional) addMember(result, plain("none", "Void"));
  const std::vector<std::string> names = compositeMembers(type, lookup, header);
  for (std::size_t i = 0; i < type.element.size(); ++i) {
    const model::Type& element = type.element[i];
    Member member = plain(names[i], wireType(element, lookup, header));
    member.annotations = typeAnnotations(element);
    member.annotations.erase("capacity");
    member.annotations.erase("distinct");  // the name says it: "SetOfInt32"
    addMember(result, std::move(member));
  }
  if (type.shape == Shape::AnyMatrix) {
    addMember(result, plain("rows", "UInt32"));
    addMember(result, plain("columns", "UInt32"));
    addMember(result, matrixData(type));
  }
  return result;
}

/// Calls visit(the wire form of a composite, the source of what has it) for each use of one.
template <class Visit>
void forEachWireForm(const model::Header& header, const model::Lookup& lookup, const Visit& visit) {
  const model::Source source{0, header.path, 0};
  const auto all = [](const model::Struct&) { return true; };
  forEachComposite(header, all, [&](const model::Type& type, const model::Source& user) {
    visit(wantedComposite(type, source, lookup, header), user);
  });
}

/// Returns each composite of the header once.
std::vector<WantedNode> wantedComposites(const model::Header& header, const model::Lookup& lookup) {
  std::vector<WantedNode> nodes;
  std::set<std::string> seen;
  forEachWireForm(header, lookup, [&](WantedNode node, const model::Source&) {
    if (seen.insert(node.node.name).second) nodes.push_back(std::move(node));
  });
  return nodes;
}

/// Tells if bytes of two composites mean the same. The types in C++ may differ: a pair travels as a
/// tuple does.
bool areAlike(const WantedNode& one, const WantedNode& other) {
  const auto same = [](const WantedMember& a, const WantedMember& b) {
    return a.member.name == b.member.name && a.member.type == b.member.type &&
           a.member.annotations == b.member.annotations;
  };
  return one.node.isUnion == other.node.isUnion &&
         std::equal(one.members.begin(), one.members.end(), other.members.begin(),
                    other.members.end(), same);
}

const char* kindName(model::CommandKind kind) {
  switch (kind) {
    case model::CommandKind::Void: return "void";
    case model::CommandKind::Write: return "write";
    case model::CommandKind::Read: return "read";
    case model::CommandKind::QualifiedRead: return "qualifiedRead";
    case model::CommandKind::VoidReturn: return "voidReturn";
    case model::CommandKind::WriteReturn: return "writeReturn";
  }
  return "";
}

WantedMember wantedCommand(const model::Interface& owner, const model::Command& command,
                           const model::Lookup& lookup, const model::Header& header) {
  Member member = method(command.wireName, command.doc.text);
  addCxxName(member, command.name);
  member.annotations.emplace("kind", quoted(kindName(command.kind)));
  for (const model::Parameter& parameter : command.parameters) {
    Member one = plain(parameter.wireName, wireType(parameter.type, lookup, header));
    one.annotations = valueAnnotations(parameter.type, parameter.unit, parameter.range);
    addCxxName(one, parameter.name);
    member.parameters.push_back(std::move(one));
  }
  member.parameters.push_back(plain("sent", kSent));
  if (command.result) {
    member.results = {plain("value", wireType(*command.result, lookup, header))};
    member.results.front().annotations =
        valueAnnotations(*command.result, command.resultUnit, command.resultRange);
  }
  if (command.kind == model::CommandKind::Read) member.results.push_back(plain("stamp", "Int64"));
  const bool queued =
      command.kind != model::CommandKind::Read && command.kind != model::CommandKind::QualifiedRead;
  if (queued) member.annotations.emplace("queue", std::to_string(command.queue));
  if (command.latest) member.annotations.emplace("latest", "");
  if (command.ttlNanoseconds) {
    member.annotations.emplace("ttl", std::to_string(*command.ttlNanoseconds));
  }
  if (command.deadlineNanoseconds) {
    member.annotations.emplace("deadline", std::to_string(*command.deadlineNanoseconds));
  }
  if (command.optional) member.annotations.emplace("optional", "");
  if (command.concurrent) member.annotations.emplace("concurrent", "");
  if (command.direct) member.annotations.emplace("direct", "");
  addLifecycle(member.annotations, command.lifecycle);
  return {std::move(member), "command '" + owner.name + "::" + command.name + "'", command.was,
          command.source};
}

WantedNode wantedInterface(const model::Interface& declaration, const model::Lookup& lookup,
                           const model::Header& header) {
  WantedNode result = startNode(Node::Kind::Interface, declaration.name, declaration.wireName,
                                "interface '" + declaration.name + "'", declaration.source);
  result.node.annotations = {{"cxx", quoted(declaration.name)}};
  if (declaration.version > 1) {
    result.node.annotations.emplace("version", std::to_string(declaration.version));
  }
  addLifecycle(result.node.annotations, declaration.lifecycle);
  if (!declaration.base.empty()) {
    result.node.extends = {declaredType(declaration.base, lookup, header)};
  }
  result.node.doc = declaration.doc.text;

  Member subscribe = method("subscribe",
                            "Bit i of eventMask asks for event i, bit i of stateMask for column i; "
                            "a later call replaces an earlier one.");
  subscribe.parameters = {plain("events", declaration.wireName + "Events"),
                          plain("eventMask", "UInt64"), plain("stateMask", "UInt64")};
  result.members.push_back({std::move(subscribe), result.title, std::nullopt, result.source});
  for (const model::Command& command : declaration.commands) {
    if (!command.inheritedFrom.empty()) continue;  // the base's interface has the method
    result.members.push_back(wantedCommand(declaration, command, lookup, header));
  }
  return result;
}

WantedMember wantedEvent(const model::Interface& owner, const model::Event& event,
                         const model::Lookup& lookup, const model::Header& header) {
  Member member = method(event.wireName, event.doc.text);
  addCxxName(member, event.name);
  for (std::size_t i = 0; i < event.payload.size(); ++i) {
    const model::Type& type = event.payload[i];
    const model::Limits limits = i < event.limits.size() ? event.limits[i] : model::Limits{};
    Member value = plain(payloadName(i), wireType(type, lookup, header));
    value.annotations = valueAnnotations(type, limits.unit, limits.range);
    member.parameters.push_back(std::move(value));
  }
  member.parameters.push_back(plain("stamp", "Int64"));
  member.annotations.emplace("queue", std::to_string(event.queue));
  if (event.latest) member.annotations.emplace("latest", "");
  if (event.latched) member.annotations.emplace("latched", "");
  addLifecycle(member.annotations, event.lifecycle);
  return {std::move(member), "event '" + owner.name + "::" + event.member + "'", event.was,
          event.source};
}

WantedNode wantedEvents(const model::Interface& declaration, const model::Lookup& lookup,
                        const model::Header& header) {
  WantedNode result =
      startNode(Node::Kind::Interface, declaration.name, declaration.wireName + "Events",
                "events of '" + declaration.name + "'", declaration.source);
  result.node.annotations = {{"eventsOf", quoted(declaration.name)}};
  result.node.doc = "What a subscriber of " + declaration.wireName + " receives.";
  Member state = method("state", "A new row of the columns asked for.");
  state.parameters = {plain("row", declaration.wireName + "StateRow")};
  result.members.push_back({std::move(state), result.title, std::nullopt, result.source});
  for (const model::Event& event : declaration.events) {
    result.members.push_back(wantedEvent(declaration, event, lookup, header));
  }
  return result;
}

WantedNode wantedState(const model::Interface& declaration, const model::Lookup& lookup,
                       const model::Header& header) {
  WantedNode result =
      startNode(Node::Kind::Struct, declaration.name, declaration.wireName + "StateRow",
                "state of '" + declaration.name + "'", declaration.source);
  result.node.annotations = {{"stateOf", quoted(declaration.name)}};
  result.node.doc =
      "One row of the state table: what the read commands of " + declaration.wireName + " answer.";
  const auto builtIn = [&](const char* name, const char* type, const char* doc) {
    result.members.push_back({plain(name, type, doc), result.title, std::nullopt, result.source});
  };
  builtIn("stamp", "Int64", "When the row was written: the provider's steady clock, ns.");
  builtIn("evaluated", "UInt64", "Bit i: column i was evaluated.");
  builtIn("tooLarge", "UInt64", "Bit i: column i did not fit its declared capacity.");
  for (const model::Command& command : declaration.commands) {
    if (command.kind != model::CommandKind::Read) continue;
    Member column = plain(command.wireName, wireType(*command.result, lookup, header));
    column.annotations = valueAnnotations(*command.result, command.resultUnit, command.resultRange);
    addCxxName(column, command.name);
    if (command.optional) column.annotations.emplace("optional", "");
    result.members.push_back({std::move(column),
                              "command '" + declaration.name + "::" + command.name + "'",
                              command.was, command.source});
  }
  return result;
}

}  // namespace

std::vector<WantedNode> wanted(const model::Header& header, const model::Lookup& lookup) {
  std::vector<WantedNode> nodes;
  for (const model::Enum& declaration : header.enums) nodes.push_back(wantedEnum(declaration));
  for (WantedNode& composite : wantedComposites(header, lookup)) {
    nodes.push_back(std::move(composite));
  }
  for (const model::Struct& declaration : header.structs) {
    nodes.push_back(wantedStruct(declaration, lookup, header));
  }
  for (const model::Interface& declaration : header.interfaces) {
    const auto was = model::formerName(declaration.name, declaration.was);
    for (const auto& part : {wantedInterface, wantedEvents, wantedState}) {
      nodes.push_back(part(declaration, lookup, header));
      nodes.back().was = was;
    }
  }
  return nodes;
}

std::vector<CompositeClash> compositeClashes(const model::Header& header,
                                             const model::Lookup& lookup) {
  std::map<std::string, WantedNode> owners;
  std::set<std::string> told;
  std::vector<CompositeClash> clashes;
  forEachWireForm(header, lookup, [&](WantedNode node, const model::Source& user) {
    node.source = user;
    const auto [owner, isNew] = owners.emplace(node.node.name, node);
    if (isNew || areAlike(owner->second, node) || !told.insert(node.title).second) return;
    clashes.push_back({owner->second, std::move(node)});
  });
  return clashes;
}

std::string payloadName(std::size_t index) {
  return index == 0 ? "value" : "value" + std::to_string(index + 1);
}

std::uint64_t freshId(const std::string& project, const std::string& name) {
  const auto digest = sha256(project + "\n" + name);
  std::uint64_t id = 0;
  for (unsigned i = 0; i < 8; ++i) id = id << 8 | digest[i];
  return id | std::uint64_t{1} << 63;  // capnp demands the top bit
}

std::string identity(const Node& node) {
  for (const char* name : kIdentities) {
    const auto found = node.annotations.find(name);
    if (found != node.annotations.end()) return name + (" " + found->second);
  }
  return node.name;
}

std::string formerIdentity(const WantedNode& wanted) {
  if (!wanted.was) return "";
  for (const char* name : kIdentities) {
    if (wanted.node.annotations.contains(name)) return name + (" " + quoted(*wanted.was));
  }
  return "";
}

}  // namespace suture::compiler::lock
