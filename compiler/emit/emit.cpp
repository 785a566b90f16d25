#include "compiler/emit/emit.h"

#include <algorithm>
#include <utility>

#include "compiler/emit/code.h"
#include "compiler/emit/context.h"
#include "compiler/emit/parts.h"
#include "compiler/emit/readers.h"
#include "compiler/lock/contract_hash.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

/// What every emitter of contracts does for each contract of the header.
template <class Part>
void forEachInterface(Code& code, const Context& context, const Part& part) {
  for (const model::Interface& one : context.header.interfaces) part(code, context, one);
}

bool hasSlots(const Context& context) {
  const auto& structs = context.header.structs;
  return std::any_of(structs.begin(), structs.end(), [&](const model::Struct& declaration) {
    return isBounded(declaration, context.lookup);
  });
}

/// What `emitParts` writes, in namespace `name`; nothing at all when it writes nothing.
template <class EmitParts>
void inNamespace(Code& code, const std::string& name, const EmitParts& emitParts) {
  Code inner;
  emitParts(inner);
  if (inner.text().empty()) return;
  code.verbatim(openNamespace(name)).blank().verbatim(inner.text());
  code.verbatim(closeNamespace(name)).blank();
}

/// The same in the unnamed namespace within `name`.
template <class EmitParts>
void inHiddenNamespace(Code& code, const std::string& name, const EmitParts& emitParts) {
  Code inner;
  emitParts(inner);
  if (inner.text().empty()) return;
  code.verbatim(openNamespace(name)).line("namespace {").blank().verbatim(inner.text());
  code.line("}  // namespace").verbatim(closeNamespace(name)).blank();
}

void emitHeaderIncludes(Code& code, const Context& context) {
  const bool contracts = !context.header.interfaces.empty();
  if (contracts || hasSlots(context)) code.line("#include <suture/base/slots.h>");
  if (contracts) code.line("#include <suture/component/commands.h>");
  if (!context.header.components.empty())
    code.line("#include <suture/component/component_class.h>");
  if (contracts) {
    for (const char* const name : {"events", "provided", "required"}) {
      code.line("#include <suture/component/", name, ".h>");
    }
  }
  code.blank().line("#include \"", context.header.path, "\"");
  for (const std::string& path : context.header.imports) {
    code.line("#include \"", model::stemOf(path), ".suture.h\"");
  }
  code.blank();
}

std::string headerFile(const Context& context) {
  Code code;
  code.verbatim(banner(context.header)).line("#pragma once").blank();
  emitHeaderIncludes(code, context);
  if (hasReaders(context.header)) {
    code.line("namespace suture {").line("class JsonReader;").line("}").blank();
  }
  inNamespace(code, context.header.cxxNamespace, [&](Code& inner) {
    emitSlots(inner, context);
    forEachInterface(inner, context, emitArguments);
    emitReaderDeclarations(inner, context);
  });
  inNamespace(code, "suture", [&](Code& inner) {
    for (const model::Interface& one : context.header.interfaces) {
      inner.line("template <>");
      inner.line("const InterfaceInfo& interfaceInfo<", one.name, ">();").blank();
      emitRequired(inner, context, one);
      emitProvided(inner, context, one);
    }
    emitClassDeclarations(inner, context);
  });
  return code.finished();
}

std::string sourceFile(const Context& context) {
  Code code;
  code.verbatim(banner(context.header));
  code.line("#include \"", model::stemOf(context.header.path), ".suture.h\"").blank();
  if (!context.header.components.empty())
    code.line("#include <suture/component/json_reader.h>").blank();
  code.line("#include <type_traits>").blank();
  inHiddenNamespace(code, context.header.cxxNamespace, [&](Code& inner) {
    emitChecks(inner, context);
    forEachInterface(inner, context, emitTables);
  });
  emitReaders(code, context);
  inNamespace(code, "suture", [&](Code& inner) {
    forEachInterface(inner, context, emitInfo);
    forEachInterface(inner, context, emitExecute);
    emitClasses(inner, context);
  });
  return code.finished();
}

}  // namespace

std::vector<Artefact> emit(const model::Model& model, const lock::Locks& locks) {
  const model::Lookup lookup(model);
  const std::map<std::string, std::string> hashes = lock::contractHashes(model, locks);
  std::vector<Artefact> artefacts;
  for (const model::Header& header : model.headers) {
    if (!header.own) continue;
    const Context context{model, lookup, locks, hashes, header};
    const std::string stem = model::stemOf(header.path);
    artefacts.push_back({stem + ".suture.h", headerFile(context)});
    artefacts.push_back({stem + ".suture.cpp", sourceFile(context)});
    artefacts.push_back({stem + ".suture.json", emitJson(context)});
  }
  return artefacts;
}

}  // namespace suture::compiler::emit
