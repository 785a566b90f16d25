#pragma once
// These say which builtin types have a portable wire form.

#include <clang/AST/Type.h>

#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {

/// Maps the canonical builtin, so that `long` and std::int64_t are one type.
MappedType mapBuiltin(const clang::BuiltinType* type);

/// Maps a builtin in a struct that cannot be edited, where a char and a long long are carried as
/// the integers of their size.
MappedType mapForeignBuiltin(const clang::BuiltinType* type);

}  // namespace suture::compiler::frontend
