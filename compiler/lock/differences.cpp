#include "compiler/lock/differences.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "compiler/lock/major_versions.h"
#include "compiler/lock/moves/possible_renames.h"
#include "compiler/lock/moves/same_nodes.h"
#include "compiler/lock/schema/renames.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/lock/schema/wire_type.h"

namespace suture::compiler::lock {
namespace {

const char* kindOf(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::Struct: return "struct ";
    case Node::Kind::Enum: return "enum ";
    case Node::Kind::Interface: return "interface ";
  }
  return "";
}

std::string titleOf(const Node& node) { return kindOf(node.kind) + node.name; }

std::string titleOf(const Node& node, const Member& member) {
  return "'" + member.name + "' of " + titleOf(node);
}

bool isMeaningful(const std::string& name) {
  return std::find(std::begin(kMeaningful), std::end(kMeaningful), name) != std::end(kMeaningful);
}

class Comparison {
 public:
  std::vector<Difference> run(const Lock& old, const Lock& now) {
    if (!old.text.empty() && old.cxxNamespace != now.cxxNamespace) {
      add(Change::Policy, Effect::None, {}, {}, "the schema",
          " is in namespace " + now.cxxNamespace + " instead of " + old.cxxNamespace);
    }
    addMoves(old, now);
    const SameNodes nodes(now);
    std::set<const Node*> known;
    for (const Node& node : old.nodes) {
      const Node* const same = nodes.find(node);
      if (same == nullptr) continue;
      known.insert(same);
      renames_.add(node.name, same->name);
      if (node.kind == Node::Kind::Enum) addEnumerators(node, *same);
    }
    for (const Node& node : old.nodes) {
      if (!left_.contains(node.id)) compare(node, nodes.find(node));
    }
    for (const Node& node : now.nodes) {
      if (!old.text.empty() && !known.contains(&node)) {
        add(Change::New, Effect::None, {}, {&node}, titleOf(node), " is new").hint =
            hintOfRename(earlierNameOf(old, nodes, node, renames_));
      }
    }
    return std::move(found_);
  }

 private:
  Difference& add(Change change, Effect effect, LockPlace before, LockPlace now,
                  std::string subject, std::string detail) {
    found_.push_back(
        {change, effect, before, now, "", "", std::move(subject), std::move(detail), ""});
    return found_.back();
  }

  /// Adds what has left the file, and what the file names where it is now.
  void addMoves(const Lock& old, const Lock& now) {
    for (const Departure& one : now.departures) {
      const auto& before = old.departures;
      const bool isHere = std::any_of(now.nodes.begin(), now.nodes.end(),
                                      [&](const Node& node) { return node.id == one.id; });
      if (isHere || std::find(before.begin(), before.end(), one) != before.end()) continue;
      left_.insert(one.id);
      renames_.add(one.name, one.to.text());
      add(Change::Moved, Effect::None, {}, {}, one.name, " moved to /" + one.to.path);
    }
    for (const auto& [before, after] : old.followed) {
      add(Change::Moved, Effect::None, {}, {}, "the schema",
          " names " + after + " instead of " + before);
    }
  }

  void addEnumerators(const Node& old, const Node& now) {
    for (std::size_t i = 0; i < std::min(old.members.size(), now.members.size()); ++i) {
      enumerators_.add(now.name, old.members[i].name, now.members[i].name);
    }
  }

  void compare(const Node& old, const Node* now) {
    const auto say = [&](Change change, Effect effect, std::string detail) {
      add(change, effect, {&old}, {now}, titleOf(old), std::move(detail));
    };
    if (now == nullptr) return say(Change::Identity, Effect::Break, " is gone without a trace");
    if (now->id != old.id) say(Change::Identity, Effect::Break, " has another id");
    if (now->kind != old.kind) {
      return say(Change::Kind, Effect::Break, " became " + titleOf(*now));
    }
    if (old.cameFrom) {
      say(Change::Moved, Effect::None, " was " + old.cameFrom->text() + " before");
    }
    if (now->name != old.name) {
      say(Change::Renamed, Effect::None, " is called " + now->name + " now");
    }
    if (now->removed() && !old.removed()) {
      const bool contract = old.kind == Node::Kind::Interface;
      say(Change::Removed, contract ? Effect::Break : Effect::None, " was removed");
    }
    if (majorOf(*now) != majorOf(old)) {
      say(Change::Identity, Effect::Break,
          ": major " + std::to_string(majorOf(*now)) + " instead of " +
              std::to_string(majorOf(old)) + "; peers of the two refuse each other");
    }
    compareAnnotations(old, *now);
    if (!hasSameBases(old, *now)) {
      say(Change::Base, Effect::Break, " has another base; peers of before know it without");
    }
    compareMembers(old, *now);
  }

