#include "compiler/emit/wire/wire_nodes.h"

#include <nlohmann/json.hpp>

#include "compiler/lock/major_versions.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/lock/schema/writer.h"
#include "compiler/lock/wire_contract.h"

namespace suture::compiler::emit {
namespace {

using Json = nlohmann::ordered_json;

const char* kindOf(const lock::Node& node) {
  switch (node.kind) {
    case lock::Node::Kind::Struct: return node.isUnion ? "union" : "struct";
    case lock::Node::Kind::Enum: return "enum";
    case lock::Node::Kind::Interface: return "interface";
  }
  return "";
}

/// Returns "List(@0xf284...) unit \"m\" = 2.5".
std::string meaningOf(const lock::WireContract& contract, const lock::Lock& lock,
                      const lock::Member& member) {
  std::string text = member.type;
  if (const lock::PlacedNode declared = contract.find(lock, text); declared.node != nullptr) {
    const std::string leaf = lock::leafOf(text);
    text.replace(text.rfind(leaf), leaf.size(), lock::idText(declared.node->id));
  }
  for (const char* const name : lock::kMeaningful) {
    const auto found = member.annotations.find(name);
    if (found == member.annotations.end()) continue;
    text += (text.empty() ? "" : " ") + std::string(name) + " " + found->second;
  }
  return member.defaultValue.empty() ? text : text + " = " + member.defaultValue;
}

Json memberOf(const lock::WireContract& contract, const lock::Lock& lock,
              const lock::Member& member, unsigned place) {
  Json json{{"at", place}, {"name", member.name}};
  if (const std::string meaning = meaningOf(contract, lock, member); !meaning.empty()) {
    json["is"] = meaning;
  }
  const auto addAll = [&](const char* key, const std::vector<lock::Member>& values) {
    for (unsigned i = 0; i < values.size(); ++i) {
      json[key].push_back(memberOf(contract, lock, values[i], i));
    }
  };
  addAll("parameters", member.parameters);
  addAll("results", member.results);
  return json;
}

}  // namespace

Json wireNodes(const Context& context, const model::Interface& interface) {
  const std::string path = lock::lockPath(context.lookup.headerOf(interface.name)->path);
  lock::WireContract contract(context.schemas, /*withoutOptional=*/false);
  contract.add(context.schemas.at(path).lock(), interface.wireName);
  Json json = Json::array();
  for (const lock::PlacedNode& one : contract.nodes()) {
    Json node{
        {"id", lock::idText(one.node->id)}, {"kind", kindOf(*one.node)}, {"name", one.node->name}};
    if (const auto cxx = one.node->annotations.find("cxx"); cxx != one.node->annotations.end()) {
      if (one.node->kind == lock::Node::Kind::Interface) node["cxx"] = lock::unquoted(cxx->second);
    }
    if (const unsigned major = lock::majorOf(*one.node); major > 1) node["major"] = major;
    const auto version = one.node->annotations.find("version");
    if (version != one.node->annotations.end()) node["version"] = std::stoul(version->second);
    node["members"] = Json::array();
    for (const lock::Member& member : one.node->members) {
      if (!contract.counts(member)) continue;
      node["members"].push_back(memberOf(contract, *one.lock, member, member.ordinal));
    }
    json.push_back(std::move(node));
  }
  return json;
}

}  // namespace suture::compiler::emit
