#pragma once
// This runs the stages in order: frontend, check, lock, emit, files.

#include "compiler/driver/options.h"

namespace suture::compiler::driver {

/// Returns the exit status: 0, or 1 after an error, which has been printed; then nothing was
/// written. Throws std::runtime_error for what concerns no header (a missing file, a full disk).
int run(const Options& options);

}  // namespace suture::compiler::driver
