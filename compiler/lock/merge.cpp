#include "compiler/lock/merge.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "compiler/lock/schema/renames.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::lock {
namespace {

class Merger {
 public:
  Merger(const std::vector<WantedNode>& wanted, const Lock& old, const std::string& project)
      : wanted_(wanted), old_(old), project_(project) {}

  Lock run(const model::Header& header) {
    Lock result = old_;
    result.nodes.clear();
    result.header = header.path;
    result.cxxNamespace = header.cxxNamespace;
    if (result.id == 0) result.id = freshId(project_, header.path);
    matchByName();
    while (matchByContent()) continue;  // a node that holds one of those may match next
    for (std::size_t i = 0; i < wanted_.size(); ++i) addEnumerators(i);
    for (std::size_t i = 0; i < old_.nodes.size(); ++i) {
      const Node& node = old_.nodes[i];
      const auto same = matches_.find(i);
      result.nodes.push_back(same == matches_.end() ? buried(node)
                                                    : merged(wanted_[same->second], node));
    }
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (!matched_.contains(i)) result.nodes.push_back(created(wanted_[i]));
    }
    return result;
  }

 private:
  void match(std::size_t old, std::size_t now) {
    matches_[old] = now;
    matched_[now] = old;
    renames_.add(old_.nodes[old].name, wanted_[now].node.name);
  }

