#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "compiler/lock/differences.h"
#include "compiler/lock/major_versions.h"
#include "compiler/lock/merge.h"
#include "compiler/lock/moves/moves.h"
#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/lock/schema/writer.h"
#include "compiler/lock/unlocked_headers.h"
#include "compiler/lock/verdicts.h"
#include "compiler/lock/wire_names.h"

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

/// Holds a header of ours, what it asks for, and what was agreed so far.
struct Judged {
  const model::Header& header;
  const std::vector<WantedNode> wanted;
  const Lock old;

  model::Source source() const {
    return wanted.empty() ? model::Source{0, header.path, 0} : wanted.front().source;
  }
};

/// Calls visit(judged, the lock as it should be) for each own header that has a lock or needs one.
/// `locks` are relocated() by `moves`.
template <class Visit>
void forEachOwn(const model::Model& model, const model::Lookup& lookup, const Locks& locks,
                const std::vector<Move>& moves, const Options& options, const Visit& visit) {
  for (const model::Header& header : model.headers) {
    const Lock old = lockOf(header, locks);
    if (!header.own || (!needsLock(header) && old.text.empty())) continue;
    std::vector<WantedNode> nodes = wanted(header, lookup);
    Lock merged = merge(nodes, header, old, options.project);
    noteMoves(old, merged, locks, moves);
    visit(Judged{header, std::move(nodes), old}, std::move(merged));
  }
}

Verdicts verdictsOf(const Judged& judged, const Lock& merged, const Options& options) {
  return verdicts(differences(judged.old, merged), judged.wanted, judged.header, judged.old,
                  options);
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

model::Diagnostic missing(const Judged& judged, const Options& options) {
  return {judged.source(),
          "lock-missing",
          judged.header.path + " has no lock: " + options.folder + "/" + judged.old.path +
              " does not exist",
          "run: " + options.command + ", and commit the file that it writes",
          {}};
}

model::Diagnostic stale(const Judged& judged, const Options& options) {
  return {
      judged.source(),
      "lock-stale",
      options.folder + "/" + judged.old.path + " is out of date in what does not touch the wire",
      "run: " + options.command,
      {},
      model::Diagnostic::Severity::Warning};
}

bool isNamed(const Node& node, const std::string& name) {
  return node.name == name || identity(node) == "cxx " + quoted(name);
}

/// Returns the locks with a fresh id for each node that options.newIds names.
Locks withNewIds(Locks locks, const Options& options, std::vector<std::string>& unknown) {
  for (const std::string& name : options.newIds) {
    bool found = false;
    std::set<std::uint64_t> seen;
    for (auto& [path, lock] : locks.files) {
      if (lock.header == name) {
        found = true;
        lock.id = freshId(options.project, path + "\n" + lock.header);
      }
      for (Node& node : lock.nodes) {
        if (!isNamed(node, name)) {
          seen.insert(node.id);
          continue;
        }
        found = true;
        node.id = freshId(options.project, path + "\n" + identity(node));
        while (!seen.insert(node.id).second) ++node.id;
      }
    }
    if (!found) unknown.push_back(name);
  }
  return locks;
}

/// Gives nodes that are new in a lock an id that no lock has or had.
void giveFreeIds(std::map<std::string, Lock>& merged, const Locks& old) {
  std::set<std::uint64_t> taken;
  for (const auto* const all : {&old.files, &old.others}) {
    for (const auto& [path, lock] : *all) {
      for (const Node& node : lock.nodes) taken.insert(node.id);
      for (const Departure& one : lock.departures) taken.insert(one.id);
    }
  }
  for (auto& [path, lock] : merged) {
    const auto before = old.files.find(path);
    const std::size_t kept = before == old.files.end() ? 0 : before->second.nodes.size();
    for (std::size_t i = kept; i < lock.nodes.size(); ++i) {
      while (!taken.insert(lock.nodes[i].id).second) ++lock.nodes[i].id;
    }
  }
}

Diagnostics duplicateIds(const Locks& locks, const Options& options) {
  Diagnostics result;
  std::map<std::uint64_t, std::pair<const Lock*, const Node*>> ids;
  std::map<std::uint64_t, const Lock*> fileIds;
  for (const auto& [path, lock] : locks.files) {
    const auto [first, fresh] = fileIds.emplace(lock.id, &lock);
    if (!fresh && !lock.text.empty()) {  // one that is not written yet has no id
      result.push_back({{0, options.folder + "/" + path, 1},
                        "lock-duplicate-id",
                        path + " has the id of " + first->second->path,
                        "a lock was copied: give it an id of its own with --new-id " + lock.header +
                            " behind: " + options.command,
                        {}});
    }
    for (const Node& node : lock.nodes) {
      const auto [other, isNew] = ids.emplace(node.id, std::pair{&lock, &node});
      if (isNew) continue;
      const auto& [otherLock, otherNode] = other->second;
      result.push_back(
          {{0, options.folder + "/" + path, node.line},
           "lock-duplicate-id",
           node.name + " has the id of " + otherNode->name + " in " + otherLock->path,
           "a lock was copied: give it an id of its own with --new-id " + node.name +
               " behind: " + options.command,
           {{{0, options.folder + "/" + otherLock->path, otherNode->line}, "the other is here"}}});
    }
  }
  return result;
}

}  // namespace

