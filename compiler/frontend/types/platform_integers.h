#pragma once
// Integers of which the width is the platform's choice, as the user wrote them: `long` and
// std::int64_t are one canonical type here, but not everywhere.

#include <clang/AST/Type.h>

#include <string>

namespace suture::compiler::frontend {

/// "std::size_t": the first such integer in the type as written; "" if there is none.
std::string platformInteger(clang::QualType type);

}  // namespace suture::compiler::frontend
