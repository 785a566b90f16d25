#pragma once
// This maps SUTURE_TYPE and SUTURE_EXTERNAL_TYPE: structs and enums.

#include "compiler/frontend/types/data_declaration.h"
#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

model::Enum mapEnumDeclaration(const EnumDeclaration& declared, Mapping& mapping);
model::Struct mapStructDeclaration(const DataDeclaration& declared, Mapping& mapping);

}  // namespace suture::compiler::frontend
