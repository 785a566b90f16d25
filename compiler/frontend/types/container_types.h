#pragma once
// These map the standard library's containers and sums that have a natural wire form.

#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {

using Specialisation = clang::ClassTemplateSpecializationDecl;

/// Returns the type of that argument of an instance, canonical.
clang::QualType typeArgument(const Specialisation* type, unsigned index);

/// Maps an element and appends it to `outer`. If the element has a problem, it completes the reason
/// and returns that.
std::optional<TypeProblem> addElement(model::Type& outer, clang::QualType element,
                                      const NamedTypes& names);

/// Maps an array of either kind; its caller completes `spelling`.
MappedType mapFixedArray(clang::QualType element, std::uint64_t length, const NamedTypes& names);

MappedType mapString(const Specialisation* type, const NamedTypes& names);
MappedType mapSequence(const Specialisation* type, const NamedTypes& names);  ///< vector, deque
MappedType mapArray(const Specialisation* type, const NamedTypes& names);
MappedType mapSet(const Specialisation* type, const NamedTypes& names);  ///< ordered or not
MappedType mapMap(const Specialisation* type, const NamedTypes& names);  ///< ordered or not
MappedType mapOptional(const Specialisation* type, const NamedTypes& names);
MappedType mapUniquePointer(const Specialisation* type, const NamedTypes& names);
MappedType mapTuple(const Specialisation* type, const NamedTypes& names);  ///< pairs too
MappedType mapVariant(const Specialisation* type, const NamedTypes& names);

}  // namespace suture::compiler::frontend
