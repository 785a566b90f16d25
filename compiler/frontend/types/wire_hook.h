#pragma once
// suture::Wire<T> says what a type that suturec cannot look into travels as.

#include <clang/AST/DeclCXX.h>

#include <optional>

#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {

/// Returns the wire view of a type by its suture::Wire; none if that is not specialised for it.
std::optional<MappedType> mapByHook(const clang::CXXRecordDecl* type, const NamedTypes& names);

}  // namespace suture::compiler::frontend