  /// Matches nodes of the header with those of the lock by C++ name, else by was(). A was() beside
  /// a name that the lock knows already tells of a rename that was done long ago.
  void matchByName() {
    std::set<std::string> living;
    for (const Node& node : old_.nodes) {
      if (!node.removed()) living.insert(identity(node));
    }
    std::map<std::string, std::size_t> names, formerNames;
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      const std::string name = identity(wanted_[i].node);
      names.emplace(name, i);
      if (!living.contains(name)) formerNames.emplace(formerIdentity(wanted_[i]), i);
    }
    for (std::size_t i = 0; i < old_.nodes.size(); ++i) {
      const std::string name = identity(old_.nodes[i]);
      if (const auto same = names.find(name); same != names.end()) {
        match(i, same->second);
      } else if (const auto was = formerNames.find(name);
                 was != formerNames.end() && !old_.nodes[i].removed()) {
        match(i, was->second);
      }
    }
  }

  /// Matches one composite by what it is made of, since it is named after that: a variant that got
  /// an alternative has another name and is the same thing, and so is a composite that holds it.
  /// Returns true if it found one.
  bool matchByContent() {
    for (std::size_t i = 0; i < old_.nodes.size(); ++i) {
      if (matches_.contains(i) || !isComposite(old_.nodes[i]) || old_.nodes[i].removed()) continue;
      for (std::size_t j = 0; j < wanted_.size(); ++j) {
        if (matched_.contains(j) || !isGrown(wanted_[j], old_.nodes[i])) continue;
        match(i, j);
        return true;
      }
    }
    return false;
  }

  bool isGrown(const WantedNode& wanted, const Node& locked) const {
    if (!isComposite(wanted.node) || wanted.node.isUnion != locked.isUnion) return false;
    if (!locked.isUnion && wanted.members.size() != locked.members.size()) return false;
    return std::all_of(locked.members.begin(), locked.members.end(), [&](const Member& member) {
      return std::any_of(wanted.members.begin(), wanted.members.end(), [&](const auto& one) {
        return one.member.name == member.name && one.member.type == renames_.apply(member.type);
      });
    });
  }

  /// Returns true if the node stands for no declaration.
  static bool isComposite(const Node& node) {
    return node.kind == Node::Kind::Struct && identity(node) == node.name;
  }

  Node created(const WantedNode& wanted) const {
    Node node = wanted.node;
    node.id = freshId(project_, identity(node));
    for (const WantedMember& member : wanted.members) append(node, withDefault(member.member));
    return node;
  }

  /// Notes which enumerator is the zero of the wire, and what those of the lock are called now.
  void addEnumerators(std::size_t now) {
    const WantedNode& wanted = wanted_[now];
    if (wanted.node.kind != Node::Kind::Enum || wanted.members.empty()) return;
    std::string& zero = zeros_[wanted.node.name];
    zero = wanted.members.front().member.name;
    const auto same = matched_.find(now);
    if (same == matched_.end()) return;
    const Node& locked = old_.nodes[same->second];
    for (const Member& member : locked.members) {
      const std::size_t i = find(wanted, locked, member);
      const std::string name = i == wanted.members.size() ? placeholder(member, wanted).name
                                                          : wanted.members[i].member.name;
      if (member.ordinal == 0) zero = name;
      enumerators_.add(wanted.node.name, member.name, name);
    }
  }

  /// Drops the default of a field if it is the zero of the wire, as far as this lock has its enum.
  Member withDefault(Member member) const {
    const auto zero = zeros_.find(member.type);
    if (zero != zeros_.end() && member.defaultValue == zero->second) member.defaultValue.clear();
    return member;
  }

  static void append(Node& node, Member member) {
    member.ordinal = static_cast<unsigned>(node.members.size());
    node.members.push_back(std::move(member));
  }

  /// Keeps what the header no longer declares, so that its id and ordinals are never given again.
  static Node buried(Node node) {
    if (!node.removed()) node.annotations["removed"] = quoted(node.name);
    return node;
  }

  Node merged(const WantedNode& wanted, const Node& locked) const {
    Node node = wanted.node;
    node.id = locked.id;
    const auto major = locked.annotations.find("major");
    if (major != locked.annotations.end()) node.annotations.insert(*major);
    std::vector<bool> used(wanted.members.size(), false);
    for (const Member& member : locked.members) {
      const std::size_t i = find(wanted, locked, member);
      if (i == wanted.members.size()) {
        append(node, placeholder(member, wanted));
      } else {
        used[i] = true;
        append(node, merged(wanted.members[i].member, member));
      }
    }
    for (std::size_t i = 0; i < wanted.members.size(); ++i) {
      if (!used[i]) append(node, withDefault(wanted.members[i].member));
    }
    return node;
  }

  /// Returns the index of the header's member that `locked` is, by its wire name, else by was();
  /// the number of all members if there is none.
  static std::size_t find(const WantedNode& wanted, const Node& node, const Member& locked) {
    const std::vector<WantedMember>& all = wanted.members;
    if (locked.removed()) return all.size();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].member.name == locked.name) return i;
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool named = all[i].was && (model::camelCase(*all[i].was) == locked.name ||
                                        quoted(*all[i].was) == valueOf(locked.annotations, "cxx"));
      if (named && !lives(node, all[i].member.name)) return i;
    }
    return all.size();
  }

  /// Tells if the lock has a live member of this name already; then a was() beside it tells of a
  /// rename that was done long ago.
  static bool lives(const Node& node, const std::string& name) {
    return std::any_of(node.members.begin(), node.members.end(), [&](const Member& member) {
      return !member.removed() && member.name == name;
    });
  }

  /// Returns what keeps the ordinal of a removed member. What the header declares has the first
  /// right to a name, because nothing refers to a placeholder by name.
  static Member placeholder(Member member, const WantedNode& wanted) {
    if (!member.removed()) {
      member.annotations["removed"] = quoted(member.name);
      member.name = "removed" + std::to_string(member.ordinal);
    }
    while (declares(wanted, member.name)) member.name += "Place";
    return member;
  }

  static bool declares(const WantedNode& wanted, const std::string& name) {
    return std::any_of(wanted.members.begin(), wanted.members.end(),
                       [&](const WantedMember& one) { return one.member.name == name; });
  }

  Member merged(const Member& wanted, const Member& locked) const {
    Member member = withDefault(wanted);
    if (means(locked, member))
      freezeDefault(member, enumerators_.apply(member.type, locked.defaultValue));
    if (member.isMethod) {
      member.parameters = merged(member.parameters, locked.parameters);
      member.results = merged(member.results, locked.results);
    }
    return member;
  }

  /// Tells if bytes of both mean the same.
  bool means(const Member& locked, const Member& now) const {
    return now.type == renames_.apply(locked.type) &&
           std::all_of(std::begin(kMeaningful), std::end(kMeaningful), [&](const char* name) {
             return valueOf(now.annotations, name) == valueOf(locked.annotations, name);
           });
  }

  /// Keeps the default that the lock has, because capnp stores values relative to it; if C++ has
  /// another since then, that is written beside it.
  void freezeDefault(Member& member, const std::string& locked) const {
    if (member.defaultValue == locked) return;
    // The enum may have been foreign so far, and the zero of the wire was spelled out.
    Member spelled = member;
    spelled.defaultValue = locked;
    if (member.defaultValue == withDefault(spelled).defaultValue) {
      member.defaultValue = locked;
      return;
    }
    // Only the lock of its own header knows which enumerator of a foreign enum is the zero.
    const bool isForeign = member.type.starts_with('/');
    if (!isForeign || !locked.empty()) {
      member.annotations["default"] =
          quoted(member.defaultValue.empty() ? "zero" : member.defaultValue);
    }
    member.defaultValue = locked;
  }

  /// Keeps the parameters in the lock's order, since their place is their ordinal; new ones follow.
  static std::vector<Member> merged(const std::vector<Member>& now,
                                    const std::vector<Member>& before) {
    std::vector<Member> result;
    const auto findIn = [](const std::vector<Member>& list, const std::string& name) {
      return std::find_if(list.begin(), list.end(),
                          [&](const Member& one) { return one.name == name; });
    };
    for (const Member& old : before) {
      const auto same = findIn(now, old.name);
      if (same != now.end()) result.push_back(*same);
    }
    for (const Member& one : now) {
      if (findIn(before, one.name) == before.end()) result.push_back(one);
    }
    return result;
  }

  const std::vector<WantedNode>& wanted_;
  const Lock& old_;
  const std::string& project_;
  std::map<std::size_t, std::size_t> matches_;  // from nodes of the lock to those of the header
  std::map<std::size_t, std::size_t> matched_;  // from nodes of the header to those of the lock
  Renames renames_;
  EnumeratorNames enumerators_;
  // Maps the name of each enum to its enumerator of ordinal 0, as it is called now.
  std::map<std::string, std::string> zeros_;
};

}  // namespace

Lock merge(const std::vector<WantedNode>& wanted, const model::Header& header, const Lock& old,
           const std::string& project) {
  return Merger(wanted, old, project).run(header);
}

}  // namespace suture::compiler::lock