Diagnostics check(const model::Model& model, const Locks& committed, const Options& options) {
  const Moves moves = findMoves(model, committed, options);
  const Locks locks = relocated(committed, moves.all);
  Diagnostics all = duplicateIds(locks, options);
  append(all, moves.found);
  const model::Lookup lookup(model);
  const WireNames names(model, lookup);
  UnlockedHeaders unlocked(model, lookup, locks);
  const auto judge = [&](const Judged& judged, const Lock& merged) {
    append(all, names.clashes(judged.header, judged.wanted));
    append(all, clashesOfComposites(judged.header, lookup));
    append(all, clashesWithOwn(judged.wanted));
    append(all, names.clashesWithRemoved(judged.header, judged.old, merged));
    if (judged.old.text.empty()) {
      all.push_back(missing(judged, options));
      return;
    }
    append(all, unlocked.usedBy(judged.wanted, judged.old.path));
    Verdicts found = verdictsOf(judged, merged, options);
    const bool errors = !found.breaks.empty() || !found.pending.empty();
    const bool told = errors || !found.stale.empty();
    append(all, std::move(found.breaks));
    append(all, std::move(found.pending));
    if (!errors) append(all, std::move(found.stale));
    if (!told && withoutComments(write(merged)) != withoutComments(judged.old.text)) {
      all.push_back(stale(judged, options));
    }
  };
  forEachOwn(model, lookup, locks, moves.all, options, judge);
  return all;
}

Update update(const model::Model& model, const Locks& committed, const Options& options) {
  Update result;
  const Locks renewed = withNewIds(committed, options, result.unknownIds);
  const Moves moves = findMoves(model, renewed, options);
  const Locks locks = relocated(renewed, moves.all);
  append(result.diagnostics, duplicateIds(locks, options));
  append(result.diagnostics, moves.found);
  const model::Lookup lookup(model);
  const WireNames names(model, lookup);
  std::map<std::string, Lock> merged = locks.files;
  std::set<std::string> own, broken;
  std::map<std::string, Lock> before;
  forEachOwn(model, lookup, locks, moves.all, options, [&](const Judged& judged, Lock lock) {
    append(result.diagnostics, names.clashes(judged.header, judged.wanted));
    append(result.diagnostics, clashesOfComposites(judged.header, lookup));
    append(result.diagnostics, clashesWithOwn(judged.wanted));
    append(result.diagnostics, names.clashesWithRemoved(judged.header, judged.old, lock));
    Verdicts found = verdictsOf(judged, lock, options);
    if (!options.acceptBreaks) append(result.diagnostics, std::move(found.breaks));
    const std::string path = judged.old.path;
    for (const std::string& node : found.broken) broken.insert(path + ":" + node);
    own.insert(path);
    before[path] = judged.old;
    merged[path] = std::move(lock);
  });
  giveFreeIds(merged, locks);
  raiseMajors(merged, own, broken);
  for (const std::string& path : own) {
    const auto old = committed.files.find(path);
    std::string text = write(merged.at(path));
    if (old != committed.files.end() && text == old->second.text) continue;
    for (const Difference& one : differences(before.at(path), merged.at(path))) {
      result.changes[path].push_back(one.line());
    }
    result.files.push_back({path, std::move(text)});
  }
  return result;
}

}  // namespace suture::compiler::lock
