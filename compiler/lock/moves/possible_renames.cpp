#include "compiler/lock/moves/possible_renames.h"

#include <algorithm>
#include <vector>

namespace suture::compiler::lock {
namespace {

bool haveOneForm(const std::vector<Member>& before, const std::vector<Member>& now,
                 const Renames& renames);

/// Returns true if a member can be an earlier one under another name.
bool haveOneForm(const Member& before, const Member& now, const Renames& renames) {
  return before.isMethod == now.isMethod && renames.apply(before.type) == now.type &&
         haveOneForm(before.parameters, now.parameters, renames) &&
         haveOneForm(before.results, now.results, renames);
}

bool haveOneForm(const std::vector<Member>& before, const std::vector<Member>& now,
                 const Renames& renames) {
  return std::equal(
      before.begin(), before.end(), now.begin(), now.end(),
      [&](const Member& old, const Member& one) { return haveOneForm(old, one, renames); });
}

}  // namespace

std::string earlierNameOf(const Node& old, const Node& now, const Member& added,
                          const Renames& renames) {
  for (std::size_t i = 0; i < std::min(old.members.size(), now.members.size()); ++i) {
    const Member& before = old.members[i];
    const bool gone = now.members[i].removed() && !before.removed();
    if (gone && haveOneForm(before, added, renames)) return before.name;
  }
  return "";
}

std::string earlierNameOf(const Lock& old, const SameNodes& nodes, const Node& added,
                          const Renames& renames) {
  for (const Node& before : old.nodes) {
    const Node* const now = nodes.find(before);
    const bool gone = now != nullptr && now->removed() && !before.removed();
    if (!gone || before.kind != added.kind) continue;
    if (haveOneForm(before.members, added.members, renames)) return before.name;
  }
  return "";
}

std::string hintOfRename(const std::string& earlierName) {
  if (earlierName.empty()) return "";
  return "if it is '" + earlierName + "' under another name, say was(\"" + earlierName + "\")";
}

}  // namespace suture::compiler::lock
