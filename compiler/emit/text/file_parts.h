#pragma once
// Generated headers and sources share these parts.

#include <initializer_list>
#include <string>
#include <string_view>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Calls `part`, an emitter of contracts, for each contract of the header.
template <class Part>
void forEachInterface(Code& code, const Context& context, const Part& part) {
  for (const model::Interface& one : context.header.interfaces) part(code, context, one);
}

/// Puts what `emitParts` writes into namespace `name`, and emits nothing if it writes nothing.
template <class EmitParts>
void inNamespace(Code& code, const std::string& name, const EmitParts& emitParts) {
  Code inner;
  emitParts(inner);
  if (inner.text().empty()) return;
  // An unnamed namespace right inside shares the lines of the named one.
  const std::string text = inner.text();
  constexpr std::string_view kInnerEnd = "}  // namespace\n\n";
  code.verbatim(openNamespace(name));
  if (!text.starts_with("namespace {")) code.blank();
  code.verbatim(text.substr(0, text.size() - (text.ends_with(kInnerEnd) ? 1 : 0)));
  code.verbatim(closeNamespace(name)).blank();
}

/// Puts what `emitParts` writes into the unnamed namespace, and emits nothing if it writes nothing.
template <class EmitParts>
void hidden(Code& code, const EmitParts& emitParts) {
  Code inner;
  emitParts(inner);
  if (inner.text().empty()) return;
  code.line("namespace {").blank().verbatim(inner.text()).line("}  // namespace").blank();
}

/// Emits using-declarations of what the runtime overloads for its types, and the header's namespace
/// for its own: a call must find both.
void emitUsings(Code& code, std::initializer_list<const char*> names);

/// Tells if anything of the header travels: then its schema has to be there.
bool travels(const model::Header& header);
bool hasPackedFields(const model::Header& header);

/// Includes <suture/FOLDER/NAME.h> for each name.
void includeAll(Code& code, const char* folder, std::initializer_list<const char*> names);

/// Tells if the compiler would warn of what the user's headers mark as [[deprecated]].
bool mentionsDeprecated(const Context& context);
void ignoreDeprecation(Code& code);

}  // namespace suture::compiler::emit
