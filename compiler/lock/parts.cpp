#include "compiler/lock/parts.h"

#include <algorithm>
#include <utility>

#include "compiler/lock/moves/nodes.h"
#include "compiler/lock/schema/type_place.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/lock/schema/writer.h"

namespace suture::compiler::lock {

Parts::Parts(const Lock& lock, std::vector<std::string> paths, const Wishes& wishes)
    : lock_(lock), paths_(std::move(paths)) {
  std::map<std::string, std::vector<std::string>> users;
  std::vector<std::string> raised;
  for (const Node& node : lock.nodes) {
    const auto wish = wishes.find(identity(node));
    parts_[node.name] = wish == wishes.end() ? 0 : wish->second;
    names_.emplace(identity(node), node.name);
    raised.push_back(node.name);
    std::vector<std::string> bases = node.extends;
    forEachType(node, bases, [&](const std::string& type) {
      const TypePlace place = placeOf(type, lock.path);
      if (place.path == lock.path) users[place.name].push_back(node.name);
    });
  }
  while (!raised.empty()) {
    const std::string name = raised.back();
    raised.pop_back();
    for (const std::string& user : users[name]) {
      const auto found = parts_.find(name);
      if (found == parts_.end() || parts_[user] >= found->second) continue;
      parts_[user] = found->second;
      raised.push_back(user);
    }
  }
}

std::string Parts::fileOf(const std::string& identity) const {
  const auto name = names_.find(identity);
  return name == names_.end() ? "" : paths_[parts_.at(name->second)];
}

std::vector<model::Artefact> Parts::files() const {
  std::vector<model::Artefact> all;
  for (unsigned i = 0; i < paths_.size(); ++i) all.push_back({paths_[i], text(i)});
  return all;
}

std::string Parts::text(unsigned part) const {
  Lock one;
  one.path = paths_[part];
  one.id = freshId(std::to_string(lock_.id), one.path);
  one.cxxNamespace = lock_.cxxNamespace;
  one.header = lock_.header;
  for (const Node& node : lock_.nodes) {
    if (parts_.at(node.name) != part) continue;
    Node& copy = one.nodes.emplace_back(node);
    forEachType(copy, copy.extends, [&](std::string& type) {
      const TypePlace place = placeOf(type, lock_.path);
      const auto home = place.path == lock_.path ? parts_.find(place.name) : parts_.end();
      if (home == parts_.end()) return;
      type = withLeaf(type, TypePlace{paths_[home->second], place.name}.spelled(one.path));
    });
  }
  return write(one, "# This is a part of " + lock_.path + ", which is compiled in parts.\n");
}

}  // namespace suture::compiler::lock
