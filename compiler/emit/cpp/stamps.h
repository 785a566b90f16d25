#pragma once
// Emits the functions that turn the steady stamps in a slot into the receiver's, since a point in
// time of a steady clock means another thing in each process.

#include <string>
#include <vector>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"
#include "compiler/emit/wire/wire_form.h"

namespace suture::compiler::emit {

/// Returns true if a slot of a fixed size has any. A slot that owns memory is never received as
/// bytes.
bool hasStamps(const model::Type& type, const model::Lookup& lookup);
bool hasStamps(const std::vector<WireValue>& values, const model::Lookup& lookup);

/// Emits "void shiftStamps(PoseStampedSlot& slot, suture::Duration shift)" for struct `slot`, which
/// holds `values`; nothing where there are no stamps. Any bytes may lie in the slot.
void declareShift(Code& code, const std::vector<WireValue>& values, const std::string& slot,
                  const Context& context);
void emitShift(Code& code, const std::vector<WireValue>& values, const std::string& slot,
               const Context& context);

/// Returns how shiftSlot() is spelled for such a struct; "" where there are no stamps.
std::string shiftOf(const std::string& slot, const std::vector<WireValue>& values,
                    const Context& context);
/// Does the same for a single value, which needs a function called `name` unless it is a struct.
std::string emitShiftOf(Code& code, const model::Type& type, const std::string& name,
                        const Context& context);

}  // namespace suture::compiler::emit
