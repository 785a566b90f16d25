#include "compiler/emit/wire/encodings.h"

#include "compiler/emit/text/contract.h"

namespace suture::compiler::emit {
namespace {

/// Names the type as within namespace suture.
std::string nameOf(const model::Struct& type, const Context& context) {
  return rooted(type.name, namespaceOf(type, context));
}

std::string encodeSignature(const model::Struct& type, const Context& context) {
  return "Result<std::vector<std::byte>> encode(" + std::string(kBreakText) + "const " +
         nameOf(type, context) + "& value)";
}

std::string decodeSignature(const model::Struct& type, const Context& context) {
  return "Result<> decode(" + std::string(kBreakText) + "std::span<const std::byte> bytes, " +
         kBreakText + nameOf(type, context) + "& value)";
}

/// Returns the template arguments that name the wire form of the type and its slot:
/// "<reference::wire::PoseStamped, reference::PoseStampedSlot>".
std::string formsOf(const model::Struct& type, const Context& context) {
  const std::string& home = context.header.cxxNamespace;
  return "<" + home + "::wire::" + type.wireName + ", " + kBreakText +
         rooted(slotStruct(type.name, context.lookup)) + ">";
}

}  // namespace

void declareEncodings(Code& code, const Context& context) {
  for (const model::Struct& type : context.header.structs) {
    code.line("template <>").line(encodeSignature(type, context), ";");
    code.line("template <>").line(decodeSignature(type, context), ";").blank();
  }
}

void emitEncodings(Code& code, const Context& context) {
  for (const model::Struct& type : context.header.structs) {
    const std::string forms = formsOf(type, context);
    code.line("template <>").open(encodeSignature(type, context), " {");
    code.line("return codec::encodeAs", forms, "(value);").close("}").blank();
    code.line("template <>").open(decodeSignature(type, context), " {");
    code.line("return codec::decodeAs", forms, "(bytes, value);").close("}").blank();
  }
}

}  // namespace suture::compiler::emit
