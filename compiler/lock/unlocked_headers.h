#pragma once
// This finds headers of other targets whose locks are missing.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/model/model.h"

namespace suture::compiler::lock {

/// Finds headers of other targets that ours use and whose locks the run has not read: the places of
/// what they declare would follow the order of their declarations, which may change.
class UnlockedHeaders {
 public:
  /// All of them outlive this.
  UnlockedHeaders(const model::Model& model, const model::Lookup& lookup, const Locks& locks);

  /// Reports each at what first leads to it: what a header of ours, whose lock is at `path`, asks
  /// for.
  model::Diagnostics usedBy(const std::vector<WantedNode>& wanted, const std::string& path);

 private:
  void visit(const Member& member, const std::string& inside, const model::Source& source);
  void visit(const std::string& type, const std::string& inside, const model::Source& source);
  void report(const model::Header& header, const std::string& path, const model::Source& source);

  const model::Lookup& lookup_;
  const Locks& locks_;
  std::map<std::string, const model::Header*> headers_;
  std::set<std::string> seen_;
  model::Diagnostics found_;
};

}  // namespace suture::compiler::lock
