#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/parts.h"

namespace suture::compiler::emit {
namespace {

void emitEnum(Code& code, const model::Enum& declaration, const std::string& home) {
  const std::string name = relative(declaration.name, home);
  const std::string underlying = cxxScalar(declaration.underlying);
  code.line("static_assert(std::is_same_v<std::underlying_type_t<", name, ">, ",
            declaration.underlyingType, ">);");
  for (const model::Enumerator& enumerator : declaration.enumerators) {
    code.line("static_assert(static_cast<", underlying, ">(", name, "::", enumerator.name,
              ") == ", valueLiteral(declaration, enumerator), ");");
  }
}

void emitStruct(Code& code, const model::Struct& declaration, const std::string& home) {
  const std::string name = relative(declaration.name, home);
  for (const model::Field& field : declaration.fields) {
    const std::string type = cxxType(field.type, home);
    if (field.isBase) {
      code.line("static_assert(std::is_base_of_v<", type, ", ", kBreakText, name, ">);");
    } else if (field.isHidden) {
      const std::string hidden =
          access(declaration, field, "std::declval<" + name + "&>()", false, home);
      code.line("static_assert(std::is_same_v<decltype(", hidden, "), ", kBreakText, type, "&>);");
    } else {
      code.line("static_assert(std::is_same_v<decltype(", name, "::", field.name, "), ", kBreakText,
                type, ">);");
    }
  }
}

}  // namespace

void emitChecks(Code& code, const Context& context) {
  const model::Header& header = context.header;
  if (header.enums.empty() && header.structs.empty()) return;
  code.line("// What this compiler sees must be what suturec read.");
  for (const model::Enum& one : header.enums) emitEnum(code, one, header.cxxNamespace);
  for (const model::Struct& one : header.structs) emitStruct(code, one, header.cxxNamespace);
  code.blank();
}

}  // namespace suture::compiler::emit
