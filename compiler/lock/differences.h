#pragma once
// Two versions of a schema, told apart in words.

#include <string>
#include <vector>

#include "compiler/lock/lock.h"

namespace suture::compiler::lock {

struct Difference {
  bool breaks = false;  ///< peers of the old version misread or miss something
  std::string text;     ///< "field 'x' of struct Pose: unit \"mm\" instead of \"m\""
};

/// In the order of the old version's text, what is new behind it.
std::vector<Difference> differences(const Lock& old, const Lock& now);

}  // namespace suture::compiler::lock
