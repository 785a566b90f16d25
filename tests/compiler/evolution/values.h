#pragma once
// What each version says of its own Sample.

#include <ostream>

#include "evolution/sample.suture.h"

namespace evolution {

/// A sample in which every field has a value of its own.
Sample example();

/// The fields that the two versions do not share.
void print(const Sample& sample, std::ostream& out);

}  // namespace evolution
