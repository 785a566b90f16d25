#pragma once
// What each version says of its own Sample.

#include <ostream>

#include "evolution/choice.suture.h"
#include "evolution/sample.suture.h"

namespace evolution {

/// A sample in which every field has a value of its own.
Sample example();

/// The fields that the two versions do not share.
void print(const Sample& sample, std::ostream& out);

/// A choice of something that both versions have, or of the newest that this one has.
Choice exampleChoice(bool newest);

void print(const Choice& choice, std::ostream& out);

}  // namespace evolution
