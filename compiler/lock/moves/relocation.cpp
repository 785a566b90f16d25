#include <map>
#include <string>
#include <utility>

#include "compiler/lock/moves/moves.h"
#include "compiler/lock/moves/nodes.h"

namespace suture::compiler::lock {
namespace {

class Relocation {
 public:
  Relocation(const Locks& locks, const std::vector<Move>& moves) : locks_(locks) {
    for (const Move& move : moves) moves_.emplace(move.from, move);
  }

  Locks run() const {
    Locks result = locks_;
    for (auto& [path, lock] : result.files) {
      std::erase_if(lock.nodes, [&](const Node& node) { return leaves(path, node); });
      for (Node& node : lock.nodes) respell(node, path, path, &lock.followed);
    }
    for (const auto& [from, move] : moves_) {
      const Node* const node = nodeAt(locks_, from);
      if (node == nullptr || !leaves(from.path, *node)) continue;
      Lock& target = result.files[move.to.path];
      target.path = move.to.path;
      if (nodeWithId(target, node->id) != nullptr) continue;
      Node arrived = *node;
      arrived.name = move.to.name;
      arrived.cameFrom = from;
      respell(arrived, from.path, target.path, nullptr);
      target.nodes.push_back(std::move(arrived));
    }
    return result;
  }

 private:
  bool leaves(const std::string& path, const Node& node) const {
    const auto move = moves_.find({path, node.name});
    return move != moves_.end() && !move->second.isRename() && move->second.id == node.id;
  }

  /// Spells what a node names from the file `inside`, where it is, while it stood in `home`.
  void respell(Node& node, const std::string& home, const std::string& inside,
               std::map<std::string, std::string>* followed) const {
    forEachType(node, node.extends, [&](std::string& type) {
      const TypePlace before = placeOf(type, home);
      const auto move = moves_.find(before);
      const bool isKept =
          move == moves_.end() || (move->second.isRename() && before.path == inside);
      const TypePlace& now = isKept ? before : move->second.to;
      if (isKept && (home == inside || nodeAt(locks_, before) == nullptr)) return;
      type = withLeaf(type, now.spelled(inside));
      const bool isForeign = before.path != inside && now.path != inside;
      if (followed != nullptr && isForeign) followed->emplace(before.text(), now.text());
    });
  }

  const Locks& locks_;
  std::map<TypePlace, Move> moves_;
};

}  // namespace

Locks relocated(const Locks& locks, const std::vector<Move>& moves) {
  return Relocation(locks, moves).run();
}

}  // namespace suture::compiler::lock
