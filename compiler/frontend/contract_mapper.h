#pragma once
// This maps SUTURE_INTERFACE: commands and events.

#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

model::Interface mapInterfaceDeclaration(const clang::CXXRecordDecl* declaration, Mapping& mapping);

/// Returns the arguments of suture::EventOf if the type is that template, else null.
const clang::TemplateArgument* eventArguments(clang::QualType type);

}  // namespace suture::compiler::frontend
