#include <algorithm>

#include "compiler/emit/cpp/files.h"
#include "compiler/emit/cpp/readers.h"
#include "compiler/emit/text/file_parts.h"
#include "compiler/emit/text/parts.h"
#include "compiler/emit/wire/encodings.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

/// Returns true if slot_forms.h or generated code converts the type, false if that takes slots.h.
bool convertsItself(const model::Type& type) {
  using Shape = model::Type::Shape;
  switch (type.shape) {
    case Shape::Scalar:
    case Shape::Enum:
    case Shape::Text:
    case Shape::Duration:
    case Shape::TimePoint:
    case Shape::Struct: return true;
    default: return false;
  }
}

/// Tells if a user's code instantiates a conversion of lists, arrays or choices. Conversions of
/// arguments, of several values of an event and of types are functions of the generated source.
bool instantiatesConversions(const model::Interface& interface) {
  const auto result = [](const model::Command& command) {
    return command.result && !convertsItself(*command.result);
  };
  const auto payload = [](const model::Event& event) {
    return event.payload.size() == 1 && !convertsItself(event.payload[0]);
  };
  return std::any_of(interface.commands.begin(), interface.commands.end(), result) ||
         std::any_of(interface.events.begin(), interface.events.end(), payload);
}

void emitHeaderIncludes(Code& code, const Context& context) {
  const bool contracts = !context.header.interfaces.empty();
  const auto& interfaces = context.header.interfaces;
  if (!context.header.structs.empty()) includeAll(code, "base/", {"encoding"});
  if (std::any_of(interfaces.begin(), interfaces.end(), instantiatesConversions)) {
    code.line("#include <suture/base/slots/slots.h>");
  } else if (contracts || !context.header.structs.empty()) {
    code.line("#include <suture/base/slots/slot_forms.h>");
  }
  if (contracts) includeAll(code, "component/", {"commands", "events"});
  if (!context.header.components.empty())
    includeAll(code, "component/factory/", {"component_class"});
  if (contracts) includeAll(code, "component/", {"provided", "required"});
  code.blank().line("#include \"", context.header.path, "\"");
  for (const std::string& path : context.header.imports) {
    code.line("#include \"", model::stemOf(path), ".suture.h\"");
  }
  code.blank();
}

/// Emits the comment that leads a reader past the slots to the classes that a program uses.
void emitGuide(Code& code, const Context& context) {
  if (context.header.interfaces.empty()) return;
  const std::string stem = model::stemOf(context.header.path);
  code.line("//");
  code.line(
      "// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below");
  code.line("// the slots, in which arguments wait. ", stem.substr(stem.rfind('/') + 1),
            ".suture.md has the reference.");
}

}  // namespace

std::string headerFile(const Context& context) {
  Code code;
  code.verbatim(banner(context.header));
  emitGuide(code, context);
  code.line("#pragma once").blank();
  emitHeaderIncludes(code, context);
  const bool deprecated = mentionsDeprecated(context);
  if (deprecated) code.verbatim("#pragma GCC diagnostic push\n");
  if (deprecated) ignoreDeprecation(code);
  if (hasReaders(context.header)) {
    code.line("namespace suture {").line("class JsonReader;").line("}").blank();
  }
  inNamespace(code, "suture", [&](Code& inner) { emitMembers(inner, context); });
  inNamespace(code, context.header.cxxNamespace, [&](Code& inner) {
    emitSlots(inner, context);
    forEachInterface(inner, context, emitArguments);
    emitReaderDeclarations(inner, context, context.header.cxxNamespace);
  });
  for (const std::string& home : readerNamespaces(context)) {
    if (home == context.header.cxxNamespace) continue;
    inNamespace(code, home, [&](Code& inner) { emitReaderDeclarations(inner, context, home); });
  }
  inNamespace(code, "suture", [&](Code& inner) {
    declareEncodings(inner, context);
    for (const model::Interface& one : context.header.interfaces) {
      inner.line("template <>");
      inner.line("const InterfaceInfo& interfaceInfo<", rooted(one.name), ">();").blank();
      emitRequired(inner, context, one);
      emitProvided(inner, context, one);
    }
    emitClassDeclarations(inner, context);
  });
  if (deprecated) code.verbatim("#pragma GCC diagnostic pop\n");
  return code.finished();
}

}  // namespace suture::compiler::emit
