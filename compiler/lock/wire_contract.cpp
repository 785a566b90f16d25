#include "compiler/lock/wire_contract.h"

#include "compiler/lock/merge.h"
#include "compiler/lock/schema/type_place.h"

namespace suture::compiler::lock {

std::map<std::string, Lock> upToDate(const model::Model& model, const Locks& locks) {
  const model::Lookup lookup(model);
  std::map<std::string, Lock> merged;
  for (const model::Header& header : model.headers) {
    const std::string path = lockPath(header.path);
    const auto committed = locks.files.find(path);
    Lock old;
    if (committed != locks.files.end()) old = committed->second;
    merged.emplace(path, merge(wanted(header, lookup), header, old, Options().project));
  }
  return merged;
}

void WireContract::add(const Lock& lock, const std::string& type) {
  const PlacedNode found = find(lock, type);
  if (found.node == nullptr || !known_.insert(found.node).second) return;
  nodes_.push_back(found);
  for (const std::string& base : found.node->extends) add(*found.lock, base);
  for (const Member& member : found.node->members) {
    if (counts(member)) add(*found.lock, member);
  }
}

void WireContract::add(const Lock& lock, const Member& member) {
  for (const Member& parameter : member.parameters) add(lock, parameter);
  for (const Member& result : member.results) add(lock, result);
  add(lock, member.type);
}

PlacedNode WireContract::find(const Lock& lock, const std::string& type) const {
  const TypePlace place = placeOf(type, lock.path);
  const auto home = locks_.find(place.path);
  if (home == locks_.end()) return {};
  const Node* const node = home->second.named(place.name);
  return node == nullptr ? PlacedNode{} : PlacedNode{&home->second.lock(), node};
}

}  // namespace suture::compiler::lock
