#pragma once
// This is the order in which commands, events and fields are numbered.

#include "compiler/lock/schema/lock.h"
#include "compiler/model/model.h"

namespace suture::compiler::emit {

/// Returns the model with the commands and events of each contract in the order of their ordinals,
/// so that two builds of one lock number them alike, however their headers are arranged. What the
/// lock does not know keeps its order, at the end.
model::Model ordered(model::Model model, const lock::Locks& locks);

}  // namespace suture::compiler::emit
