#pragma once
// This maps SUTURE_INTERFACE: its base, and the commands and events of its own.

#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

model::Interface mapInterfaceDeclaration(const clang::CXXRecordDecl* declaration, Mapping& mapping);

}  // namespace suture::compiler::frontend
