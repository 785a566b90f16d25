#include "compiler/lock/moves/moves.h"

#include <algorithm>
#include <set>
#include <utility>

#include "compiler/lock/moves/nodes.h"
#include "compiler/lock/schema/node_index.h"
#include "compiler/lock/schema/wanted.h"

namespace suture::compiler::lock {
namespace {

class Finder {
 public:
  Finder(const model::Model& model, const Locks& locks, const Options& options)
      : locks_(locks), options_(options) {
    const model::Lookup lookup(model);
    for (const model::Header& header : model.headers) {
      Home& home = homes_[lockPath(header.path)];
      home = {&header, wanted(header, lookup), {}};
      for (const WantedNode& one : home.wanted) home.identities.insert(identity(one.node));
    }
    for (const auto* const all : {&locks.files, &locks.others}) {
      for (const auto& [path, lock] : *all) indexes_.emplace(&lock, lock);
    }
  }

  std::vector<std::string> unknownNames() {
    std::vector<std::string> names;
    const Moves moves = run();
    std::set<TypePlace> arrived;
    for (const Move& one : moves.all) arrived.insert(one.to);
    for (const auto& [path, home] : homes_) {
      const Lock* const lock = lockAt(locks_, path);
      for (const WantedNode& one : home.wanted) {
        const bool isKnown =
            (lock != nullptr && find(*lock, identity(one.node), false) != nullptr) ||
            arrived.contains({path, one.node.name});
        if (!home.header->own || isKnown || !isDeclared(one.node)) continue;
        names.push_back(one.cxxName);
        if (one.was) names.push_back(*one.was);
      }
    }
    return names;
  }

  Moves run() {
    for (const auto& [path, home] : homes_) {
      for (const WantedNode& one : home.wanted) {
        if (isDeclared(one.node)) look(path, home, one);
      }
    }
    for (std::size_t i = 0; i < moves_.all.size(); ++i) addComposites(Move(moves_.all[i]));
    addRenamedFiles();
    addDepartures();
    return std::move(moves_);
  }

 private:
  struct Home {
    const model::Header* header = nullptr;
    std::vector<WantedNode> wanted;
    std::set<std::string> identities;
  };

  /// Looks for the node that `wanted` had so far.
  void look(const std::string& path, const Home& home, const WantedNode& wanted) {
    const Lock* const lock = lockAt(locks_, path);
    const std::string now = identity(wanted.node), former = formerIdentity(wanted);
    if (const Node* const node = lock == nullptr ? nullptr : find(*lock, now, false)) {
      return leave(*node, {path, node->name}, wanted);
    }
    const Node* const before = lock == nullptr ? nullptr : find(*lock, former, true);
    if (before != nullptr) return add({path, before->name}, {path, wanted.node.name}, before->id);
    if (arriveFromKnown(path, home, wanted) || !home.header->own) return;
    for (const auto& [other, from] : locks_.others) {
      const Node* const node = find(from, former, true);
      if (node != nullptr) return add({other, node->name}, {path, wanted.node.name}, node->id);
    }
    for (const auto& [other, from] : locks_.others) {
      const Node* const node = find(from, identity(wanted.node), true);
      if (node != nullptr) remark(*node, other, wanted);
    }
  }

  /// Looks in the locks of the other headers of the run. Returns true if one had it.
  bool arriveFromKnown(const std::string& path, const Home& home, const WantedNode& wanted) {
    const std::string now = identity(wanted.node);
    for (const std::string& name : {now, formerIdentity(wanted)}) {
      for (const auto& [other, from] : locks_.files) {
        const Node* const node = other == path ? nullptr : find(from, name, name != now);
        if (node == nullptr || isDeclaredIn(other, *node)) continue;
        arrive(*node, {other, node->name}, home, wanted);
        return true;
      }
    }
    return false;
  }

  const Node* find(const Lock& lock, const std::string& name, bool living) const {
    if (name.empty()) return nullptr;
    const NodeIndex& index = indexes_.at(&lock);
    return living ? index.living(name) : index.identified(name);
  }

  /// Tells if a header still declares the node of its lock.
  bool isDeclaredIn(const std::string& path, const Node& node) const {
    const auto home = homes_.find(path);
    return home != homes_.end() && home->second.identities.contains(identity(node));
  }

  bool isOwn(const std::string& path) const {
    const auto home = homes_.find(path);
    return home != homes_.end() && home->second.header->own;
  }

