#include "compiler/lock/merge.h"

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/lock/schema/renames.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/lock/schema/writer.h"
#include "compiler/model/naming.h"

namespace suture::compiler::lock {
namespace {

using model::Diagnostic;

constexpr char kAcceptAdvice[] =
    "; where all peers are replaced together, update the lock with --accept-break";

class Merger {
 public:
  Merger(const Lock& old, const Options& options) : old_(old), options_(options) {}

  Merge run(const std::vector<WantedNode>& wanted, const model::Header& header) {
    merge_.lock = old_;
    merge_.lock.nodes.clear();
    merge_.lock.header = header.path;
    merge_.lock.cxxNamespace = header.cxxNamespace;
    if (merge_.lock.id == 0) merge_.lock.id = freshId(options_.project, header.path);
    matchByName(wanted);
    while (matchByContent(wanted)) continue;  // what holds one of those may follow
    for (std::size_t i = 0; i < old_.nodes.size(); ++i) {
      const Node& node = old_.nodes[i];
      const auto same = matches_.find(i);
      merge_.lock.nodes.push_back(same == matches_.end() ? buried(node, header)
                                                         : merged(wanted[same->second], node));
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (!isMatched(i)) merge_.lock.nodes.push_back(created(wanted[i]));
    }
    return std::move(merge_);
  }

 private:
  void match(std::size_t old, std::size_t now, const std::string& name) {
    matches_[old] = now;
    renames_.add(old_.nodes[old].name, name);
  }

  bool isMatched(std::size_t now) const {
    return std::any_of(matches_.begin(), matches_.end(),
                       [now](const auto& match) { return match.second == now; });
  }

  void matchByName(const std::vector<WantedNode>& wanted) {
    for (std::size_t i = 0; i < old_.nodes.size(); ++i) {
      const auto same = find(wanted, old_.nodes[i]);
      if (same == wanted.end()) continue;
      match(i, static_cast<std::size_t>(same - wanted.begin()), same->node.name);
    }
  }

  /// A composite is named after what it is made of: a variant that got an alternative has another
  /// name and is the same thing, and so is what holds it. True if there was one.
  bool matchByContent(const std::vector<WantedNode>& wanted) {
    for (std::size_t i = 0; i < old_.nodes.size(); ++i) {
      if (matches_.contains(i)) continue;
      for (std::size_t j = 0; j < wanted.size(); ++j) {
        if (isMatched(j) || !isGrown(wanted[j], old_.nodes[i])) continue;
        match(i, j, wanted[j].node.name);
        return true;
      }
    }
    return false;
  }

  bool isGrown(const WantedNode& wanted, const Node& locked) const {
    const bool composites = isComposite(wanted.node) && isComposite(locked) && !locked.removed();
    if (!composites || wanted.node.isUnion != locked.isUnion) return false;
    if (!locked.isUnion && wanted.members.size() != locked.members.size()) return false;
    return std::all_of(locked.members.begin(), locked.members.end(), [&](const Member& member) {
      return std::any_of(wanted.members.begin(), wanted.members.end(), [&](const auto& one) {
        return one.member.name == member.name && one.member.type == renames_.apply(member.type);
      });
    });
  }

  /// True if the node stands for no declaration.
  static bool isComposite(const Node& node) {
    return node.kind == Node::Kind::Struct && identity(node) == node.name;
  }

  /// The node of the header that `locked` is: by its C++ name, else by was().
  std::vector<WantedNode>::const_iterator find(const std::vector<WantedNode>& wanted,
                                               const Node& locked) const {
    const std::string name = identity(locked);
    const auto same = std::find_if(wanted.begin(), wanted.end(), [&](const WantedNode& one) {
      return identity(one.node) == name;
    });
    if (same != wanted.end() || locked.removed()) return same;
    return std::find_if(wanted.begin(), wanted.end(), [&](const WantedNode& one) {
      return formerIdentity(one) == name && !lives(identity(one.node));
    });
  }

  /// Has the lock a node of this name already? Then a was() beside it is an old, done rename.
  bool lives(const std::string& name) const {
    return std::any_of(old_.nodes.begin(), old_.nodes.end(),
                       [&](const Node& node) { return !node.removed() && identity(node) == name; });
  }

  std::string where(unsigned line) const {
    return options_.folder + "/" + old_.path + (line > 0 ? ":" + std::to_string(line) : "");
  }

  model::Note lockNote(unsigned line, const std::string& text) const {
    return {{0, options_.folder + "/" + old_.path, line}, "the lock has: " + text};
  }

  void pending(const model::Source& source, const char* slug, std::string message,
               std::vector<model::Note> notes = {}) {
    Diagnostic one{source, slug, std::move(message), "run: " + options_.command, std::move(notes)};
    merge_.pending.push_back(std::move(one));
  }

