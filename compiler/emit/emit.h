#pragma once
// From the checked model to the text of every generated file.

#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/model/artefact.h"
#include "compiler/model/model.h"

namespace suture::compiler::emit {

using model::Artefact;

/// What is generated from the model's own headers: for "arm/arm.h" the files "arm/arm.suture.h",
/// "arm/arm.suture.cpp", "arm/arm.suture.json" and "arm/arm.suture.md", in this order, header after
/// header. Foreign headers (own = false) serve as declarations only. The model must have passed
/// check/ and lock::check: nothing is verified again here. Equal input gives equal bytes.
std::vector<Artefact> emit(const model::Model& model, const lock::Locks& locks);

}  // namespace suture::compiler::emit