  /// Lets go what another lock has already taken over.
  void leave(const Node& taken, const TypePlace& to, const WantedNode& wanted) {
    for (const auto& [path, lock] : locks_.files) {
      const Node* const node = path == to.path ? nullptr : nodeWithId(lock, taken.id);
      if (node == nullptr || !homes_.contains(path) || isDeclaredIn(path, *node)) continue;
      if (!isOwn(path)) {
        await({path, node->name}, to, wanted);
      } else if (!hasSameNumbers(*node, taken)) {
        refuse({path, node->name}, to, wanted);
      }
      add({path, node->name}, to, node->id);
    }
    for (const auto& [path, lock] : locks_.files) {
      const Node* const node = path == to.path ? nullptr : find(lock, identity(taken), true);
      if (node == nullptr || node->id == taken.id || !isOwn(path)) continue;
      if (isDeclaredIn(path, *node)) continue;
      refuse({path, node->name}, to, wanted);
      moves_.found.back().severity = model::Diagnostic::Severity::Warning;  // it may be another
    }
  }

  /// Tells if no member has another number in `now`. A name that it does not have may be a new one.
  static bool hasSameNumbers(const Node& old, const Node& now) {
    return old.members.size() <= now.members.size() &&
           std::all_of(old.members.begin(), old.members.end(), [&](const Member& one) {
             return one.removed() ||
                    std::all_of(now.members.begin(), now.members.end(), [&](const Member& other) {
                      return other.name != one.name || other.ordinal == one.ordinal;
                    });
           });
  }

  void arrive(const Node& node, const TypePlace& from, const Home& home, const WantedNode& wanted) {
    const TypePlace to{lockPath(home.header->path), wanted.node.name};
    if (!isOwn(from.path)) {
      if (home.header->own) remark(node, from.path, wanted);
      return;
    }
    if (!home.header->own) {
      if (node.removed()) return;
      refuse(from, to, wanted);
    }
    add(from, to, node.id);
  }

  void add(const TypePlace& from, const TypePlace& to, std::uint64_t id) {
    if (from == to || !known_.insert(from).second) return;
    moves_.all.push_back({from, to, id});
  }

  void refuse(const TypePlace& from, const TypePlace& to, const WantedNode& wanted) {
    report(from.path, wanted,
           wanted.title + " moved to another header, and " + file(to) +
               " does not have it with the id and the numbers of " + file(from),
           "restore " + file(to) + " if it has another " + to.name + ", say was(\"" +
               wanted.cxxName +
               "\"), or the name of before, where it is declared now, and update " +
               "the lock of that target first");
  }

  /// Reports that another target still has to let go what has moved.
  void await(const TypePlace& from, const TypePlace& to, const WantedNode& wanted) {
    report(from.path, wanted,
           wanted.title + " moved to " + file(to) + ", and " + file(from) + " still has it",
           "update the lock of the target of " + homes_.at(from.path).header->path + " first");
  }

  std::string file(const TypePlace& place) const { return options_.folder + "/" + place.path; }

  void report(const std::string& path, const WantedNode& wanted, std::string message,
              std::string help) {
    moves_.found.push_back({{0, homes_.at(path).header->path, 0},
                            "lock-moved",
                            std::move(message),
                            std::move(help),
                            {{wanted.source, wanted.title + " is declared here"}}});
  }

  /// Remarks that a new type has the name of one in the lock of another target.
  void remark(const Node& node, const std::string& path, const WantedNode& wanted) {
    if (!wanted.node.annotations.contains("cxx")) return;
    const bool isSeen = homes_.contains(path);
    moves_.found.push_back(
        {wanted.source,
         "lock-moved",
         wanted.title + " is new here, and " + options_.folder + "/" + path +
             (isSeen ? ", of another target, keeps one of that name" : " has one of that name"),
         isSeen
             ? "if it is the same, declare it in a header that its old one includes: only from "
               "there it can take its place on the wire along"
             : "if it is the same, moved to this header, say was(\"" + wanted.cxxName + "\") on it",
         {{{0, options_.folder + "/" + path, node.line}, "the other lock has: " + node.name}},
         model::Diagnostic::Severity::Warning});
  }