  void broken(const model::Source& source, std::string message, const std::string& help,
              model::Note note) {
    merge_.broken.insert(node_);
    merge_.breaks.push_back(
        {source, "lock-break", std::move(message), help + kAcceptAdvice, {std::move(note)}});
  }

  void broken(const WantedMember& wanted, const Member& locked, const std::string& message,
              const std::string& help) {
    broken(wanted.source, wanted.title + ": " + message, help,
           lockNote(locked.line, describe(locked)));
  }

  void broken(const WantedNode& wanted, const Node& locked, const std::string& message,
              const std::string& help) {
    broken(wanted.source, wanted.title + message, help, lockNote(locked.line, locked.name));
  }

  Node created(const WantedNode& wanted) {
    Node node = wanted.node;
    node.id = freshId(options_.project, identity(node));
    if (!old_.text.empty()) {
      pending(wanted.source, "lock-new", wanted.title + " is not in the lock " + where(0));
    }
    for (const WantedMember& member : wanted.members) append(node, member.member);
    return node;
  }

  static void append(Node& node, Member member) {
    member.ordinal = static_cast<unsigned>(node.members.size());
    node.members.push_back(std::move(member));
  }

  /// What the header no longer declares stays, so that its id and ordinals are never given again.
  Node buried(Node node, const model::Header& header) {
    if (node.removed()) return node;
    const model::Source source{0, header.path, 0};
    const std::string message = node.name + " is no longer declared in " + header.path;
    if (node.kind == Node::Kind::Interface) {
      node_ = node.name;
      broken(source, message, "old peers use it: put it back, or say was() on what replaces it",
             lockNote(node.line, node.name));
    } else {
      pending(source, "lock-removed", message, {lockNote(node.line, node.name)});
    }
    node.annotations["removed"] = quoted(node.name);
    return node;
  }

  Node merged(const WantedNode& wanted, const Node& locked) {
    Node node = wanted.node;
    node.id = locked.id;
    node_ = node.name;
    const auto major = locked.annotations.find("major");
    if (major != locked.annotations.end()) node.annotations.insert(*major);
    if (node.kind != locked.kind) {
      broken(wanted, locked, " was something else before", "give the new thing a name of its own");
    }
    compareBases(wanted, locked);
    compareVersions(wanted, locked);
    if (node.name != locked.name) {
      pending(wanted.source, "lock-renamed",
              wanted.title + " has a new wire name, '" + node.name + "'",
              {lockNote(locked.line, locked.name)});
    }
    std::vector<bool> used(wanted.members.size(), false);
    for (const Member& member : locked.members) {
      const std::size_t i = find(wanted, locked, member);
      if (i == wanted.members.size()) {
        append(node, placeholder(wanted, member));
      } else {
        used[i] = true;
        append(node, merged(wanted.members[i], member));
      }
    }
    for (std::size_t i = 0; i < wanted.members.size(); ++i) {
      if (used[i]) continue;
      pending(wanted.members[i].source, "lock-new",
              wanted.members[i].title + " is not in the lock " + where(locked.line));
      append(node, wanted.members[i].member);
    }
    return node;
  }

  /// A base is part of what the two ends know of each other.
  void compareBases(const WantedNode& wanted, const Node& locked) {
    for (const std::string& base : locked.extends) {
      const auto& now = wanted.node.extends;
      if (std::find(now.begin(), now.end(), base) != now.end()) continue;
      broken(wanted, locked, " no longer derives from " + base,
             "put the base back: its commands are part of the contract");
    }
    if (wanted.node.extends.size() > locked.extends.size()) {
      broken(wanted, locked, " has a base that it did not have: peers of before know it without",
             "declare the commands of the base in the contract itself");
    }
  }

  /// Peers of two versions refuse each other.
  void compareVersions(const WantedNode& wanted, const Node& locked) {
    const std::string now = valueOf(wanted.node.annotations, "version");
    const std::string before = valueOf(locked.annotations, "version");
    if (now == before) return;
    broken(wanted, locked, ": version " + now + " instead of " + before,
           "peers of two versions refuse each other: keep the version while old peers are in use");
  }

  /// The member of the header that `locked` is: by its wire name, else by was().
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

  /// Has the lock a live member of this name already? Then a was() beside it is an old, done
  /// rename.
  static bool lives(const Node& node, const std::string& name) {
    return std::any_of(node.members.begin(), node.members.end(), [&](const Member& member) {
      return !member.removed() && member.name == name;
    });
  }

