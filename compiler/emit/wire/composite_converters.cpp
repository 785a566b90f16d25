#include "compiler/emit/wire/composite_converters.h"

#include <algorithm>
#include <vector>

#include "compiler/emit/wire/wire_form.h"
#include "compiler/lock/schema/composites.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

using model::Type;
using Shape = Type::Shape;

/// Says where the element of that number lies in the slot.
std::string place(const Type& type, std::size_t index, const model::Lookup& lookup) {
  const std::string number = std::to_string(index);
  switch (type.shape) {
    case Shape::Optional: return holdsRecursive(type, lookup) ? "*slot.value" : "slot.value";
    case Shape::Map: return index == 0 ? "slot.key" : "slot.value";
    case Shape::Variant: return "suture::alternative<" + number + ">(slot)";
    default: return "suture::item<" + number + ">(slot)";
  }
}

std::vector<WireValue> valuesOf(const Type& type, const Context& context) {
  const std::vector<std::string> names =
      lock::compositeMembers(type, context.lookup, context.header);
  std::vector<WireValue> values;
  for (std::size_t i = 0; i < type.element.size(); ++i) {
    values.push_back({type.element[i], names[i], place(type, i, context.lookup), {}});
  }
  return values;
}

void emitEncoder(Code& code, const Type& type, const std::vector<WireValue>& values,
                 const Context& context) {
  if (type.shape == Shape::Optional) code.line("if (slot.present == 0) return out.setNone();");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string statement = encode(values[i], "out", context) + ";";
    if (type.shape == Shape::Variant) {
      code.line("if (slot.index == ", std::to_string(i), ") return ", statement);
    } else {
      code.line(statement);
    }
  }
}

void emitAlternative(Code& code, const WireValue& value, std::size_t index,
                     const Context& context) {
  code.open("if (in.is", model::titleCase(value.wireName), "()) {");
  code.line("slot.index = ", std::to_string(index), ";");
  emitDecodeAndReturn(code, {value}, "in", "shift", context);
  code.close("}");
}

void emitDecoder(Code& code, const Type& type, const std::vector<WireValue>& values,
                 const Context& context) {
  if (type.shape == Shape::Variant) {
    for (std::size_t i = 0; i < values.size(); ++i) emitAlternative(code, values[i], i, context);
    code.line("return suture::Errc::Invalid;");
    return;
  }
  if (type.shape == Shape::Optional) {
    code.line("if (in.isNone()) return slot.present = 0, suture::Errc{};");
    code.line("if (!in.isSome()) return suture::Errc::Invalid;");
    code.line(holdsRecursive(type, context.lookup) ? "engage(slot);" : "slot.present = 1;");
  }
  emitDecodeAndReturn(code, values, "in", "shift", context);
}

}  // namespace

void CompositeConverters::emit(Code& code, const Type& type) {
  lock::forEachComposite(type, [&](const Type& one) {
    if (one.shape != Shape::AnyMatrix) emitOne(code, one);  // the runtime has those
  });
}

void CompositeConverters::emitOne(Code& code, const Type& type) {
  const std::string& home = context_.header.cxxNamespace;
  const std::string slot =
      type.shape == Shape::Map ? elementSlot(type, context_, home) : slotType(type, context_, home);
  const std::string wire = "wire::" + lock::compositeName(type, context_.lookup, context_.header);
  if (!done_.insert(slot + " as " + wire).second) return;
  const std::vector<WireValue> values = valuesOf(type, context_);
  code.open("static void toWire(const ", slot, "& slot, ", std::string(1, kBreak), wire,
            "::Builder out) {");
  emitEncoder(code, type, values, context_);
  code.close("}").blank();
  const bool shift = std::any_of(values.begin(), values.end(),
                                 [](const WireValue& value) { return usesShift(value.type); });
  code.open("static suture::Errc fromWire(", wire, "::Reader in, ", std::string(1, kBreak), slot,
            "& slot, ", std::string(1, kBreak), "suture::Duration", shift ? " shift" : "", ") {");
  emitDecoder(code, type, values, context_);
  code.close("}").blank();
}

}  // namespace suture::compiler::emit
