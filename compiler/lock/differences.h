#pragma once
// Two versions of a schema, told apart in words.

#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// What peers of the two versions meet.
enum class Effect {
  None,      ///< nothing: they understand each other
  Refusals,  ///< they understand each other, and refuse some values
  Break      ///< they misread or miss something
};

struct Difference {
  Effect effect = Effect::None;
  std::string text;  ///< "field 'x' of struct Pose: unit \"mm\" instead of \"m\""
};

/// In the order of the old version's text, what is new behind it.
std::vector<Difference> differences(const Lock& old, const Lock& now);

}  // namespace suture::compiler::lock
