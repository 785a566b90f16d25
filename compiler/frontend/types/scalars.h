#pragma once
// Builtin types: which of them have a portable wire form.

#include <clang/AST/Type.h>

#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {

/// The canonical builtin decides, so that `long` and std::int64_t are one type.
MappedType mapBuiltin(const clang::BuiltinType* type);

/// The same in a struct that cannot be edited, where each integer is carried as one of its size.
MappedType mapForeignBuiltin(const clang::BuiltinType* type);

}  // namespace suture::compiler::frontend
