#pragma once
// From a clang type to the wire view of it. Types are recognised by their template's declaration
// and canonical arguments, never by printed text, which changes between versions.

#include <clang/AST/ASTContext.h>
#include <clang/AST/Type.h>

#include <string>
#include <variant>
#include <vector>

#include "compiler/frontend/types/named_types.h"
#include "compiler/model/type.h"

namespace suture::compiler::frontend {

/// Why a type cannot go over a wire, without the place.
struct TypeProblem {
  std::string slug;
  std::string reason;  ///< completes "field 'p' of type 'int *': "
  std::string help;
  const clang::Decl* culprit = nullptr;  ///< where the help is to be applied, if elsewhere
};

using MappedType = std::variant<model::Type, TypeProblem>;

/// The wire view of a type that is held by value; const and references must be off.
MappedType mapType(clang::QualType type, const NamedTypes& names);

/// The problem of a type that is none of those that a wire carries.
TypeProblem noWireForm();

/// Gives the bounds of capacity(), outside in, to what has none yet of the strings, lists, maps
/// and matrices in the type. False if there are more bounds than levels.
bool applyCapacity(model::Type& type, const std::vector<unsigned>& bounds);

/// Says of the type that it travels as a block of bytes. False if it is no row of numbers.
bool makeBulk(model::Type& type);

/// Whether range() means something: the type is, or is a container of, plain numbers.
bool holdsNumbers(const model::Type& type);

/// Whether unit() does: plain numbers, or a transform for its translation.
bool holdsQuantities(const model::Type& type);

/// How the type reads in a message.
std::string spelled(clang::QualType type, const clang::ASTContext& context);

}  // namespace suture::compiler::frontend
