#pragma once
// This holds what `suturec --fix` writes, apart from fix_collector.h, since that sees clang.

#include <vector>

#include "compiler/model/artefact.h"

namespace suture::compiler::frontend {

/// This holds what the fix-its of all findings so far come to.
struct Fixes {
  std::vector<model::Artefact> files;  ///< whole new texts, by absolute path
  unsigned fixed = 0, open = 0;  ///< findings whose fix-its are applied, and findings that are left
};

}  // namespace suture::compiler::frontend
