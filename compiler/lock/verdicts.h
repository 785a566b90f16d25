#pragma once
// This tells the user of each edit, at the line of the header that makes it.

#include <set>
#include <string>
#include <vector>

#include "compiler/lock/differences.h"
#include "compiler/lock/schema/wanted.h"

namespace suture::compiler::lock {

struct Verdicts {
  model::Diagnostics breaks;   ///< they would change what bytes mean that have a meaning already
  model::Diagnostics pending;  ///< they are allowed, but the lock has to be written first
  model::Diagnostics stale;    ///< warnings: the lock does not know it, and the wire does not care
  std::set<std::string> broken;  ///< names of the nodes that have a break
};

/// Judges `found`, the differences between `old` and what the header makes of it.
Verdicts verdicts(const std::vector<Difference>& found, const std::vector<WantedNode>& wanted,
                  const model::Header& header, const Lock& old, const Options& options);

}  // namespace suture::compiler::lock