  /// Lets composites follow a node that nothing else in its old file needs.
  void addComposites(const Move& move) {
    const Lock* const lock = move.isRename() ? nullptr : lockAt(locks_, move.from.path);
    const Node* const node = lock == nullptr ? nullptr : nodeNamed(*lock, move.from.name);
    if (node == nullptr) return;
    const Lock* const target = lockAt(locks_, move.to.path);
    for (const Member& member : node->members) {
      forEachType(member, [&](const std::string& type) {
        const TypePlace place = placeOf(type, lock->path);
        const Node* const part = nodeAt(locks_, place);
        if (place.path != lock->path || part == nullptr || isDeclared(*part)) return;
        if (part->removed() || isWanted(place)) return;
        const Node* const taken = target == nullptr ? nullptr : nodeWithId(*target, part->id);
        add(place, {move.to.path, taken == nullptr ? part->name : taken->name}, part->id);
      });
    }
  }

  bool isWanted(const TypePlace& place) const {
    const auto home = homes_.find(place.path);
    if (home == homes_.end()) return isUsed(place);
    const std::vector<WantedNode>& all = home->second.wanted;
    return std::any_of(all.begin(), all.end(),
                       [&](const WantedNode& one) { return one.node.name == place.name; });
  }

  /// Tells if something that stays in the lock names it.
  bool isUsed(const TypePlace& place) const {
    bool used = false;
    for (const Node& node : lockAt(locks_, place.path)->nodes) {
      if (node.removed() || known_.contains({place.path, node.name})) continue;
      for (const Member& member : node.members) {
        forEachType(member, [&](const std::string& type) {
          used = used || placeOf(type, place.path) == place;
        });
      }
    }
    return used;
  }

  /// Adds what moved before: a lock of a target that was not updated since names it as it was.
  void addDepartures() {
    for (const auto& [path, lock] : locks_.files) {
      for (const Departure& one : lock.departures) {
        const TypePlace from = placeOf(one.name, path);
        const TypePlace to = homeOf(one);
        if (nodeAt(locks_, from) == nullptr) add(from, to, one.id);
      }
    }
  }

  /// Adds what stands in a lock that was renamed together with its header.
  void addRenamedFiles() {
    for (const auto& [path, lock] : locks_.files) {
      const std::string before = lockPath(lock.header);
      if (lock.header.empty() || before == path || locks_.files.contains(before)) continue;
      for (const Node& node : lock.nodes) {
        if (isDeclared(node)) add({before, node.name}, moved({path, node.name}), node.id);
      }
    }
  }

  /// Returns where the thing is now, which may have moved on.
  TypePlace homeOf(const Departure& departure) const {
    TypePlace place = departure.to;
    std::set<std::string> seen;
    while (seen.insert(place.path).second) {
      const Lock* const lock = lockAt(locks_, place.path);
      if (lock == nullptr) break;
      if (const Node* const node = nodeWithId(*lock, departure.id)) {
        return moved({place.path, node->name});
      }
      for (const Departure& one : lock->departures) {
        if (one.id == departure.id && one.to.path != place.path) place = one.to;
      }
    }
    return place;
  }

  /// Returns where a node of a lock goes in this run.
  TypePlace moved(const TypePlace& place) const {
    for (const Move& move : moves_.all) {
      if (move.from == place) return move.to;
    }
    return place;
  }

  const Locks& locks_;
  const Options& options_;
  std::map<const Lock*, NodeIndex> indexes_;
  std::map<std::string, Home> homes_;
  std::set<TypePlace> known_;
  Moves moves_;
};

}  // namespace

std::vector<std::string> unknownNames(const model::Model& model, const Locks& locks) {
  return Finder(model, locks, {}).unknownNames();
}

Moves findMoves(const model::Model& model, const Locks& locks, const Options& options) {
  return Finder(model, locks, options).run();
}

std::vector<Move> movesBetween(const Locks& old, const Locks& now) {
  std::map<std::uint64_t, TypePlace> places;
  for (const auto& [path, lock] : now.files) {
    for (const Node& node : lock.nodes) places.emplace(node.id, TypePlace{path, node.name});
  }
  std::vector<Move> moves;
  for (const auto& [path, lock] : old.files) {
    const Lock* const same = lockAt(now, path);
    for (const Node& node : lock.nodes) {
      const bool isHere = same != nullptr && nodeWithId(*same, node.id) != nullptr;
      const auto found = places.find(node.id);
      if (found == places.end() || (isHere && found->second.path != path)) continue;
      Move move{{path, node.name}, found->second, node.id};
      if (!isDeclared(node)) move.to.name = node.name;
      if (move.from != move.to) moves.push_back(std::move(move));
    }
  }
  return moves;
}

}  // namespace suture::compiler::lock
