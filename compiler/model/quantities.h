#pragma once
// Here it stands for which types unit() and range() mean something.

#include "compiler/model/type.h"

namespace suture::compiler::model {

/// Tells if range() means something: the type is, or is a container of, plain numbers. Of a map the
/// values count, not the keys.
bool holdsNumbers(const Type& type);

/// Tells if unit() means something: the type holds plain numbers, or a transform, whose translation
/// has the unit.
bool holdsQuantities(const Type& type);

}  // namespace suture::compiler::model
