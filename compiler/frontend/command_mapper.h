#pragma once
// This maps SUTURE_COMMAND: a method, its parameters and its result.

#include <clang/AST/DeclCXX.h>

#include <string>

#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

/// Maps the command, and reports what no proxy could call and what cannot travel.
model::Command mapCommand(const clang::CXXMethodDecl* method, Mapping& mapping);

/// Returns how messages call a command.
std::string commandSubject(const clang::NamedDecl* method);

/// Reports what a result, or an event's value, cannot say: it has neither a name nor a history of
/// its own.
void checkValueArguments(const clang::NamedDecl* declaration, const Annotation& field,
                         Mapping& mapping);

}  // namespace suture::compiler::frontend
