#pragma once
// These map a clang type to the wire view of it. They recognise a type by its template's
// declaration and canonical arguments, never by printed text, which changes between versions of
// clang.

#include <clang/AST/ASTContext.h>
#include <clang/AST/Type.h>

#include <string>
#include <variant>
#include <vector>

#include "compiler/frontend/types/named_types.h"
#include "compiler/model/type.h"

namespace suture::compiler::frontend {

/// Says why a type cannot go over a wire, but not where it stands.
struct TypeProblem {
  std::string slug;
  std::string reason;  ///< completes "field 'p' of type 'int *': "
  std::string help;
  const clang::Decl* culprit = nullptr;  ///< where the help is to be applied if that is elsewhere
};

using MappedType = std::variant<model::Type, TypeProblem>;

/// Returns the wire view of a type that is held by value; const and references must be off.
MappedType mapType(clang::QualType type, const NamedTypes& names);

/// Tells if the type is a pointer to char, which mostly means text.
bool isText(clang::QualType type);

/// Returns the problem of a type that has no form on the wire.
TypeProblem noWireForm();

/// Gives the bounds of capacity(), the outermost first, to those strings, lists, maps and matrices
/// in the type that have none yet. Returns false if there are more bounds than levels.
bool applyCapacity(model::Type& type, const std::vector<unsigned>& bounds);

/// Lets the type travel as a block of bytes. Returns false if it is not a list, an array or a large
/// matrix of plain numbers.
bool makeBulk(model::Type& type);

/// Spells the type as a message shows it.
std::string spelled(clang::QualType type, const clang::ASTContext& context);

}  // namespace suture::compiler::frontend
