#pragma once
// This holds what `suturec --fix` writes, apart from fix_collector.h, since that sees clang.

#include <vector>

#include "compiler/model/artefact.h"

namespace suture::compiler::frontend {

/// This holds what the fix-its of all errors so far come to.
struct Fixes {
  std::vector<model::Artefact> files;  ///< whole new texts, by absolute path
  unsigned fixed = 0, open = 0;        ///< errors with and without a fix-it
};

}  // namespace suture::compiler::frontend
