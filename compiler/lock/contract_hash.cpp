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
  explicit Canonical(const std::map<std::string, Lock>& locks) : locks_(locks) {}

  void add(const Lock& lock, const std::string& name) {
    for (const Node& node : lock.nodes) {
      if (node.name == name && seen_.insert(lock.path + ":" + name).second) write(lock, node);
    }
  }

  const std::string& text() const { return text_; }

 private:
  void write(const Lock& lock, const Node& node) {
    text_ += identity(node) + " " + node.name + " " + std::to_string(node.id) + "\n";
    if (majorOf(node) > 1) text_ += "major " + std::to_string(majorOf(node)) + "\n";
    for (const Member& member : node.members) {
      if (!member.removed()) write(member);
    }
    for (const Member& member : node.members) follow(lock, member);
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
    if (member.removed()) return;
    for (const Member& parameter : member.parameters) follow(lock, parameter);
    for (const Member& result : member.results) follow(lock, result);
    const std::size_t inner = member.type.rfind('(') + 1;  // 0 when there is no list
    const std::string leaf = member.type.substr(inner, member.type.find(')') - inner);
    if (leaf.empty() || leaf.front() != '/') {
      add(lock, leaf);
      return;
    }
    const std::size_t colon = leaf.find(':');
    const auto other = locks_.find(leaf.substr(1, colon - 1));
    if (other != locks_.end()) add(other->second, leaf.substr(colon + 1));
  }

  const std::map<std::string, Lock>& locks_;
  std::set<std::string> seen_;
  std::string text_;
};

}  // namespace

std::map<std::string, std::string> contractHashes(const model::Model& model, const Locks& locks) {
  const model::Lookup lookup(model);
  std::map<std::string, Lock> merged;
  for (const model::Header& header : model.headers) {
    const std::string path = lockPath(header.path);
    const auto committed = locks.files.find(path);
    Lock old;
    if (committed != locks.files.end()) old = committed->second;
    merged.emplace(path, merge(wanted(header, lookup), header, old, {}).lock);
  }
  std::map<std::string, std::string> hashes;
  for (const model::Header& header : model.headers) {
    if (!header.own) continue;
    for (const model::Interface& interface : header.interfaces) {
      Canonical canonical(merged);
      canonical.add(merged.at(lockPath(header.path)), interface.wireName);
      hashes.emplace(interface.name, sha256Hex(canonical.text(), 16));
    }
  }
  return hashes;
}

}  // namespace suture::compiler::lock
