#pragma once
// Where clang's own headers (stddef.h and its like) are.

#include <string>

namespace suture::compiler::driver {

/// The one asked for; else beside an installed suturec; else where the build found it. Throws
/// std::runtime_error naming the package when it is nowhere: clang would only miss stddef.h later.
std::string resourceDirectory(const std::string& asked);

}  // namespace suture::compiler::driver