  bool hasSameBases(const Node& old, const Node& now) const {
    return std::equal(old.extends.begin(), old.extends.end(), now.extends.begin(),
                      now.extends.end(), [this](const std::string& before, const std::string& one) {
                        return renames_.apply(before) == one;
                      });
  }

  void compareAnnotations(const Node& old, const Node& now) {
    for (const std::string& name : namesOf(old.annotations, now.annotations)) {
      if (name == "removed" || name == "major") continue;
      const bool version = name == "version";
      const std::string change = changeOf(name, old.annotations, now.annotations);
      if (change.empty()) continue;
      add(version ? Change::Version : Change::Policy, version ? Effect::Break : Effect::None,
          {&old}, {&now}, titleOf(old),
          change + (version ? "; peers of the two refuse each other" : ""))
          .what = name;
    }
  }

  void compareMembers(const Node& old, const Node& now) {
    const bool chosen = old.kind == Node::Kind::Enum || old.isUnion;
    for (std::size_t i = 0; i < old.members.size(); ++i) {
      const Member& before = old.members[i];
      if (i >= now.members.size()) {
        add(Change::Identity, Effect::Break, {&old, &before}, {&now}, titleOf(old, before),
            " is gone without a trace");
      } else if (now.members[i].removed() && !before.removed()) {
        addRemoval({&old, &before}, {&now, &now.members[i]}, chosen);
      } else {
        compare({&old, &before}, {&now, &now.members[i]});
      }
    }
    for (std::size_t i = old.members.size(); i < now.members.size(); ++i) {
      add(Change::New, chosen ? Effect::Refusals : Effect::None, {&old}, {&now, &now.members[i]},
          titleOf(now, now.members[i]),
          std::string(" is new") + (chosen ? "; peers of before refuse a message that has it" : ""))
          .hint = hintOfRename(earlierNameOf(old, now, now.members[i], renames_));
    }
  }

  /// Adds that a member was removed. `chosen` says that a message has only one of its node's
  /// members.
  void addRemoval(LockPlace before, LockPlace now, bool chosen) {
    const std::string subject = titleOf(*before.node, *before.member);
    if (before.member->isMethod) {
      add(Change::Removed, Effect::Break, before, now, subject,
          " was removed; who calls it is told so");
    } else if (chosen) {
      add(Change::Removed, Effect::Refusals, before, now, subject,
          " was removed; peers of now refuse a message that has it");
    } else {
      add(Change::Removed, Effect::None, before, now, subject, " was removed; its place is kept");
    }
  }

  void compare(LockPlace before, LockPlace now) {
    const Member &old = *before.member, &member = *now.member;
    const std::string subject = titleOf(*before.node, old);
    // A placeholder only makes room for a new member, which is told of.
    if (member.name != old.name && !member.removed()) {
      add(Change::Renamed, Effect::None, before, now, subject,
          " is called '" + member.name + "' now");
    }
    const bool same = compareMeaning(before, now, old, member, subject, "");
    if (same && member.defaultValue != enumerators_.apply(member.type, old.defaultValue)) {
      add(Change::Identity, Effect::Break, before, now, subject,
          ": default " + shown(member.defaultValue, "zero") + " instead of " +
              shown(old.defaultValue, "zero"));
    }
    compareLists(before, now, old.parameters, member.parameters, "parameter", subject);
    compareLists(before, now, old.results, member.results, "result", subject);
  }

  static std::string shown(const std::string& value, const char* nothing) {
    return value.empty() ? nothing : value;
  }

  static std::set<std::string> namesOf(const Annotations& old, const Annotations& now) {
    std::set<std::string> names;
    for (const auto& [name, value] : old) names.insert(name);
    for (const auto& [name, value] : now) names.insert(name);
    return names;
  }

  /// Returns ": queue 8 instead of 4", or "" if it is the same.
  static std::string changeOf(const std::string& name, const Annotations& old,
                              const Annotations& now) {
    const std::string before = valueOf(old, name), after = valueOf(now, name);
    if (before == after) return "";
    const std::string title = name == "cxx" ? "name in C++" : name;
    return ": " + title + " " + shown(after, "given") + " instead of " + shown(before, "given");
  }

