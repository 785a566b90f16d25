#include "compiler/lock/contract_hash.h"

#include "compiler/lock/major_versions.h"
#include "compiler/lock/schema/sha256.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/lock/wire_contract.h"

namespace suture::compiler::lock {
namespace {

void write(const Annotations& annotations, const char* name, std::string& text) {
  const auto found = annotations.find(name);
  if (found != annotations.end()) text += std::string(" ") + name + found->second;
}

void write(const Member& member, std::string& text) {
  text += std::to_string(member.ordinal) + " " + member.name + " " + member.type;
  for (const char* const name : kMeaningful) write(member.annotations, name, text);
  // Where the hashes are equal, nobody looks for an element that is there twice.
  write(member.annotations, "distinct", text);
  text += member.defaultValue.empty() ? "\n" : " = " + member.defaultValue + "\n";
  for (const Member& parameter : member.parameters) write(parameter, text);
  if (member.isMethod) text += "->\n";
  for (const Member& result : member.results) write(result, text);
}

void write(const WireContract& contract, const Node& node, std::string& text) {
  text += identity(node) + " " + node.name + " " + std::to_string(node.id);
  const auto version = node.annotations.find("version");
  text += version == node.annotations.end() ? "" : " version " + version->second;
  if (majorOf(node) > 1) text += " major " + std::to_string(majorOf(node));
  text += node.isUnion ? " union\n" : "\n";
  for (const Member& member : node.members) {
    if (contract.counts(member)) write(member, text);
  }
}

std::map<std::string, std::string> hashes(const model::Model& model,
                                          const std::map<std::string, Lock>& schemas,
                                          bool withoutOptional) {
  std::map<std::string, std::string> result;
  const NodeIndexes indexes = indexed(schemas);
  for (const model::Header& header : model.headers) {
    if (!header.own) continue;
    for (const model::Interface& interface : header.interfaces) {
      WireContract contract(indexes, withoutOptional);
      contract.add(schemas.at(lockPath(header.path)), interface.wireName);
      std::string text;
      for (const PlacedNode& one : contract.nodes()) write(contract, *one.node, text);
      result.emplace(interface.name, sha256Hex(text, 16));
    }
  }
  return result;
}

}  // namespace

std::map<std::string, std::string> contractHashes(const model::Model& model,
                                                  const std::map<std::string, Lock>& schemas) {
  return hashes(model, schemas, false);
}

std::map<std::string, std::string> coreHashes(const model::Model& model,
                                              const std::map<std::string, Lock>& schemas) {
  return hashes(model, schemas, true);
}

}  // namespace suture::compiler::lock
