#pragma once
// This adds what a contract takes over from the one that it derives from.

#include "compiler/model/model.h"

namespace suture::compiler::frontend {

/// Puts the commands and events of each contract's base in front of its own, own and foreign
/// headers alike.
void addInherited(model::Model& model);

}  // namespace suture::compiler::frontend
