#include "compiler/lock/wire_names.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace suture::compiler::lock {

using model::Diagnostics;

namespace {

/// Says was() if it would match the two, which it does with what this edit removes.
std::string adviceOnRemoved(const Node& removed, const WantedNode& taker, const Lock& old) {
  const auto name = removed.annotations.find("cxx");
  const bool fits =
      !taker.was && removed.kind == taker.node.kind && name != removed.annotations.end() &&
      std::any_of(old.nodes.begin(), old.nodes.end(),
                  [&](const Node& node) { return node.id == removed.id && !node.removed(); });
  const std::string other = "give it another: name(\"...\")";
  return fits ? "if it is the same under another name in C++, say was(" + name->second +
                    "); else " + other
              : other;
}

/// Reports a composite that the locks of two headers give the same name.
model::Diagnostic sameComposite(const WantedNode& node, const std::string& other) {
  return {node.source,
          "wire-name-clash",
          node.title + " has the wire name '" + node.node.name + "' here and in " + other,
          "rename one of the two headers: such names begin with its path",
          {{{0, other, 0}, "this header has it too"}}};
}

}  // namespace

WireNames::WireNames(const model::Model& model, const model::Lookup& lookup) {
  for (const bool own : {false, true}) {  // a clash with a foreign header is reported at ours
    for (const model::Header& header : model.headers) {
      if (header.own == own) add(header, lookup);
    }
  }
}

void WireNames::add(const model::Header& header, const model::Lookup& lookup) {
  for (WantedNode& node : wanted(header, lookup)) {
    const std::string name = header.cxxNamespace + "::" + node.node.name;
    owners_.emplace(name, Owner{header.path, std::move(node)});
  }
}

Diagnostics WireNames::clashes(const model::Header& header,
                               const std::vector<WantedNode>& nodes) const {
  Diagnostics result;
  for (const WantedNode& node : nodes) {
    const auto& [path, owner] = owners_.at(header.cxxNamespace + "::" + node.node.name);
    if (path == header.path && identity(owner.node) == identity(node.node)) continue;
    if (identity(owner.node) == identity(node.node)) {
      result.push_back(sameComposite(node, path));
      continue;
    }
    result.push_back(
        {node.source,
         "wire-name-clash",
         node.title + " has the wire name '" + node.node.name + "' as " + owner.title + " has",
         "give one of them another: name(\"...\")",
         {{owner.source, owner.title + " is declared here"}}});
  }
  return result;
}

Diagnostics WireNames::clashesWithRemoved(const model::Header& header, const Lock& old,
                                          const Lock& merged) const {
  Diagnostics result;
  for (const Node& node : merged.nodes) {
    const auto taken = owners_.find(header.cxxNamespace + "::" + node.name);
    if (!node.removed() || taken == owners_.end()) continue;
    const WantedNode& owner = taken->second.node;
    result.push_back({owner.source,
                      "wire-name-clash",
                      owner.title + " has the wire name of a removed " + node.name,
                      adviceOnRemoved(node, owner, old),
                      {}});
  }
  return result;
}

Diagnostics clashesOfComposites(const model::Header& header, const model::Lookup& lookup) {
  Diagnostics result;
  for (const auto& [first, second] : compositeClashes(header, lookup)) {
    result.push_back(
        {second.source,
         "wire-name-clash",
         second.title + " has the wire name '" + second.node.name + "' as " + first.title + " has",
         "make one of them a struct, which has a name of its own",
         {{first.source, "the first is here"}}});
  }
  return result;
}

Diagnostics clashesWithOwn(const std::vector<WantedNode>& wanted) {
  Diagnostics result;
  const auto report = [&result](const WantedMember& member, const std::string& name) {
    result.push_back({member.source,
                      "wire-name-clash",
                      member.title + ": '" + name + "' is what suturec itself calls something here",
                      "give it another name on the wire: name(\"...\")",
                      {}});
  };
  for (const WantedNode& node : wanted) {
    const auto isOwn = [&](const WantedMember& one) { return one.title == node.title; };
    std::set<std::string_view> own;
    for (const WantedMember& member : node.members) {
      if (isOwn(member)) own.insert(member.member.name);
    }
    for (const WantedMember& member : node.members) {
      if (!isOwn(member) && own.contains(member.member.name)) report(member, member.member.name);
      const auto& parameters = member.member.parameters;
      const auto sents = std::count_if(parameters.begin(), parameters.end(),
                                       [](const Member& one) { return one.name == "sent"; });
      if (sents > 1) report(member, "sent");
    }
  }
  return result;
}

}  // namespace suture::compiler::lock
