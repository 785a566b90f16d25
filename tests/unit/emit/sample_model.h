#pragma once
// This is a model made by hand for the tests of lock and emit.

#include "tests/unit/emit/model_parts.h"

namespace suture::compiler::sample {

/// Returns "robots/geometry.h" (foreign, with robots::PoseStamped) and "robots/arm.h" (own: every
/// supported type, an enum with values that are not ordinals, a contract with every kind of command
/// and event, a component with parameters).
model::Model robots();

/// Returns the model as if all its headers were of one target, which writes the locks of all.
model::Model allOwn(model::Model model);

/// Returns the own header of robots().
model::Header& armHeader(model::Model& model);

}  // namespace suture::compiler::sample
