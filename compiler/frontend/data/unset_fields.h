#pragma once
// This finds members whose class leaves them whatever memory had.

#include <clang/AST/Decl.h>

#include <optional>

#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

/// Tells if nothing sets the member of a struct that cannot be edited, but "{}" behind a variable
/// of the struct would.
bool isRaw(const clang::FieldDecl* field, const model::Type& type);

/// Says what would set the member, if nothing does. It is said once of a member of a template,
/// whatever the number of its instances.
std::optional<model::Unset> unsetState(const clang::FieldDecl* field, const model::Type& type,
                                       Mapping& mapping);

}  // namespace suture::compiler::frontend
