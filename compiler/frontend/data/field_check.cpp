#include "compiler/frontend/data/field_check.h"

#include <clang/AST/RecordLayout.h>

#include <string>

namespace suture::compiler::frontend {
namespace {

/// Returns what SUTURE_EXTERNAL_TYPE says to leave a field out, or each member of an anonymous
/// union or struct.
std::string skipsOf(const clang::FieldDecl* field) {
  if (!field->isAnonymousStructOrUnion()) {
    return ", member(" + field->getNameAsString() + ", skip())";
  }
  std::string all;
  for (const clang::FieldDecl* part : field->getType()->getAsRecordDecl()->fields()) {
    all += skipsOf(part);
  }
  return all;
}

}  // namespace

bool isPacked(const clang::FieldDecl* field) {
  const clang::ASTContext& context = field->getASTContext();
  const clang::CharUnits wanted = context.getTypeAlignInChars(field->getType());
  if (wanted.isOne()) return false;
  const clang::CharUnits given = context.getASTRecordLayout(field->getParent()).getAlignment();
  return field->hasAttr<clang::PackedAttr>() || given < wanted;
}

bool rejectField(const Candidate& candidate, Mapping& mapping) {
  const clang::FieldDecl* field = candidate.field;
  const std::string subject = candidate.subject();
  const auto reject = [&](const char* slug, const std::string& message, const std::string& help) {
    mapping.error(field, slug, message,
                  candidate.isExternal ? "leave it out: all()" + skipsOf(field) : help);
    return true;
  };
  const std::string offTheWire = "keep it off the wire: SUTURE_FIELD(skip())";
  if (!field->getIdentifier() && field->getType()->isUnionType()) {
    return reject("union", "an anonymous union carries no tag",
                  "use std::variant, or give it a name and SUTURE_FIELD(skip())");
  }
  if (!field->getIdentifier()) {
    return reject("unnamed-field", "an unnamed field has no stable wire name",
                  "name it; what has a name may have SUTURE_FIELD(skip())");
  }
  if (field->getAccess() != clang::AS_public && !candidate.reachable) {
    return reject("private-field", subject + " is not public",
                  "write SUTURE_FRIEND() in the class, or SUTURE_FIELD(skip()) on the field");
  }
  if (field->isBitField()) {
    return reject("bit-field", subject + " is a bit-field; its width would be lost",
                  "use a plain integer with range()");
  }
  if (isPacked(field) && field->getAccess() != clang::AS_public) {
    return reject("packed", subject + " is packed and not public",
                  "make it public, or " + offTheWire);
  }
  if (isPacked(field) && !field->getType().isTriviallyCopyableType(field->getASTContext())) {
    return reject("packed", subject + " is packed, and its type cannot be copied as bytes",
                  offTheWire);
  }
  if (field->isMutable()) {
    return reject("mutable", subject + " is mutable; it is not part of the value", offTheWire);
  }
  if (candidate.annotation.fallback) {
    mapping.error(field, "misplaced-argument", "fallback() applies to an enumerator", "drop it");
    return true;
  }
  return false;
}

}  // namespace suture::compiler::frontend
