#pragma once
// Each version says this of its own Sample.

#include <ostream>

#include "evolution/choice.suture.h"
#include "evolution/sample.suture.h"

namespace evolution {

/// Returns a sample in which every field has a value of its own.
Sample example();

/// Prints the fields that the two versions do not share.
void print(const Sample& sample, std::ostream& out);

/// Returns a choice of something that both versions have, or of the newest that this one has.
Choice exampleChoice(bool newest);

void print(const Choice& choice, std::ostream& out);

}  // namespace evolution
