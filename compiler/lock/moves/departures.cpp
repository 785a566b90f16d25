#include <algorithm>
#include <set>
#include <string>

#include "compiler/lock/moves/moves.h"
#include "compiler/lock/moves/nodes.h"

namespace suture::compiler::lock {
namespace {

/// Lets placeholders name nothing of other files.
class Placeholders {
 public:
  Placeholders(const Locks& locks, const std::vector<Move>& moves) : locks_(locks) {
    for (const Move& move : moves) {
      places_.insert(move.to);
      if (!move.isRename()) ids_.insert(move.id);
    }
  }

  void run(const Lock& old, Lock& merged) const {
    for (Node& node : merged.nodes) {
      const Node* const before = nodeWithId(old, node.id);
      for (std::size_t i = 0; i < node.members.size(); ++i) {
        Member& member = node.members[i];
        if (before == nullptr || i >= before->members.size()) continue;
        if (!node.removed() && !member.removed()) continue;
        // A node may be declared again, so it forgets only what it must.
        const bool isNew = member.removed() && !before->members[i].removed();
        forEachType(member, [&](std::string& type) {
          const TypePlace place = placeOf(type, merged.path);
          const bool hasMoved = places_.contains(place) || ids_.contains(node.id);
          if (place.path != merged.path && (hasMoved || isNew)) forget(type, place);
        });
      }
    }
  }

 private:
  void forget(std::string& type, const TypePlace& place) const {
    const Node* const named = nodeAt(locks_, place);
    if (named == nullptr) return;  // it is one of Suture's, which never move
    const bool isEnum = named->kind == Node::Kind::Enum && leafOf(type) == type;
    type = isEnum ? kForgottenEnum : kForgotten;
  }

  const Locks& locks_;
  std::set<TypePlace> places_;
  std::set<std::uint64_t> ids_;
};

}  // namespace

void noteMoves(const Lock& old, Lock& merged, const Locks& locks, const std::vector<Move>& moves) {
  Placeholders(locks, moves).run(old, merged);
  for (const Move& move : moves) {
    // If the old place has no lock any more, or one that this run does not read, the lock of the
    // new place tells of the move.
    const bool isHere = move.to.path == merged.path && !locks.files.contains(move.from.path);
    const std::string name = move.from.spelled(merged.path);
    const auto isThis = [&](const Departure& one) { return one.name == name; };
    auto& all = merged.departures;
    if (move.from.path != merged.path && !isHere) continue;
    if (std::none_of(all.begin(), all.end(), isThis)) all.push_back({name, move.id, move.to});
  }
  std::erase_if(merged.departures,
                [&](const Departure& one) { return nodeNamed(merged, one.name) != nullptr; });
}

}  // namespace suture::compiler::lock
