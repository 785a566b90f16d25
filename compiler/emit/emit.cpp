#include "compiler/emit/emit.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "compiler/emit/cpp/readers.h"
#include "compiler/emit/docs/page.h"
#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"
#include "compiler/emit/text/order.h"
#include "compiler/emit/text/parts.h"
#include "compiler/emit/wire/codec.h"
#include "compiler/emit/wire/converters.h"
#include "compiler/emit/wire/value_checks.h"
#include "compiler/emit/wire/wire_places.h"
#include "compiler/lock/contract_hash.h"
#include "compiler/lock/wire_contract.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

/// What every emitter of contracts does for each contract of the header.
template <class Part>
void forEachInterface(Code& code, const Context& context, const Part& part) {
  for (const model::Interface& one : context.header.interfaces) part(code, context, one);
}

/// What `emitParts` writes, in namespace `name`; nothing at all when it writes nothing.
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

/// The same in the unnamed namespace.
template <class EmitParts>
void hidden(Code& code, const EmitParts& emitParts) {
  Code inner;
  emitParts(inner);
  if (inner.text().empty()) return;
  code.line("namespace {").blank().verbatim(inner.text()).line("}  // namespace").blank();
}

/// True if slot_forms.h or generated code converts the type, false if that takes slots.h.
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

/// Does a user's code instantiate a conversion of lists, arrays or choices? Those of arguments, of
/// several values of an event and of types are functions of the generated source.
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

void includeAll(Code& code, const char* folder, std::initializer_list<const char*> names) {
  for (const char* const name : names) code.line("#include <suture/", folder, name, ".h>");
}

void emitHeaderIncludes(Code& code, const Context& context) {
  const bool contracts = !context.header.interfaces.empty();
  const auto& interfaces = context.header.interfaces;
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

/// Tells if the compiler would warn of what the user's headers mark as [[deprecated]].
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

std::string headerFile(const Context& context) {
  Code code;
  code.verbatim(banner(context.header)).line("#pragma once").blank();
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
    for (const model::Interface& one : context.header.interfaces) {
      inner.line("template <>");
      inner.line("const InterfaceInfo& interfaceInfo<", one.name, ">();").blank();
      emitRequired(inner, context, one);
      emitProvided(inner, context, one);
    }
    emitClassDeclarations(inner, context);
  });
  if (deprecated) code.verbatim("#pragma GCC diagnostic pop\n");
  return code.finished();
}

bool hasPackedFields(const model::Header& header) {
  const auto isPacked = [](const model::Field& field) { return field.isPacked; };
  return std::any_of(header.structs.begin(), header.structs.end(), [&](const model::Struct& one) {
    return std::any_of(one.fields.begin(), one.fields.end(), isPacked);
  });
}

void emitSourceIncludes(Code& code, const Context& context, bool converts, bool limits) {
  const model::Header& header = context.header;
  code.line("#include \"", model::stemOf(header.path), ".suture.h\"").blank();
  if (!header.components.empty() || readsForOthers(context)) {
    includeAll(code, "component/factory/", {"json_reader"});
  }
  if (!header.interfaces.empty()) {
    includeAll(code, "wire/", {"codec"});
  }
  if (converts) includeAll(code, "wire/", {"wire"});
  if (hasPackedFields(header)) includeAll(code, "base/slots/", {"packed_fields", "slots"});
  code.blank();
  if (limits) code.line("#include <limits>");
  code.line("#include <type_traits>").blank();
  if (converts) code.line("#include \"", model::stemOf(header.path), ".capnp.h\"").blank();
}

/// Emits using-declarations for the functions that the runtime overloads for its types, and the
/// header's namespace for its own: a call must find both.
void emitUsings(Code& code, const Context& context) {
  if (context.header.structs.empty() && context.header.interfaces.empty()) return;
  for (const char* const name : {"load", "rpc::fromWire", "rpc::isValid", "rpc::toWire", "store"}) {
    code.line("using suture::", name, ";");
  }
  code.blank();
}

/// True if anything of the header travels: then its schema has to be there.
bool converts(const Context& context) {
  const model::Header& header = context.header;
  return !header.interfaces.empty() || !header.enums.empty() || !header.structs.empty();
}

std::string sourceBody(const Context& context) {
  const std::string& home = context.header.cxxNamespace;
  Code code;
  emitForeignConverters(code, context);
  inNamespace(code, home, [&](Code& inner) {
    Code body;
    hidden(body, [&](Code& part) { emitChecks(part, context); });
    emitSlotConversions(body, context);
    forEachInterface(body, context, emitArgumentConversions);
    emitConverters(body, context);
    hidden(body, [&](Code& part) {
      for (const model::Interface& one : context.header.interfaces) {
        emitWirePlaces(part, context, one);
        emitValueChecks(part, context, one);
        emitCodec(part, context, one);
        emitTables(part, context, one);
      }
    });
    if (!body.text().empty()) emitUsings(inner, context);
    inner.verbatim(body.text());
  });
  emitReaders(code, context);
  inNamespace(code, "suture", [&](Code& inner) {
    forEachInterface(inner, context, emitInfo);
    forEachInterface(inner, context, emitReserved);
    forEachInterface(inner, context, emitExecute);
    emitClasses(inner, context);
  });
  return code.text();
}

std::string sourceFile(const Context& context) {
  const std::string body = sourceBody(context);
  Code code;
  code.verbatim(banner(context.header));
  emitSourceIncludes(code, context, converts(context),
                     body.find("std::numeric_limits") != body.npos);
  if (mentionsDeprecated(context)) ignoreDeprecation(code);
  code.verbatim(body);
  return code.finished();
}

}  // namespace

std::vector<Artefact> emit(const model::Model& declared, const lock::Locks& locks) {
  const model::Model model = ordered(declared, locks);
  const model::Lookup lookup(model);
  const std::map<std::string, lock::Lock> schemas = lock::upToDate(model, locks);
  const std::map<std::string, std::string> hashes = lock::contractHashes(model, schemas);
  const std::map<std::string, std::string> cores = lock::coreHashes(model, schemas);
  std::vector<Artefact> artefacts;
  for (const model::Header& header : model.headers) {
    if (!header.own) continue;
    const Context context{model, lookup, locks, schemas, hashes, cores, header};
    const std::string stem = model::stemOf(header.path);
    artefacts.push_back({stem + ".suture.h", headerFile(context)});
    artefacts.push_back({stem + ".suture.cpp", sourceFile(context)});
    artefacts.push_back({stem + ".suture.json", emitJson(context)});
    artefacts.push_back({stem + ".suture.md", emitPage(context)});
  }
  return artefacts;
}

}  // namespace suture::compiler::emit
