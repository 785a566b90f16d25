#include "compiler/lock/differences.h"

#include <algorithm>
#include <set>

#include "compiler/lock/major_versions.h"
#include "compiler/lock/schema/renames.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/lock/wanted.h"

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

bool isMeaningful(const std::string& name) {
  return std::find(std::begin(kMeaningful), std::end(kMeaningful), name) != std::end(kMeaningful);
}

class Comparison {
 public:
  std::vector<Difference> run(const Lock& old, const Lock& now) {
    if (old.cxxNamespace != now.cxxNamespace) {
      harmless("namespace " + now.cxxNamespace + " instead of " + old.cxxNamespace);
    }
    for (const Node& node : old.nodes) {
      if (const Node* const same = find(now, node)) renames_.add(node.name, same->name);
    }
    for (const Node& node : old.nodes) compare(node, find(now, node));
    for (const Node& node : now.nodes) {
      if (!find(old, node)) harmless(titleOf(node) + " is new");
    }
    return std::move(found_);
  }

 private:
  /// The same node in another lock: of the same name, else of the same C++ name, else of the same
  /// id, which outlives renames.
  static const Node* find(const Lock& lock, const Node& node) {
    const auto first = [&lock](const auto& isSame) -> const Node* {
      const auto found = std::find_if(lock.nodes.begin(), lock.nodes.end(), isSame);
      return found == lock.nodes.end() ? nullptr : &*found;
    };
    const Node* found = first([&](const Node& one) { return one.name == node.name; });
    if (!found) {
      found = first([&](const Node& one) { return identity(one) == identity(node); });
    }
    return found ? found : first([&](const Node& one) { return one.id == node.id; });
  }

  void broken(std::string text) { found_.push_back({Effect::Break, std::move(text)}); }
  void harmless(std::string text) { found_.push_back({Effect::None, std::move(text)}); }

  void compare(const Node& old, const Node* now) {
    const std::string title = titleOf(old);
    if (!now) return broken(title + " is gone without a trace");
    if (now->id != old.id) broken(title + " has another id");
    if (now->kind != old.kind) return broken(title + " became " + titleOf(*now));
    if (now->name != old.name) harmless(title + " is called " + now->name + " now");
    if (now->removed() && !old.removed()) {
      const bool contract = old.kind == Node::Kind::Interface;
      found_.push_back({contract ? Effect::Break : Effect::None, title + " was removed"});
    }
    if (majorOf(*now) != majorOf(old)) {
      broken(title + ": major " + std::to_string(majorOf(*now)) + " instead of " +
             std::to_string(majorOf(old)) + "; peers of the two refuse each other");
    }
    const std::string version = valueOf(now->annotations, "version");
    const std::string before = valueOf(old.annotations, "version");
    if (version != before) {
      broken(title + ": version " + version + " instead of " + before +
             "; peers of the two refuse each other");
    }
    if (now->extends.size() != old.extends.size()) {
      broken(title + " has another base; peers of before know it without");
    }
    compareMembers(old, *now, title);
  }

  void compareMembers(const Node& old, const Node& now, const std::string& title) {
    const bool chosen = old.kind == Node::Kind::Enum || old.isUnion;
    for (std::size_t i = 0; i < old.members.size(); ++i) {
      const std::string subject = "'" + old.members[i].name + "' of " + title;
      if (i >= now.members.size()) {
        broken(subject + " is gone without a trace");
      } else if (now.members[i].removed() && !old.members[i].removed()) {
        found_.push_back(removal(old.members[i], subject, chosen));
      } else {
        compare(old.members[i], now.members[i], subject);
      }
    }
    for (std::size_t i = old.members.size(); i < now.members.size(); ++i) {
      found_.push_back({chosen ? Effect::Refusals : Effect::None,
                        "'" + now.members[i].name + "' of " + title + " is new" +
                            (chosen ? "; peers of before refuse a message that has it" : "")});
    }
  }

  /// `chosen`: it is one of several of which a message has one.
  static Difference removal(const Member& old, const std::string& subject, bool chosen) {
    const std::string text = subject + " was removed; ";
    if (old.isMethod) return {Effect::Break, text + "who calls it is told so"};
    if (chosen) return {Effect::Refusals, text + "peers of now refuse a message that has it"};
    return {Effect::None, text + "its place is kept"};
  }

  void compare(const Member& old, const Member& now, const std::string& subject) {
    if (now.name != old.name) harmless(subject + " is called '" + now.name + "' now");
    compareMeaning(old, now, subject);
    if (now.defaultValue != old.defaultValue) {
      broken(subject + ": default " + shown(now.defaultValue, "zero") + " instead of " +
             shown(old.defaultValue, "zero"));
    }
    compareLists(old.parameters, now.parameters, "parameter", subject);
    compareLists(old.results, now.results, "result", subject);
  }

  static std::string shown(const std::string& value, const char* nothing) {
    return value.empty() ? nothing : value;
  }

  void compareMeaning(const Member& old, const Member& now, const std::string& subject) {
    if (old.isMethod != now.isMethod || renames_.apply(old.type) != now.type) {
      broken(subject + ": type " + now.type + " instead of " + old.type);
    }
    std::set<std::string> names;
    for (const auto& [name, value] : old.annotations) names.insert(name);
    for (const auto& [name, value] : now.annotations) names.insert(name);
    for (const std::string& name : names) {
      const std::string before = valueOf(old.annotations, name);
      const std::string after = valueOf(now.annotations, name);
      if (before == after) continue;
      found_.push_back({effectOf(name), subject + ": " + name + " " + shown(after, "given") +
                                            " instead of " + shown(before, "given") +
                                            consequenceOf(name)});
    }
  }

  static Effect effectOf(const std::string& annotation) {
    if (isMeaningful(annotation)) return Effect::Break;
    return consequenceOf(annotation).empty() ? Effect::None : Effect::Refusals;
  }

  static std::string consequenceOf(const std::string& annotation) {
    if (annotation == "range") return "; each side refuses what lies outside its own";
    if (annotation == "capacity") return "; each side refuses what exceeds its own";
    return "";
  }

  void compareLists(const std::vector<Member>& old, const std::vector<Member>& now,
                    const std::string& what, const std::string& subject) {
    for (std::size_t i = 0; i < old.size(); ++i) {
      const std::string one = what + " '" + old[i].name + "' of " + subject;
      if (i >= now.size() || now[i].name != old[i].name) {
        broken(one + " is gone");
      } else {
        compareMeaning(old[i], now[i], one);
      }
    }
    for (std::size_t i = old.size(); i < now.size(); ++i) {
      harmless(what + " '" + now[i].name + "' of " + subject + " is new");
    }
  }

  std::vector<Difference> found_;
  Renames renames_;
};

}  // namespace

std::vector<Difference> differences(const Lock& old, const Lock& now) {
  return Comparison().run(old, now);
}

}  // namespace suture::compiler::lock
