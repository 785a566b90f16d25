#pragma once
// This finds the folder of clang's own headers (stddef.h and its like).

#include <string>

namespace suture::compiler::driver {

/// Returns `asked`; else the folder beside an installed suturec; else the one that the build found.
/// If none is there, throws std::runtime_error naming the package before clang misses stddef.h.
std::string resourceDirectory(const std::string& asked);

}  // namespace suture::compiler::driver
