#pragma once
// What `suturec --fix` writes. It is apart from fix_collector.h, which sees clang.

#include <vector>

#include "compiler/model/artefact.h"

namespace suture::compiler::frontend {

/// What the fix-its of all errors so far come to.
struct Fixes {
  std::vector<model::Artefact> files;  ///< whole new texts, by absolute path
  unsigned fixed = 0, open = 0;        ///< errors with and without a fix-it
};

}  // namespace suture::compiler::frontend
