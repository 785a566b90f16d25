#pragma once
// The two versions of the header have these functions for their own Sample and Choice.

#include <ostream>

#include "evolution/choice.suture.h"
#include "evolution/sample.suture.h"

namespace evolution {

/// Returns a sample in which every field has a value of its own.
Sample example();

/// Prints the fields that the two versions do not share.
void print(const Sample& sample, std::ostream& out);

/// Returns a choice that holds the newest alternative of this version, or one that both versions
/// have.
Choice exampleChoice(bool newest);

void print(const Choice& choice, std::ostream& out);

}  // namespace evolution
