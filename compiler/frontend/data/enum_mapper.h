#pragma once
// This maps an enum that is annotated, or that SUTURE_EXTERNAL_TYPE names.

#include "compiler/frontend/types/data_declaration.h"
#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

model::Enum mapEnumDeclaration(const EnumDeclaration& declared, Mapping& mapping);

}  // namespace suture::compiler::frontend
