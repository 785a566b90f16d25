#include "compiler/lock/contract_hash.h"

#include <set>

#include "compiler/lock/majors.h"
#include "compiler/lock/merge.h"
#include "compiler/lock/sha256.h"
#include "compiler/lock/wire_type.h"

namespace suture::compiler::lock {
namespace {

/// Writes out a node and, behind it, everything that it names.
class Canonical {
 public:
  Canonical(const std::map<std::string, Lock>& locks, bool withoutOptional)
      : locks_(locks), withoutOptional_(withoutOptional) {}

  void add(const Lock& lock, const std::string& name) {
    for (const Node& node : lock.nodes) {
      if (node.name == name && seen_.insert(lock.path + ":" + name).second) write(lock, node);
    }
  }

  const std::string& text() const { return text_; }

 private:
  void write(const Lock& lock, const Node& node) {
    text_ += identity(node) + " " + node.name + " " + std::to_string(node.id);
    const auto version = node.annotations.find("version");
    text_ += version == node.annotations.end() ? "" : " version " + version->second;
    if (majorOf(node) > 1) text_ += " major " + std::to_string(majorOf(node));
    text_ += node.isUnion ? " union\n" : "\n";
    for (const Member& member : node.members) {
      if (counts(member)) write(member);
    }
    for (const std::string& base : node.extends) follow(lock, base);
    for (const Member& member : node.members) {
      if (counts(member)) follow(lock, member);
    }
  }

  bool counts(const Member& member) const {
    return !member.removed() && !(withoutOptional_ && member.annotations.contains("optional"));
  }

  void write(const Member& member) {
    text_ += std::to_string(member.ordinal) + " " + member.name + " " + member.type;
    for (const char* const name : kMeaningful) {
      const auto found = member.annotations.find(name);
      if (found != member.annotations.end()) text_ += std::string(" ") + name + found->second;
    }
    text_ += member.defaultValue.empty() ? "\n" : " = " + member.defaultValue + "\n";
    for (const Member& parameter : member.parameters) write(parameter);
    if (member.isMethod) text_ += "->\n";
    for (const Member& result : member.results) write(result);
  }

  void follow(const Lock& lock, const Member& member) {
    for (const Member& parameter : member.parameters) follow(lock, parameter);
    for (const Member& result : member.results) follow(lock, result);
    follow(lock, member.type);
  }

  void follow(const Lock& lock, const std::string& type) {
    const std::size_t inner = type.rfind('(') + 1;  // 0 when there is no list
    const std::string leaf = type.substr(inner, type.find(')') - inner);
    if (leaf.empty() || leaf.front() != '/') {
      add(lock, leaf);
      return;
    }
    const std::size_t colon = leaf.find(':');
    const auto other = locks_.find(leaf.substr(1, colon - 1));
    if (other != locks_.end()) add(other->second, leaf.substr(colon + 1));
  }

  const std::map<std::string, Lock>& locks_;
  const bool withoutOptional_;
  std::set<std::string> seen_;
  std::string text_;
};

std::map<std::string, std::string> hashes(const model::Model& model, const Locks& locks,
                                          bool withoutOptional) {
  const model::Lookup lookup(model);
  std::map<std::string, Lock> merged;
  for (const model::Header& header : model.headers) {
    const std::string path = lockPath(header.path);
    const auto committed = locks.files.find(path);
    Lock old;
    if (committed != locks.files.end()) old = committed->second;
    merged.emplace(path, merge(wanted(header, lookup), header, old, {}).lock);
  }
  std::map<std::string, std::string> result;
  for (const model::Header& header : model.headers) {
    if (!header.own) continue;
    for (const model::Interface& interface : header.interfaces) {
      Canonical canonical(merged, withoutOptional);
      canonical.add(merged.at(lockPath(header.path)), interface.wireName);
      result.emplace(interface.name, sha256Hex(canonical.text(), 16));
    }
  }
  return result;
}

}  // namespace

std::map<std::string, std::string> contractHashes(const model::Model& model, const Locks& locks) {
  return hashes(model, locks, false);
}

std::map<std::string, std::string> coreHashes(const model::Model& model, const Locks& locks) {
  return hashes(model, locks, true);
}

}  // namespace suture::compiler::lock
