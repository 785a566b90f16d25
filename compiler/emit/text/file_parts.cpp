#include "compiler/emit/text/file_parts.h"

#include <algorithm>

namespace suture::compiler::emit {

void emitUsings(Code& code, std::initializer_list<const char*> names) {
  for (const char* const name : names) code.line("using suture::", name, ";");
  code.blank();
}

bool travels(const model::Header& header) {
  return !header.interfaces.empty() || !header.enums.empty() || !header.structs.empty();
}

bool hasPackedFields(const model::Header& header) {
  const auto isPacked = [](const model::Field& field) { return field.isPacked; };
  return std::any_of(header.structs.begin(), header.structs.end(), [&](const model::Struct& one) {
    return std::any_of(one.fields.begin(), one.fields.end(), isPacked);
  });
}

void includeAll(Code& code, const char* folder, std::initializer_list<const char*> names) {
  for (const char* const name : names) code.line("#include <suture/", folder, name, ".h>");
}

bool mentionsDeprecated(const Context& context) {
  const auto& imports = context.header.imports;
  const auto& headers = context.model.headers;
  return context.header.hasDeprecated ||
         std::any_of(headers.begin(), headers.end(), [&](const model::Header& one) {
           const bool imported =
               std::find(imports.begin(), imports.end(), one.path) != imports.end();
           return one.hasDeprecated && imported;
         });
}

void ignoreDeprecation(Code& code) {
  code.line("// What is deprecated travels all the same.");
  code.verbatim("#pragma GCC diagnostic ignored \"-Wdeprecated-declarations\"\n").blank();
}

}  // namespace suture::compiler::emit
