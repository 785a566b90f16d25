#include "compiler/frontend/data_mapper.h"

#include <clang/AST/DeclFriend.h>
#include <clang/AST/RecordLayout.h>

#include <algorithm>
#include <set>

#include "compiler/frontend/ast/defaults.h"
#include "compiler/frontend/ast/initialiser.h"
#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/types/scalars.h"
#include "compiler/frontend/types/type_mapper.h"
#include "compiler/frontend/unset_fields.h"
#include "compiler/model/naming.h"

namespace suture::compiler::frontend {
namespace {

std::string fieldSubject(const clang::FieldDecl* field) {
  return "field '" + field->getNameAsString() + "'";
}

/// Returns the value, or the bits of a std::uint64_t that no std::int64_t can hold.
std::int64_t bitsOf(const llvm::APSInt& value) {
  return value.isSigned() ? value.getSExtValue() : static_cast<std::int64_t>(value.getZExtValue());
}

model::Enumerator mapEnumerator(const clang::EnumConstantDecl* declaration, Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(declaration, Kind::Field);
  if (!annotation.unit.empty() || annotation.range || !annotation.capacity.empty() ||
      annotation.bulk || annotation.skip) {
    mapping.error(declaration, "misplaced-argument",
                  "only name(), was(), since(), deprecated() and fallback() apply to an enumerator",
                  "drop the other arguments");
  }
  model::Enumerator enumerator;
  enumerator.name = declaration->getNameAsString();
  enumerator.wireName = wireMemberName(model::Named::Enumerator, enumerator.name, annotation.name);
  enumerator.isNamed = annotation.name.has_value();
  enumerator.value = bitsOf(declaration->getInitVal());
  enumerator.fallback = annotation.fallback;
  enumerator.lifecycle = {annotation.since, annotation.deprecated};
  enumerator.was = annotation.was;
  enumerator.doc = mapping.documentationOf(declaration);
  enumerator.source = mapping.sourceOf(declaration);
  return enumerator;
}

/// A Candidate is a data member on its way into the model.
struct Candidate {
  const clang::FieldDecl* field;
  Annotation annotation;
  bool isExternal;  ///< true if its class cannot be edited
  bool reachable;   ///< true if suture::Members reaches it even if it is not public
};

void checkSkipped(const Candidate& candidate, Mapping& mapping) {
  if (candidate.annotation.arguments < 2) return;
  mapping.error(
      candidate.field, "skip-with-others",
      fieldSubject(candidate.field) + " is skipped, so that nothing else can be said of it",
      "keep skip(), or the others");
}

/// Reports a default that the schema cannot hold: a receiver must not make up another one if a
/// sender does not know the member.
void checkDefault(const Candidate& candidate, Default::State state, Mapping& mapping) {
  const std::string subject = fieldSubject(candidate.field);
  switch (state) {
    case Default::State::Nothing:
    case Default::State::Constant: return;
    case Default::State::NotConstant:
      if (candidate.isExternal) return;
      mapping.error(
          candidate.field, "default-not-constant",
          "the initialiser of " + subject +
              " is no constant that a schema can hold; where a sender does not know it, a "
              "receiver would read zero",
          "give it a constant, or make it a std::optional");
      return;
    case Default::State::NoEnumerator:
      if (candidate.isExternal) return;
      mapping.error(candidate.field, "default-not-constant",
                    "the default of " + subject +
                        " is no enumerator of its type; where a sender does not know it, a "
                        "receiver would read the first one",
                    "initialise it with an enumerator, or make it a std::optional");
      return;
    case Default::State::NotANumber:
      if (candidate.isExternal) return;
      mapping.error(candidate.field, "default-nan",
                    subject + " is NaN by default, and no contract lets NaN pass",
                    "give it numbers, or make it a std::optional that is empty");
      return;
    case Default::State::TooLong:
      mapping.error(candidate.field, "default-capacity",
                    subject + " is longer by default than its capacity",
                    "give it a shorter default or a larger capacity()");
      return;
    case Default::State::Unseen:
      if (candidate.isExternal) return;
      mapping.error(candidate.field, "default-unseen",
                    "what the default constructor gives " + subject +
                        " cannot be seen here; where a sender does not know it, a receiver may "
                        "read something else",
                    "initialise it where it is declared, or in the list of a constructor without "
                    "statements");
  }
}

/// Tells if the field may lie where its type is not aligned, so that no reference binds to it.
bool isPacked(const clang::FieldDecl* field) {
  const clang::ASTContext& context = field->getASTContext();
  const clang::CharUnits wanted = context.getTypeAlignInChars(field->getType());
  if (wanted.isOne()) return false;
  const clang::CharUnits given = context.getASTRecordLayout(field->getParent()).getAlignment();
  return field->hasAttr<clang::PackedAttr>() || given < wanted;
}

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

/// Reports why a field cannot be on the wire, whatever its type. Returns true if it reported an
/// error.
bool rejectField(const Candidate& candidate, Mapping& mapping) {
  const clang::FieldDecl* field = candidate.field;
  const std::string subject = fieldSubject(field);
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

std::optional<model::Field> mapField(const Candidate& candidate, Mapping& mapping) {
  const Annotation& annotation = candidate.annotation;
  const clang::FieldDecl* declaration = candidate.field;
  if (annotation.skip) checkSkipped(candidate, mapping);
  if (annotation.skip || rejectField(candidate, mapping)) return std::nullopt;
  auto type = mapping.typeOf(candidate.field, declaration->getType(), fieldSubject(declaration),
                             annotation);
  if (!type) return std::nullopt;
  model::Field field;
  field.name = declaration->getNameAsString();
  field.wireName = wireMemberName(field.name, annotation.name);
  field.isNamed = annotation.name.has_value();
  field.type = std::move(*type);
  field.isHidden = declaration->getAccess() != clang::AS_public;
  field.isPacked = isPacked(declaration);
  field.unit = annotation.unit;
  field.range = annotation.range;
  field.was = annotation.was;
  field.lifecycle = {annotation.since, annotation.deprecated};
  const Default standard = defaultOf(declaration, field.type);
  field.defaultJson = standard.json;
  field.defaultNumbers = standard.numbers;
  field.isPreset = isPreset(declaration);
  if (candidate.isExternal) {
    if (isRaw(declaration, field.type)) field.unset.emplace();
  } else {
    field.unset = unsetState(declaration, field.type, mapping);
  }
  field.doc = mapping.documentationOf(declaration);
  field.source = mapping.sourceOf(candidate.field);
  checkDefault(candidate, standard.state, mapping);
  return field;
}

/// Tells if the class has SUTURE_FRIEND().
bool hasFriend(const clang::CXXRecordDecl* record) {
  for (const clang::FriendDecl* one : record->friends()) {
    const clang::NamedDecl* name = one->getFriendDecl();
    if (name && qualifiedName(name) == "suture::Members") return true;
  }
  return false;
}

bool hasField(const clang::CXXRecordDecl* record, const std::string& name) {
  for (const clang::FieldDecl* field : record->fields()) {
    if (field->getName() == name) return true;
  }
  return false;
}

/// Adds each base class as a field: the first is called `base`, another one `base` with the name of
/// its class.
void addBases(model::Struct& result, const DataDeclaration& declared, Mapping& mapping) {
  const clang::NamedDecl* place = declared.place;
  for (const clang::CXXBaseSpecifier& base : declared.record->bases()) {
    const std::string name =
        base.getType().getCanonicalType()->getAsCXXRecordDecl()->getName().str();
    const std::string subject = "base class '" + name + "'";
    if (base.isVirtual()) {
      mapping.error(place, "virtual-base", subject + " is virtual; its place is not fixed",
                    "make the base a member");
      continue;
    }
    if (base.getAccessSpecifier() != clang::AS_public) {
      mapping.error(place, "private-base", subject + " is not public",
                    "derive publicly, or make it a member");
      continue;
    }
    auto type = mapping.typeOf(place, base.getType(), subject, {});
    if (!type) continue;
    model::Field field;
    field.name = result.fields.empty() ? "base" : "base" + model::titleCase(name);
    field.wireName = field.name;
    if (hasField(declared.record, field.name)) field.name += "_";
    field.type = std::move(*type);
    field.isBase = true;
    field.isPreset = mayBeInitialised(declared.record, base);
    field.source = mapping.sourceOf(place);
    result.fields.push_back(std::move(field));
  }
}

bool isDefaultConstructible(const clang::CXXRecordDecl* declaration) {
  for (const clang::CXXConstructorDecl* constructor : declaration->ctors()) {
    if (constructor->isDefaultConstructor()) {
      return !constructor->isDeleted() && constructor->getAccess() == clang::AS_public;
    }
  }
  return declaration->hasDefaultConstructor();
}

/// Tells if SUTURE_EXTERNAL_TYPE means each public member.
bool meansAll(const Annotation& external) { return external.all || external.members.empty(); }

/// Tells if each member of an anonymous union or struct is skipped by its own name.
bool isSkippedWhole(const clang::FieldDecl* field, const std::vector<Candidate>& listed) {
  const clang::RecordDecl* const record = field->getType()->getAsRecordDecl();
  if (!field->isAnonymousStructOrUnion() || record == nullptr) return false;
  return std::all_of(record->field_begin(), record->field_end(), [&](const clang::FieldDecl* part) {
    return isSkippedWhole(part, listed) ||
           std::any_of(listed.begin(), listed.end(), [&](const Candidate& one) {
             return one.field == part && one.annotation.skip;
           });
  });
}

/// Returns the members that SUTURE_EXTERNAL_TYPE means; findings about those that it lists appear
/// there.
std::vector<Candidate> externalCandidates(const DataDeclaration& declared, Mapping& mapping) {
  std::vector<Candidate> listed;
  for (const ExternalMember& member : declared.external->members) {
    mapping.addForeign(member.field, member.place, nullptr);
    listed.push_back({member.field, member.annotation, true, false});
  }
  if (!meansAll(*declared.external)) return listed;
  std::vector<Candidate> all;
  for (const clang::FieldDecl* field : declared.record->fields()) {
    if (field->isUnnamedBitField()) continue;  // it has no value
    const auto own = std::find_if(listed.begin(), listed.end(),
                                  [&](const Candidate& one) { return one.field == field; });
    if (own != listed.end()) {
      all.push_back(*own);
    } else if (field->getAccess() == clang::AS_public && !isSkippedWhole(field, listed)) {
      mapping.addForeign(field, field->getLocation(), declared.place);
      all.push_back({field, {}, true, false});
    }
  }
  return all;
}

std::vector<Candidate> candidatesOf(const DataDeclaration& declared, Mapping& mapping) {
  if (declared.external) return externalCandidates(declared, mapping);
  std::vector<Candidate> all;
  const bool reachable = hasFriend(declared.record);
  for (const clang::FieldDecl* field : declared.record->fields()) {
    if (field->isUnnamedBitField()) continue;  // it has no value
    all.push_back({field, mapping.annotationOf(field, Kind::Field), false, reachable});
  }
  return all;
}

void checkShape(const DataDeclaration& declared, Mapping& mapping) {
  const clang::CXXRecordDecl* declaration = declared.record;
  const clang::NamedDecl* place = declared.place;
  const std::string name = "'" + plainName(declaration) + "'";
  if (declaration->isUnion()) {
    mapping.error(place, "union", name + " is a union; it carries no tag",
                  "use std::variant, or a struct with an enum class that says which member counts");
  }
  const bool all = declared.external && meansAll(*declared.external);
  const auto isPublic = [](const clang::FieldDecl* field) {
    return field->getAccess() == clang::AS_public;
  };
  if (all && !declaration->field_empty() &&
      std::none_of(declaration->field_begin(), declaration->field_end(), isPublic)) {
    mapping.error(place, "external-type", name + " has no public members",
                  "specialise suture::Wire for it, which says what it travels as");
  }
  if (!isDefaultConstructible(declaration)) {
    mapping.error(place, "no-default-constructor",
                  name + " must be default-constructible to be decoded",
                  "add '" + plainName(declaration) + "() = default;'");
  }
}

}  // namespace

model::Enum mapEnumDeclaration(const EnumDeclaration& declared, Mapping& mapping) {
  const clang::EnumDecl* declaration = declared.declaration;
  model::Enum result;
  result.name = declared.name;
  result.wireName = declared.wireName;
  result.isOpen = !declaration->isFixed();
  const bool leaks = !declaration->isScoped() && !declaration->getDeclContext()->isRecord();
  if (leaks && !declared.isExternal()) {
    mapping.error(declaration, "unscoped-enum",
                  "enum '" + plainName(declaration) + "' leaks its enumerators' names",
                  "declare it as enum class");
  }
  const auto* builtin = declaration->getIntegerType()->getAs<clang::BuiltinType>();
  MappedType underlying = TypeProblem{"unsupported-type", "", "use an integer"};
  if (builtin)
    underlying = declared.isExternal() ? mapForeignBuiltin(builtin) : mapBuiltin(builtin);
  if (const auto* type = std::get_if<model::Type>(&underlying)) {
    result.underlying = type->scalar;
    result.underlyingType = type->spelling;
  } else {
    mapping.error(
        declaration, std::get<TypeProblem>(underlying).slug,
        "enum '" + plainName(declaration) + "' has an underlying type that is " + "not portable",
        "use a fixed-width integer");
  }
  std::set<std::int64_t> values;
  for (const clang::EnumConstantDecl* enumerator : declaration->enumerators()) {
    const bool isNew = values.insert(bitsOf(enumerator->getInitVal())).second;
    // The user cannot drop the second name of a value from a foreign enum, and it means the same.
    if (isNew || !declared.isExternal())
      result.enumerators.push_back(mapEnumerator(enumerator, mapping));
  }
  result.was = declared.was;
  result.lifecycle = declared.lifecycle;
  result.doc = mapping.documentationOf(declared.place);
  result.source = mapping.sourceOf(declared.place);
  return result;
}

model::Struct mapStructDeclaration(const DataDeclaration& declared, Mapping& mapping) {
  model::Struct result;
  result.name = declared.name;
  result.wireName = declared.wireName;
  result.isExternal = declared.external.has_value();
  result.was = declared.was;
  result.lifecycle = declared.lifecycle;
  checkShape(declared, mapping);
  if (!declared.external || meansAll(*declared.external)) addBases(result, declared, mapping);
  for (const Candidate& candidate : candidatesOf(declared, mapping)) {
    auto mapped = mapField(candidate, mapping);
    if (mapped) result.fields.push_back(std::move(*mapped));
  }
  result.doc = mapping.documentationOf(declared.place);
  result.source = mapping.sourceOf(declared.place);
  return result;
}

}  // namespace suture::compiler::frontend
