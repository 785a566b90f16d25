#pragma once
// This emits which parts of a slot need not be copied, since large lists, texts and matrices are
// seldom full.

#include <string>
#include <vector>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"
#include "compiler/emit/wire/wire_form.h"

namespace suture::compiler::emit {

/// Emits "constexpr BoundedLevel kArmShowArgumentsLevels[]", called `name`, for the slot of type
/// `slot` with these values in it. Returns the name; "" if the slot has no such parts.
std::string emitLevels(Code& code, const std::string& name, const std::string& slot,
                       const std::vector<WireValue>& values, const Context& context);

}  // namespace suture::compiler::emit
