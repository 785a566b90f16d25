#pragma once
// This tells the composites of two headers of one namespace apart, because capnp declares both
// schemas' structs in that namespace.

#include "compiler/lock/schema/lock.h"
#include "compiler/model/model.h"

namespace suture::compiler::lock {

/// Gives headers of one namespace whose paths make the same prefix ("arm.h" and "arm/arm.h") one of
/// their own each: "Arm" and "Arm2". One whose lock has composites keeps the prefix that these
/// have.
void settlePrefixes(model::Model& model, const Locks& locks);

}  // namespace suture::compiler::lock
