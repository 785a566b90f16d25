#pragma once
// Header against lock: what is the lock to become, and what does the header ask that a lock
// forbids?

#include <set>
#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/wanted.h"

namespace suture::compiler::lock {

struct Merge {
  Lock lock;                     ///< as it should be, when there are no breaks
  model::Diagnostics breaks;     ///< would change the meaning of bytes that already have one
  model::Diagnostics pending;    ///< allowed, but the lock has to be written first
  std::set<std::string> broken;  ///< names of the nodes that have a break
};

/// `old` is the committed lock, or one without nodes when there is none.
Merge merge(const std::vector<WantedNode>& wanted, const model::Header& header, const Lock& old,
            const Options& options);

}  // namespace suture::compiler::lock
