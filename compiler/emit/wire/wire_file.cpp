#include "compiler/emit/wire/wire_file.h"

#include "compiler/emit/text/file_parts.h"
#include "compiler/emit/wire/codec.h"
#include "compiler/emit/wire/converters.h"
#include "compiler/emit/wire/encodings.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

void emitIncludes(Code& code, const model::Header& header) {
  const std::string stem = model::stemOf(header.path);
  if (hasPackedFields(header)) includeAll(code, "base/slots/", {"packed_fields"});
  if (!header.interfaces.empty()) includeAll(code, "wire/", {"codec"});
  if (!header.structs.empty()) includeAll(code, "wire/", {"flat"});
  includeAll(code, "wire/", {"wire"});
  code.blank();
  code.line("#include \"", stem, ".capnp.h\"").line("#include \"", stem, ".suture.h\"").blank();
}

}  // namespace

std::string wireFile(const Context& context) {
  Code code;
  code.verbatim(banner(context.header));
  if (!travels(context.header)) {
    return code.line("// It declares nothing that travels.").finished();
  }
  emitIncludes(code, context.header);
  if (mentionsDeprecated(context)) ignoreDeprecation(code);
  emitForeignConverters(code, context);
  inNamespace(code, context.header.cxxNamespace, [&](Code& inner) {
    emitUsings(inner, {"rpc::fromWire", "rpc::toWire"});
    emitConverters(inner, context);
    forEachInterface(inner, context, emitCodec);
  });
  inNamespace(code, "suture", [&](Code& inner) { emitEncodings(inner, context); });
  return code.finished();
}

}  // namespace suture::compiler::emit
