#pragma once
// This checks what the wire, the runtime and Cap'n Proto demand of a model beyond what its C++
// types can say.

#include "compiler/model/diagnostic.h"
#include "compiler/model/model.h"

namespace suture::compiler::check {

/// Judges the own headers; foreign ones were judged with their target. Findings come rule by rule
/// for each header, and within a rule in the order of the header's text. It works on any model,
/// also one that no compiler produced.
model::Diagnostics check(const model::Model& model);

}  // namespace suture::compiler::check
