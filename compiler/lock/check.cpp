#include <algorithm>
#include <map>
#include <utility>

#include "compiler/lock/lock.h"
#include "compiler/lock/merge.h"
#include "compiler/lock/wanted.h"
#include "compiler/lock/writer.h"

namespace suture::compiler::lock {
namespace {

using model::Diagnostics;

Lock lockOf(const model::Header& header, const Locks& locks) {
  Lock empty;
  empty.path = lockPath(header.path);
  const auto found = locks.files.find(empty.path);
  return found == locks.files.end() ? empty : found->second;
}

void append(Diagnostics& all, Diagnostics more) {
  for (model::Diagnostic& one : more) all.push_back(std::move(one));
}

/// Calls visit(header, wanted, lock, merge) for each own header that has a lock or needs one.
template <class Visit>
void forEachOwn(const model::Model& model, const Locks& locks, const Options& options,
                Visit&& visit) {
  const model::Lookup lookup(model);
  for (const model::Header& header : model.headers) {
    const Lock old = lockOf(header, locks);
    if (!header.own || (!needsLock(header) && old.text.empty())) continue;
    const std::vector<WantedNode> asked = wanted(header, lookup);
    visit(header, asked, old, merge(asked, header, old, options));
  }
}

/// Two nodes of one lock cannot share a wire name, and two of all locks no id.
Diagnostics clashes(const std::vector<WantedNode>& wanted, const Lock& merged) {
  Diagnostics result;
  std::map<std::string, const WantedNode*> names;
  for (const WantedNode& one : wanted) {
    const auto [other, isNew] = names.emplace(one.node.name, &one);
    if (isNew) continue;
    result.push_back({one.source,
                      "wire-name-clash",
                      one.title + " has the wire name '" + one.node.name + "' as " +
                          other->second->title + " has",
                      "give one of them another: name(\"...\")",
                      {{other->second->source, other->second->title + " is declared here"}}});
  }
  for (const Node& node : merged.nodes) {
    const auto taken = names.find(node.name);
    if (!node.removed() || taken == names.end()) continue;
    result.push_back({taken->second->source,
                      "wire-name-clash",
                      taken->second->title + " has the wire name of a removed " + node.name,
                      "give it another: name(\"...\")",
                      {}});
  }
  return result;
}

std::string withoutComments(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
    const std::string line = text.substr(at, end + 1 - at);
    const std::size_t first = line.find_first_not_of(" \n");
    if (first != std::string::npos && line[first] != '#') result += line;
    at = end + 1;
  }
  return result;
}

model::Diagnostic missing(const std::vector<WantedNode>& wanted, const Lock& old,
                          const model::Header& header, const Options& options) {
  const model::Source source =
      wanted.empty() ? model::Source{0, header.path, 0} : wanted.front().source;
  return {source,
          "lock-missing",
          header.path + " has no lock: " + options.folder + "/" + old.path + " does not exist",
          "run: " + options.command + ", and commit the file that it writes",
          {}};
}

model::Diagnostic stale(const std::vector<WantedNode>& wanted, const Lock& old,
                        const Options& options) {
  model::Diagnostic result{
      wanted.empty() ? model::Source{} : wanted.front().source,
      "lock-stale",
      options.folder + "/" + old.path + " is out of date in what does not touch the wire",
      "run: " + options.command,
      {}};
  result.severity = model::Diagnostic::Severity::Warning;
  return result;
}

Diagnostics duplicateIds(const Locks& locks, const Options& options) {
  Diagnostics result;
  std::map<std::uint64_t, std::pair<const Lock*, const Node*>> ids;
  for (const auto& [path, lock] : locks.files) {
    for (const Node& node : lock.nodes) {
      const auto [other, isNew] = ids.emplace(node.id, std::pair{&lock, &node});
      if (isNew) continue;
      const auto& [otherLock, otherNode] = other->second;
      result.push_back(
          {{0, options.folder + "/" + path, node.line},
           "lock-duplicate-id",
           node.name + " has the id of " + otherNode->name + " in " + otherLock->path,
           "a lock was copied: remove the copy and run: " + options.command,
           {{{0, options.folder + "/" + otherLock->path, otherNode->line}, "the other is here"}}});
    }
  }
  return result;
}

}  // namespace

Diagnostics check(const model::Model& model, const Locks& locks, const Options& options) {
  Diagnostics all = duplicateIds(locks, options);
  forEachOwn(model, locks, options,
             [&](const model::Header& header, const std::vector<WantedNode>& wanted,
                 const Lock& old, Merge merge) {
               append(all, clashes(wanted, merge.lock));
               if (old.text.empty()) {
                 all.push_back(missing(wanted, old, header, options));
                 return;
               }
               const bool clean = merge.breaks.empty() && merge.pending.empty();
               append(all, std::move(merge.breaks));
               append(all, std::move(merge.pending));
               if (clean && withoutComments(write(merge.lock)) != withoutComments(old.text)) {
                 all.push_back(stale(wanted, old, options));
               }
             });
  return all;
}

Update update(const model::Model& model, const Locks& locks, const Options& options) {
  Update result;
  result.diagnostics = duplicateIds(locks, options);
  forEachOwn(model, locks, options,
             [&](const model::Header&, const std::vector<WantedNode>& wanted, const Lock& old,
                 Merge merge) {
               append(result.diagnostics, clashes(wanted, merge.lock));
               append(result.diagnostics, std::move(merge.breaks));
               std::string text = write(merge.lock);
               if (text != old.text) result.files.push_back({old.path, std::move(text)});
             });
  return result;
}

}  // namespace suture::compiler::lock
