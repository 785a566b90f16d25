#include "compiler/check/rules.h"

namespace suture::compiler::check {
namespace {

/// Tells if default-range refuses the field, because 0 is what counts for it.
bool excludesZero(const model::Field& field) {
  return field.range && (field.range->first > 0 || field.range->second < 0);
}

void warn(const model::Field& field, model::Diagnostics& findings) {
  const model::Unset& unset = *field.unset;
  model::Diagnostic& finding =
      addError(findings, field.source, "no-initialiser",
               "nothing initialises field '" + field.name +
                   "'; until it is set, whatever its memory held goes on the wire",
               "initialise it where it is declared" +
                   (unset.setting.empty() ? "" : ", with '" + unset.setting + "'"));
  finding.severity = model::Diagnostic::Severity::Warning;
  if (unset.fix) finding.fixes = {*unset.fix};
}

}  // namespace

void checkInitialisers(const model::Header& header, model::Diagnostics& findings) {
  for (const model::Struct& type : header.structs) {
    for (const model::Field& field : type.fields) {
      if (field.unset && !excludesZero(field)) warn(field, findings);
    }
  }
}

}  // namespace suture::compiler::check
