#include <algorithm>
#include <cmath>

#include "compiler/emit/cpp/file_parts.h"
#include "compiler/emit/cpp/files.h"
#include "compiler/emit/cpp/readers.h"
#include "compiler/emit/text/parts.h"
#include "compiler/emit/wire/codec.h"
#include "compiler/emit/wire/converters.h"
#include "compiler/emit/wire/encodings.h"
#include "compiler/emit/wire/value_checks.h"
#include "compiler/emit/wire/wire_form.h"
#include "compiler/emit/wire/wire_places.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

/// Puts what `emitParts` writes into the unnamed namespace, and emits nothing if it writes nothing.
template <class EmitParts>
void hidden(Code& code, const EmitParts& emitParts) {
  Code inner;
  emitParts(inner);
  if (inner.text().empty()) return;
  code.line("namespace {").blank().verbatim(inner.text()).line("}  // namespace").blank();
}

bool hasPackedFields(const model::Header& header) {
  const auto isPacked = [](const model::Field& field) { return field.isPacked; };
  return std::any_of(header.structs.begin(), header.structs.end(), [&](const model::Struct& one) {
    return std::any_of(one.fields.begin(), one.fields.end(), isPacked);
  });
}

bool isInfinite(const std::optional<std::pair<double, double>>& range) {
  return range && (std::isinf(range->first) || std::isinf(range->second));
}

/// True if a bound that some value of the header has is a constant of <limits>.
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

void emitSourceIncludes(Code& code, const Context& context, bool converts) {
  const model::Header& header = context.header;
  code.line("#include \"", model::stemOf(header.path), ".suture.h\"").blank();
  if (!header.components.empty() || readsForOthers(context)) {
    includeAll(code, "component/factory/", {"json_reader"});
  }
  if (!header.interfaces.empty()) {
    includeAll(code, "wire/", {"codec"});
  }
  if (!header.structs.empty()) includeAll(code, "wire/", {"flat"});
  if (converts) includeAll(code, "wire/", {"wire"});
  if (hasPackedFields(header)) includeAll(code, "base/slots/", {"packed_fields", "slots"});
  code.blank();
  if (namesLimits(context)) code.line("#include <limits>");
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

/// Returns true if anything of the header travels: then its schema has to be there.
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
    emitEncodings(inner, context);
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
  emitSourceIncludes(code, context, converts(context));
  if (mentionsDeprecated(context)) ignoreDeprecation(code);
  code.verbatim(body);
  return code.finished();
}

}  // namespace suture::compiler::emit
