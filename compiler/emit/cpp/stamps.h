#pragma once
// These emit the functions that turn the stamps in a slot from the sender's steady clock to the
// receiver's, since each machine has its own.

#include <string>
#include <vector>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"
#include "compiler/emit/wire/wire_form.h"

namespace suture::compiler::emit {

/// Tells if a slot of a fixed size has stamps. A slot that owns memory has none to shift, since it
/// is never received as bytes.
bool hasStamps(const model::Type& type, const model::Lookup& lookup);
bool hasStamps(const std::vector<WireValue>& values, const model::Lookup& lookup);

/// Emits "void shiftStamps(PoseStampedSlot& slot, suture::Duration shift)" for struct `slot`, which
/// holds `values`; nothing where there are no stamps. Any bytes may lie in the slot.
void declareShift(Code& code, const std::vector<WireValue>& values, const std::string& slot,
                  const Context& context);
void emitShift(Code& code, const std::vector<WireValue>& values, const std::string& slot,
               const Context& context);

/// Returns "suture::shiftSlot<PoseStampedSlot>" for such a struct; "" where there are no stamps.
std::string shiftOf(const std::string& slot, const std::vector<WireValue>& values,
                    const Context& context);
/// Does the same for a single value, which needs a function called `name` unless it is a struct.
std::string emitShiftOf(Code& code, const model::Type& type, const std::string& name,
                        const Context& context);

}  // namespace suture::compiler::emit
