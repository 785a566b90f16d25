#include "compiler/emit/wire/encodings.h"

#include "compiler/emit/text/contract.h"

namespace suture::compiler::emit {
namespace {

std::string encodeSignature(const model::Struct& type) {
  return "Result<std::vector<std::byte>> encode(" + std::string(kBreakText) + "const " + type.name +
         "& value)";
}

std::string decodeSignature(const model::Struct& type) {
  return "Result<> decode(" + std::string(kBreakText) + "std::span<const std::byte> bytes, " +
         kBreakText + type.name + "& value)";
}

/// Returns the template arguments that name the wire form of the type and its slot:
/// "<reference::wire::PoseStamped, reference::PoseStampedSlot>".
std::string formsOf(const model::Struct& type, const Context& context) {
  const std::string& home = context.header.cxxNamespace;
  return "<" + home + "::wire::" + type.wireName + ", " + kBreakText +
         slotStruct(type.name, context.lookup) + ">";
}

}  // namespace

void declareEncodings(Code& code, const Context& context) {
  for (const model::Struct& type : context.header.structs) {
    code.line("template <>").line(encodeSignature(type), ";");
    code.line("template <>").line(decodeSignature(type), ";").blank();
  }
}

void emitEncodings(Code& code, const Context& context) {
  for (const model::Struct& type : context.header.structs) {
    const std::string forms = formsOf(type, context);
    code.line("template <>").open(encodeSignature(type), " {");
    code.line("return rpc::encodeAs", forms, "(value);").close("}").blank();
    code.line("template <>").open(decodeSignature(type), " {");
    code.line("return rpc::decodeAs", forms, "(bytes, value);").close("}").blank();
  }
}

}  // namespace suture::compiler::emit