  Member placeholder(const WantedNode& wanted, Member member) {
    if (member.removed()) return member;
    const std::string name = member.name;
    const std::string message = wanted.title + " no longer has '" + name + "'";
    const std::string help = "say was(\"" + name + "\") on what replaces it, or ";
    const model::Note note = lockNote(member.line, describe(member));
    if (member.isMethod) {
      broken(wanted.source, message, help + "keep it and say deprecated(): old peers use it", note);
    } else {
      merge_.pending.push_back({wanted.source,
                                "lock-removed",
                                message,
                                help + "keep its place by running: " + options_.command,
                                {note}});
    }
    member.annotations["removed"] = quoted(name);
    member.name = "removed" + std::to_string(member.ordinal);
    return member;
  }

  Member merged(const WantedMember& wanted, const Member& locked) {
    Member member = wanted.member;
    if (member.name != locked.name) {
      pending(
          wanted.source, "lock-renamed",
          wanted.title + " was '" + locked.name + "' so far; the lock has to learn its new name",
          {lockNote(locked.line, describe(locked))});
    }
    const std::size_t breaks = merge_.breaks.size();
    compare(wanted, locked, member, locked);
    // Freeze the default while it means the same: capnp stores values relative to it.
    if (merge_.breaks.size() == breaks) member.defaultValue = locked.defaultValue;
    if (member.isMethod) mergeSignature(wanted, locked, member);
    return member;
  }

  /// `now` and `before` are the member itself, or one of its parameters or results.
  void compare(const WantedMember& wanted, const Member& locked, const Member& now,
               const Member& before) {
    const std::string what = &before == &locked ? "" : "'" + before.name + "': ";
    if (now.type != renames_.apply(before.type) || now.isMethod != before.isMethod) {
      broken(wanted, locked, what + "type " + now.type + " instead of " + before.type,
             "a type never changes: add '" + before.name +
                 "' anew under another name and remove the old one");
    }
    for (const char* const name : kMeaningful) {
      const std::string newValue = valueOf(now.annotations, name);
      const std::string oldValue = valueOf(before.annotations, name);
      if (newValue == oldValue) continue;
      broken(wanted, locked, what + name + " " + newValue + " instead of " + oldValue,
             std::string("a change of ") + name +
                 " changes what the bytes mean: put it back, or "
                 "add the new form under another name");
    }
    compareLimits(wanted, locked, what, now, before);
  }

  /// The bytes mean the same, but one of two peers refuses what the other may send.
  void compareLimits(const WantedMember& wanted, const Member& locked, const std::string& what,
                     const Member& now, const Member& before) {
    for (const char* const name : {"range", "capacity"}) {
      const std::string newLimit = valueOf(now.annotations, name);
      const std::string oldLimit = valueOf(before.annotations, name);
      if (newLimit == oldLimit) continue;
      pending(wanted.source, "lock-range",
              wanted.title + ": " + what + name + " " + newLimit + " instead of " + oldLimit +
                  "; a receiver refuses what lies outside its own",
              {lockNote(locked.line, describe(locked))});
    }
  }

  void mergeSignature(const WantedMember& wanted, const Member& locked, Member& member) {
    member.parameters = mergeList(wanted, locked, wanted.member.parameters, locked.parameters);
    member.results = mergeList(wanted, locked, wanted.member.results, locked.results);
  }

  /// Parameters keep the lock's order, since their place is their ordinal; new ones follow.
  std::vector<Member> mergeList(const WantedMember& wanted, const Member& locked,
                                const std::vector<Member>& now, const std::vector<Member>& before) {
    std::vector<Member> result;
    const auto findIn = [](const std::vector<Member>& list, const std::string& name) {
      return std::find_if(list.begin(), list.end(),
                          [&](const Member& one) { return one.name == name; });
    };
    for (const Member& old : before) {
      const auto same = findIn(now, old.name);
      if (same == now.end()) {
        broken(wanted, locked, "'" + old.name + "' is gone from its signature",
               "a signature only grows: put it back under the same name");
        continue;
      }
      compare(wanted, locked, *same, old);
      result.push_back(*same);
    }
    for (const Member& one : now) {
      if (findIn(before, one.name) != before.end()) continue;
      pending(
          wanted.source, "lock-new",
          wanted.title + ": parameter '" + one.name + "' is not in the lock " + where(locked.line));
      result.push_back(one);
    }
    return result;
  }

  const Lock& old_;
  const Options& options_;
  std::map<std::size_t, std::size_t> matches_;  // nodes of the lock to those of the header
  Renames renames_;
  std::string node_;  // being merged
  Merge merge_;
};

}  // namespace

Merge merge(const std::vector<WantedNode>& wanted, const model::Header& header, const Lock& old,
            const Options& options) {
  return Merger(old, options).run(wanted, header);
}

}  // namespace suture::compiler::lock
