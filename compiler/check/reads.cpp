#include "compiler/check/rules.h"
#include "compiler/check/type_tree.h"

namespace suture::compiler::check {

void checkReads(const model::Header& header, const model::Lookup& lookup,
                model::Diagnostics& findings) {
  for (const model::Interface& interface : header.interfaces) {
    for (const model::Command& command : interface.commands) {
      if (command.kind != model::CommandKind::Read || !command.result) continue;
      if (command.resultByReference || !ownsHeap(*command.result, lookup)) continue;
      addError(findings, command.source, "heap-read-by-value",
               "read '" + command.name + "' returns '" + command.result->spelling +
                   "', which owns heap, by value; it would allocate in the provider's cycle",
               "return 'const " + command.result->spelling + "&'");
    }
  }
}

}  // namespace suture::compiler::check
