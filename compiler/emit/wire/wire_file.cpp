#include "compiler/emit/wire/wire_file.h"

#include <set>
#include <string>

#include "compiler/emit/text/file_parts.h"
#include "compiler/emit/text/share.h"
#include "compiler/emit/wire/codec.h"
#include "compiler/emit/wire/converters.h"
#include "compiler/emit/wire/encodings.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

/// Names the files of capnp that declare what this source converts.
std::set<std::string> schemasFor(const Context& context) {
  if (context.parts == nullptr) return {lock::lockPath(context.header.path)};
  std::set<std::string> schemas;
  for (const std::string& node : nodesOf(context.header)) {
    if (std::string file = context.parts->fileOf(node); !file.empty()) schemas.insert(file);
  }
  return schemas;
}

void emitIncludes(Code& code, const Context& context) {
  const model::Header& header = context.header;
  const std::string stem = model::stemOf(header.path);
  if (hasPackedFields(header)) includeAll(code, "base/slots/", {"packed_fields"});
  if (!header.interfaces.empty()) includeAll(code, "codec/", {"codec"});
  if (!header.structs.empty()) includeAll(code, "codec/", {"flat"});
  includeAll(code, "codec/", {"wire"});
  code.blank();
  for (const std::string& schema : schemasFor(context)) code.line("#include \"", schema, ".h\"");
  code.line("#include \"", stem, ".suture.h\"").blank();
}

}  // namespace

std::string wireFile(const Context& context) {
  Code code;
  code.verbatim(banner(context.header));
  if (!travels(context.header)) {
    return code.line("// It declares nothing that travels.").finished();
  }
  emitIncludes(code, context);
  if (mentionsDeprecated(context)) ignoreDeprecation(code);
  emitForeignConverters(code, context);
  inNamespace(code, context.header.cxxNamespace, [&](Code& inner) {
    emitUsings(inner, {"codec::fromWire", "codec::toWire"});
    emitConverters(inner, context);
    forEachInterface(inner, context, emitCodec);
  });
  inNamespace(code, "suture", [&](Code& inner) { emitEncodings(inner, context); });
  return code.finished();
}

}  // namespace suture::compiler::emit
