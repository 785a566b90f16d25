#include <algorithm>

#include "compiler/check/rules.h"

namespace suture::compiler::check {
namespace {

/// Tells if the range excludes 0, the default that a field without an initialiser has in the
/// schema. The rule default-range refuses such a field already.
bool excludesZero(const model::Field& field) {
  return field.range && (field.range->first > 0 || field.range->second < 0);
}

/// Tells if a field of this type that nothing initialises holds what its memory held. Returns false
/// for a struct that can be edited, because that is reported where the struct is declared.
bool isRaw(const model::Type& type, const model::Lookup& lookup) {
  if (type.shape == model::Type::Shape::Array) return isRaw(type.element.front(), lookup);
  if (type.shape != model::Type::Shape::Struct) return true;
  const model::Struct* const whole = lookup.findStruct(type.name);
  if (whole == nullptr || !whole->isExternal) return false;
  return std::any_of(whole->fields.begin(), whole->fields.end(), [&](const model::Field& field) {
    return (field.isBase || field.unset) && isRaw(field.type, lookup);
  });
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

void checkInitialisers(const model::Header& header, const model::Lookup& lookup,
                       model::Diagnostics& findings) {
  for (const model::Struct& type : header.structs) {
    if (type.isExternal) continue;
    for (const model::Field& field : type.fields) {
      const bool mayBeZero = field.unset && !excludesZero(field);
      if (mayBeZero && isRaw(field.type, lookup)) warn(field, findings);
    }
  }
}

}  // namespace suture::compiler::check
