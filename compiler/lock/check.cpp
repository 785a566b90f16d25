#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "compiler/lock/differences.h"
#include "compiler/lock/major_versions.h"
#include "compiler/lock/merge.h"
#include "compiler/lock/moves/moves.h"
#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/lock/schema/writer.h"
#include "compiler/lock/verdicts.h"

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

/// Holds the wire names of all headers, by the C++ namespace in which capnp will declare them.
class WireNames {
 public:
  WireNames(const model::Model& model, const model::Lookup& lookup) {
    for (const bool own : {false, true}) {  // a clash with a foreign header is reported at ours
      for (const model::Header& header : model.headers) {
        if (header.own == own) add(header, lookup);
      }
    }
  }

  /// Reports the nodes of `header` that have the name of another node.
  Diagnostics clashes(const model::Header& header, const std::vector<WantedNode>& nodes) const {
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

  /// Reports nodes that have the name of a removed one: it keeps its name in the schema, so no
  /// header of the namespace may give it again.
  Diagnostics clashesWithRemoved(const Judged& judged, const Lock& merged) const {
    Diagnostics result;
    const model::Header& header = judged.header;
    for (const Node& node : merged.nodes) {
      const auto taken = owners_.find(header.cxxNamespace + "::" + node.name);
      if (!node.removed() || taken == owners_.end()) continue;
      const WantedNode& owner = taken->second.node;
      result.push_back({owner.source,
                        "wire-name-clash",
                        owner.title + " has the wire name of a removed " + node.name,
                        adviceOnRemoved(node, owner, judged.old),
                        {}});
    }
    return result;
  }

 private:
  struct Owner {
    std::string path;
    WantedNode node;
  };

  /// Says was() if it would match the two, which it does with what this edit removes.
  static std::string adviceOnRemoved(const Node& removed, const WantedNode& taker,
                                     const Lock& old) {
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

  void add(const model::Header& header, const model::Lookup& lookup) {
    for (WantedNode& node : wanted(header, lookup)) {
      const std::string name = header.cxxNamespace + "::" + node.node.name;
      owners_.emplace(name, Owner{header.path, std::move(node)});
    }
  }

  /// Reports a composite that the locks of two headers give the same name.
  static model::Diagnostic sameComposite(const WantedNode& node, const std::string& other) {
    return {node.source,
            "wire-name-clash",
            node.title + " has the wire name '" + node.node.name + "' here and in " + other,
            "rename one of the two headers: such names begin with its path",
            {{{0, other, 0}, "this header has it too"}}};
  }

  std::map<std::string, Owner> owners_;
};

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

/// Reports members that have the name of what suturec adds to every contract (subscribe, state,
/// stamp, evaluated, sent).
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

/// Finds headers of other targets that ours use and whose locks the run has not read: the places of
/// what they declare would follow the order of their declarations, which may change.
class UnlockedHeaders {
 public:
  UnlockedHeaders(const model::Model& model, const model::Lookup& lookup, const Locks& locks)
      : lookup_(lookup), locks_(locks) {
    for (const model::Header& header : model.headers) headers_[lockPath(header.path)] = &header;
  }

  /// Reports each at what first leads to it.
  Diagnostics usedBy(const Judged& judged) {
    for (const WantedNode& node : judged.wanted) {
      for (const std::string& base : node.node.extends) visit(base, judged.old.path, node.source);
      for (const WantedMember& member : node.members) {
        visit(member.member, judged.old.path, member.source);
      }
    }
    return std::exchange(found_, {});
  }

 private:
  void visit(const Member& member, const std::string& inside, const model::Source& source) {
    visit(member.type, inside, source);
    for (const Member& parameter : member.parameters) visit(parameter, inside, source);
    for (const Member& result : member.results) visit(result, inside, source);
  }

  void visit(const std::string& type, const std::string& inside, const model::Source& source) {
    const std::string path = placeOf(type, inside).path;
    const auto home = headers_.find(path);
    if (path == inside || home == headers_.end() || home->second->own) return;
    if (!seen_.insert(path).second) return;
    if (!locks_.files.contains(path)) return report(*home->second, path, source);
    for (const WantedNode& node : wanted(*home->second, lookup_)) {
      for (const std::string& base : node.node.extends) visit(base, path, source);
      for (const WantedMember& member : node.members) visit(member.member, path, source);
    }
  }

  void report(const model::Header& header, const std::string& path, const model::Source& source) {
    found_.push_back({source,
                      "lock-missing",
                      header.path + " of another target has no lock: no lock folder has " + path +
                          ", and it does not lie beside the header",
                      "give the lock folder of its project: LOCK_PATH of suture_generate(), or "
                      "--lock-dir; if there is no lock yet, let that project write it",
                      {}});
  }

  const model::Lookup& lookup_;
  const Locks& locks_;
  std::map<std::string, const model::Header*> headers_;
  std::set<std::string> seen_;
  Diagnostics found_;
};

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
    append(all, names.clashesWithRemoved(judged, merged));
    if (judged.old.text.empty()) {
      all.push_back(missing(judged, options));
      return;
    }
    append(all, unlocked.usedBy(judged));
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
    append(result.diagnostics, names.clashesWithRemoved(judged, lock));
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
