#include "compiler/lock/verdicts.h"

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/lock/schema/writer.h"

namespace suture::compiler::lock {
namespace {

using model::Diagnostic;

class Judge {
 public:
  Judge(const std::vector<WantedNode>& wanted, const model::Header& header, const Lock& old,
        const Options& options)
      : header_(header), old_(old), options_(options) {
    for (const WantedNode& node : wanted) nodes_.emplace(node.node.name, &node);
  }

  Verdicts run(const std::vector<Difference>& found) {
    for (const Difference& one : found) judge(one);
    return std::move(verdicts_);
  }

 private:
  void judge(const Difference& one) {
    if (one.effect == Effect::Break) {
      verdicts_.broken.insert(one.now.node->name);
      const std::string help =
          adviceOnBreak(one) +
          "; where all peers are replaced together, run: " + options_.breakCommand;
      verdicts_.breaks.push_back(diagnostic(one, "lock-break", help));
      return;
    }
    switch (one.change) {
      case Change::New: return addPending(one, "lock-new");
      case Change::Removed: return addPending(one, "lock-removed");
      case Change::Renamed: return addPending(one, "lock-renamed");
      case Change::Moved: return addPending(one, "lock-moved");
      case Change::Limit: return addPending(one, "lock-range");
      default: break;
    }
    Diagnostic stale = diagnostic(one, "lock-stale", "run: " + options_.command);
    stale.severity = Diagnostic::Severity::Warning;
    verdicts_.stale.push_back(std::move(stale));
  }

  void addPending(const Difference& one, const char* slug) {
    std::string help = "run: " + options_.command;
    if (one.change == Change::Removed && one.before.member != nullptr) {
      help = "say was(\"" + one.before.member->name +
             "\") on what replaces it, or keep its place by running: " + options_.command;
    } else if (!one.hint.empty()) {
      help = one.hint + "; else run: " + options_.command;
    }
    verdicts_.pending.push_back(diagnostic(one, slug, help));
  }

  Diagnostic diagnostic(const Difference& one, const char* slug, std::string help) const {
    const WantedMember* const member = memberOf(one.now);
    const WantedNode* const node = nodeOf(one.now);
    const model::Source source = member != nullptr ? member->source
                                 : node != nullptr ? node->source
                                                   : model::Source{0, header_.path, 0};
    const std::string title = member != nullptr ? member->title
                              : node != nullptr ? node->title
                                                : one.subject;
    return {source, slug, messageOf(one, title), std::move(help), notesOf(one)};
  }

  const WantedNode* nodeOf(const LockPlace& place) const {
    const auto found = place.node == nullptr ? nodes_.end() : nodes_.find(place.node->name);
    return found == nodes_.end() ? nullptr : found->second;
  }

  const WantedMember* memberOf(const LockPlace& place) const {
    const WantedNode* const node = nodeOf(place);
    if (node == nullptr || place.member == nullptr) return nullptr;
    const auto found = std::find_if(
        node->members.begin(), node->members.end(),
        [&](const WantedMember& one) { return one.member.name == place.member->name; });
    return found == node->members.end() ? nullptr : &*found;
  }

  std::string messageOf(const Difference& one, const std::string& title) const {
    const bool isPart = !one.part.empty(), isNode = one.before.member == nullptr;
    const std::string subject = isPart ? title + ": " + one.part : title;
    switch (one.change) {
      case Change::New: return subject + " is not in the lock " + where(one);
      case Change::Removed:
        return isNode ? one.before.node->name + " is no longer declared in " + header_.path
                      : title + " no longer has '" + one.before.member->name + "'";
      case Change::Renamed:
        return isNode ? title + " has a new wire name, '" + one.now.node->name + "'"
                      : title + " was '" + one.before.member->name +
                            "' so far; the lock has to learn its new name";
      default: return subject + one.detail;
    }
  }

  std::string adviceOnBreak(const Difference& one) const {
    switch (one.change) {
      case Change::Kind: return "give the new thing a name of its own";
      case Change::Removed:
        return one.before.member == nullptr
                   ? "old peers use it: put it back, or say was() on what replaces it"
                   : "say was(\"" + one.before.member->name +
                         "\") on what replaces it, or keep it and say deprecated(): old peers use "
                         "it";
      case Change::Type:
        if (isOfTwoLocks(one)) {
          return "each lock has its own struct for such a type (an optional, a variant, a tuple, a "
                 "map, a matrix of any size), and one of the two headers has it beside this: "
                 "leave " +
                 one.before.node->name + " in its header";
        }
        return hintOfRenamedType(one) + "a type never changes: add '" + one.before.member->name +
               "' anew under another name and remove the old one";
      case Change::Meaning:
        return "a change of " + one.what +
               " changes what the bytes mean: put it back, or add the new form under another name";
      case Change::Parameter: return "a signature only grows: put it back under the same name";
      case Change::Base:
        return "its commands are part of the contract: leave the bases as they were";
      case Change::Version: return "keep the version while old peers are in use";
      default: return "restore the lock";
    }
  }

  /// Says what to do if the member's type is the earlier one under another name: without was() that
  /// looks like another type. Returns "" if it cannot be.
  std::string hintOfRenamedType(const Difference& one) const {
    if (one.now.member == nullptr) return "";
    const std::string before = leafOf(one.before.member->type), now = leafOf(one.now.member->type);
    const bool gone = isInLock(before) && !nodes_.contains(before);
    const bool isNew = nodes_.contains(now) && !isInLock(now);
    if (!gone || !isNew) return "";
    return "if '" + now + "' is '" + before + "' under another name, say was(\"" + before +
           "\") on '" + now + "'; else ";
  }

  bool isInLock(const std::string& name) const {
    return std::any_of(old_.nodes.begin(), old_.nodes.end(),
                       [&](const Node& node) { return node.name == name && !node.removed(); });
  }

  /// Tells if what moved here has a composite now that this lock does not share with the other.
  bool isOfTwoLocks(const Difference& one) const {
    if (!one.before.node->cameFrom || one.now.member == nullptr) return false;
    const auto found = nodes_.find(leafOf(one.now.member->type));
    return found != nodes_.end() && found->second->cxxName.empty();
  }

  std::vector<model::Note> notesOf(const Difference& one) const {
    if (one.change == Change::New || one.before.node == nullptr) return {};
    const bool isNode = one.before.member == nullptr;
    const unsigned line = isNode ? one.before.node->line : one.before.member->line;
    const std::string text = isNode ? one.before.node->name : describe(*one.before.member);
    return {{{0, pathOf(*one.before.node), line}, "the lock has: " + text}};
  }

  std::string where(const Difference& one) const {
    if (one.before.node == nullptr) return options_.folder + "/" + old_.path;
    const std::string path = pathOf(*one.before.node);
    const bool isPart = one.before.member != nullptr;
    return path + ":" + std::to_string(isPart ? one.before.member->line : one.before.node->line);
  }

  /// Returns the file that has the line of the node.
  std::string pathOf(const Node& node) const {
    return options_.folder + "/" + (node.cameFrom ? node.cameFrom->path : old_.path);
  }

  const model::Header& header_;
  const Lock& old_;
  const Options& options_;
  std::map<std::string, const WantedNode*> nodes_;
  Verdicts verdicts_;
};

}  // namespace

Verdicts verdicts(const std::vector<Difference>& found, const std::vector<WantedNode>& wanted,
                  const model::Header& header, const Lock& old, const Options& options) {
  return Judge(wanted, header, old, options).run(found);
}

}  // namespace suture::compiler::lock
