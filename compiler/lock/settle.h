#pragma once
// This gives what would have one name on the wire with another names of its own there: members,
// enumerators, and the composites of two headers.

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// Returns the model with names on the wire that tell the members of each struct and the
/// enumerators of each enum apart. One that the lock knows keeps its name there, wherever it is
/// declared now; of the others the first gets the name, and a later one a word more. What name()
/// says is left alone, also where it clashes. Headers whose composites would share names get
/// prefixes of their own (prefixes.h).
model::Model settled(const model::Model& model, const Locks& locks);

}  // namespace suture::compiler::lock