  /// Compares what bytes mean. `old` and `now` are the member itself, or a parameter or result of
  /// it, which `part` names. Returns false if bytes of the two mean different things.
  bool compareMeaning(LockPlace before, LockPlace after, const Member& old, const Member& now,
                      const std::string& subject, const std::string& part) {
    bool same = true;
    const auto say = [&](Change change, Effect effect, std::string detail, std::string what) {
      Difference& one = add(change, effect, before, after, subject, std::move(detail));
      one.part = part;
      one.what = std::move(what);
      if (effect == Effect::Break) same = false;
    };
    const bool sameType = renames_.apply(old.type) == now.type || hasForgotten(after, now.type) ||
                          isRemembered(before, old.type);
    if (old.isMethod != now.isMethod || !sameType) {
      say(Change::Type, Effect::Break, ": type " + now.type + " instead of " + old.type, "");
    }
    for (const std::string& name : namesOf(old.annotations, now.annotations)) {
      const std::string change = changeOf(name, old.annotations, now.annotations);
      if (change.empty()) continue;
      if (isMeaningful(name)) {
        say(Change::Meaning, Effect::Break, change, name);
      } else if (name == "default") {
        say(Change::Default, Effect::None, defaultChange(old, now), name);
      } else {
        const std::string consequence = consequenceOf(name, *after.node);
        const bool limit = !consequence.empty();
        say(limit ? Change::Limit : Change::Policy, limit ? Effect::Refusals : Effect::None,
            change + consequence, name);
      }
    }
    return same;
  }

  /// Tells if a placeholder no longer says which type of another file it named.
  static bool hasForgotten(const LockPlace& place, const std::string& type) {
    const bool isPlaceholder =
        place.node->removed() || (place.member != nullptr && place.member->removed());
    return isPlaceholder && (type == kForgotten || type == kForgottenEnum);
  }

  /// Tells if a composite that was removed is there again: its name says what it is made of.
  static bool isRemembered(const LockPlace& place, const std::string& type) {
    return (type == kForgotten || type == kForgottenEnum) && place.node->removed() &&
           identity(*place.node) == place.node->name;
  }

  /// Tells how the default changed in C++. The annotation is there if C++ has another default than
  /// the schema, which keeps its first.
  static std::string defaultChange(const Member& old, const Member& now) {
    const auto inCpp = [](const Member& one) {
      const auto own = one.annotations.find("default");
      return own == one.annotations.end() ? shown(one.defaultValue, "zero") : unquoted(own->second);
    };
    return ": default " + inCpp(now) + " instead of " + inCpp(old) +
           "; where a message does not have it, it still is " + shown(now.defaultValue, "zero");
  }

  static bool hasFallback(const Node& declaration) {
    return std::any_of(
        declaration.members.begin(), declaration.members.end(),
        [](const Member& one) { return !one.removed() && one.annotations.contains("fallback"); });
  }

  static std::string consequenceOf(const std::string& annotation, const Node& now) {
    if (annotation == "range") return "; each side refuses what lies outside its own";
    if (annotation == "capacity") return "; each side refuses what exceeds its own";
    if (annotation == "distinct") return "; a set refuses what is in it twice";
    if (annotation == "fallback" && !hasFallback(now)) {
      return "; peers of now refuse an enumerator that they do not know";
    }
    return "";
  }

  void compareLists(LockPlace before, LockPlace after, const std::vector<Member>& old,
                    const std::vector<Member>& now, const std::string& what,
                    const std::string& subject) {
    const auto title = [&](const Member& one) {
      return what + " '" + one.name + "' of " + subject;
    };
    const auto placeIn = [](const std::vector<Member>& list, const Member& one) {
      const auto same = [&](const Member& other) { return other.name == one.name; };
      return static_cast<std::size_t>(std::find_if(list.begin(), list.end(), same) - list.begin());
    };
    const auto broken = [&](const Member& one, const char* detail) {
      add(Change::Parameter, Effect::Break, before, after, title(one), detail).part =
          "'" + one.name + "'";
    };
    std::size_t gone = 0;  // all that follow have moved up by it, which is told once
    for (std::size_t i = 0; i < old.size(); ++i) {
      const std::size_t place = placeIn(now, old[i]);
      if (place == now.size()) {
        broken(old[i], " is gone");
        ++gone;
        continue;
      }
      if (place + gone != i) broken(old[i], " has another place");
      compareMeaning(before, after, old[i], now[place], title(old[i]), "'" + old[i].name + "'");
    }
    for (const Member& one : now) {
      if (placeIn(old, one) < old.size()) continue;
      add(Change::New, Effect::None, before, after, title(one), " is new").part =
          "'" + one.name + "'";
    }
  }

  std::vector<Difference> found_;
  std::set<std::uint64_t> left_;  // ids of nodes that another file has now
  Renames renames_;
  EnumeratorNames enumerators_;
};

}  // namespace

std::string Difference::line() const {
  switch (effect) {
    case Effect::None: return "fine:    " + text();
    case Effect::Refusals: return "refuses: " + text();
    case Effect::Break: return "breaks:  " + text();
  }
  return text();
}

std::vector<Difference> differences(const Lock& old, const Lock& now) {
  return Comparison().run(old, now);
}

}  // namespace suture::compiler::lock
