#pragma once
// This maps SUTURE_EVENT: a member of a contract, and the values that it carries.

#include <clang/AST/DeclCXX.h>
#include <clang/AST/TemplateBase.h>

#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

/// Returns the arguments of suture::EventOf if the type is that template, else null.
const clang::TemplateArgument* eventArguments(clang::QualType type);

/// Maps the event, whose values `payload` has, as eventArguments() returns it.
model::Event mapEvent(const clang::FieldDecl* field, const clang::TemplateArgument& payload,
                      Mapping& mapping);

}  // namespace suture::compiler::frontend
