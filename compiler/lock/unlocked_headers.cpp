#include "compiler/lock/unlocked_headers.h"

#include <utility>

#include "compiler/lock/schema/type_place.h"

namespace suture::compiler::lock {

UnlockedHeaders::UnlockedHeaders(const model::Model& model, const model::Lookup& lookup,
                                 const Locks& locks)
    : lookup_(lookup), locks_(locks) {
  for (const model::Header& header : model.headers) headers_[lockPath(header.path)] = &header;
}

model::Diagnostics UnlockedHeaders::usedBy(const std::vector<WantedNode>& wanted,
                                           const std::string& path) {
  for (const WantedNode& node : wanted) {
    for (const std::string& base : node.node.extends) visit(base, path, node.source);
    for (const WantedMember& member : node.members) {
      visit(member.member, path, member.source);
    }
  }
  return std::exchange(found_, {});
}

void UnlockedHeaders::visit(const Member& member, const std::string& inside,
                            const model::Source& source) {
  visit(member.type, inside, source);
  for (const Member& parameter : member.parameters) visit(parameter, inside, source);
  for (const Member& result : member.results) visit(result, inside, source);
}

void UnlockedHeaders::visit(const std::string& type, const std::string& inside,
                            const model::Source& source) {
  const std::string path = placeOf(type, inside).path;
  const auto home = headers_.find(path);
  if (path == inside || home == headers_.end() || home->second->own) return;
  if (!seen_.insert(path).second) return;
  if (!locks_.files.contains(path)) return report(*home->second, path, source);
  for (const WantedNode& node : lock::wanted(*home->second, lookup_)) {
    for (const std::string& base : node.node.extends) visit(base, path, source);
    for (const WantedMember& member : node.members) visit(member.member, path, source);
  }
}

void UnlockedHeaders::report(const model::Header& header, const std::string& path,
                             const model::Source& source) {
  found_.push_back({source,
                    "lock-missing",
                    header.path + " of another target has no lock: no lock folder has " + path +
                        ", and it does not lie beside the header",
                    "give the lock folder of its project: LOCK_PATH of suture_generate(), or "
                    "--lock-dir; if there is no lock yet, let that project write it",
                    {}});
}

}  // namespace suture::compiler::lock
