#include <algorithm>
#include <cmath>

#include "compiler/emit/cpp/files.h"
#include "compiler/emit/cpp/readers.h"
#include "compiler/emit/cpp/value_checks.h"
#include "compiler/emit/text/file_parts.h"
#include "compiler/emit/text/parts.h"
#include "compiler/emit/wire/codec.h"
#include "compiler/emit/wire/wire_form.h"
#include "compiler/emit/wire/wire_places.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

bool isInfinite(const std::optional<std::pair<double, double>>& range) {
  return range && (std::isinf(range->first) || std::isinf(range->second));
}

/// Tells if a bound of some value in the header is written as a constant of <limits>.
bool namesLimits(const Context& context) {
  const model::Header& header = context.header;
  const auto any = [](const auto& all, const auto& isIt) {
    return std::any_of(all.begin(), all.end(), isIt);
  };
  const auto byRange = [](const auto& one) { return isInfinite(one.range); };
  const auto ofCommand = [&](const model::Command& one) {
    return any(one.parameters, byRange) || isInfinite(one.resultRange);
  };
  return any(header.enums, hasLowestNumber) ||
         any(header.structs,
             [&](const model::Struct& one) { return any(fieldValues(one, context), byRange); }) ||
         any(header.interfaces, [&](const model::Interface& one) {
           return any(one.commands, ofCommand) || any(one.events, [&](const model::Event& event) {
                    return any(event.limits, byRange);
                  });
         });
}

void emitSourceIncludes(Code& code, const Context& context) {
  const model::Header& header = context.header;
  code.line("#include \"", model::stemOf(header.path), ".suture.h\"").blank();
  if (hasPackedFields(header)) includeAll(code, "base/slots/", {"packed_fields"});
  if (travels(header)) includeAll(code, "base/slots/", {"slots", "valid_values"});
  if (context.share == 0 && (!header.components.empty() || readsForOthers(context))) {
    includeAll(code, "component/factory/", {"json_reader"});
  }
  if (travels(header)) includeAll(code, "codec/", {"stamps"});
  code.blank();
  if (namesLimits(context)) code.line("#include <limits>");
  code.line("#include <type_traits>").blank();
}

void declareCodecs(Code& code, const Context& context) {
  const auto& interfaces = context.header.interfaces;
  if (interfaces.empty()) return;
  code.line("// Defined in ", model::stemOf(context.header.path), ".wire.cpp.");
  for (const model::Interface& one : interfaces) {
    code.line("const suture::codec::Codec& ", codecFunction(context, one), "();");
  }
  code.blank();
}

std::string sourceBody(const Context& context) {
  const std::string& home = context.header.cxxNamespace;
  Code code;
  inNamespace(code, home, [&](Code& inner) {
    Code body;
    hidden(body, [&](Code& part) { emitChecks(part, context); });
    emitSlotConversions(body, context);
    forEachInterface(body, context, emitArgumentConversions);
    emitTypeChecks(body, context);
    declareCodecs(body, context);
    hidden(body, [&](Code& part) {
      for (const model::Interface& one : context.header.interfaces) {
        emitWirePlaces(part, context, one);
        emitValueChecks(part, context, one);
        emitTables(part, context, one);
      }
    });
    const model::Header& header = context.header;
    const bool converts = !header.structs.empty() || !header.interfaces.empty();
    if (converts) emitUsings(inner, {"isValid", "load", "store"});
    inner.verbatim(body.text());
  });
  if (context.share == 0) emitReaders(code, context);
  inNamespace(code, "suture", [&](Code& inner) {
    forEachInterface(inner, context, emitInfo);
    forEachInterface(inner, context, emitReserved);
    forEachInterface(inner, context, emitExecute);
    emitClasses(inner, context);
  });
  return code.text();
}

}  // namespace

std::string sourceFile(const Context& context) {
  const std::string body = sourceBody(context);
  Code code;
  code.verbatim(banner(context.header));
  emitSourceIncludes(code, context);
  if (mentionsDeprecated(context)) ignoreDeprecation(code);
  code.verbatim(body);
  return code.finished();
}

}  // namespace suture::compiler::emit
