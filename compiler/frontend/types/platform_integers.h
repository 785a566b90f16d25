#pragma once
// This finds integers whose width the platform chooses, as the user wrote them: `long` and
// std::int64_t are one canonical type here, but not everywhere.

#include <clang/AST/Type.h>

#include <string>

namespace suture::compiler::frontend {

/// Returns the first such integer in the type as written, such as "std::size_t"; "" if there is
/// none.
std::string platformInteger(clang::QualType type);

}  // namespace suture::compiler::frontend
