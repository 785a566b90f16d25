#include "compiler/frontend/data/field_mapper.h"

#include <string>
#include <utility>

#include "compiler/frontend/ast/defaults.h"
#include "compiler/frontend/data/field_check.h"
#include "compiler/frontend/data/unset_fields.h"

namespace suture::compiler::frontend {
namespace {

void checkSkipped(const Candidate& candidate, Mapping& mapping) {
  if (candidate.annotation.arguments < 2) return;
  mapping.error(candidate.field, "skip-with-others",
                candidate.subject() + " is skipped, so that nothing else can be said of it",
                "keep skip(), or the others");
}

/// Reports a default that the schema cannot hold: a receiver must not make up another one if a
/// sender does not know the member.
void checkDefault(const Candidate& candidate, Default::State state, Mapping& mapping) {
  const std::string subject = candidate.subject();
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

}  // namespace

std::optional<model::Field> mapField(const Candidate& candidate, Mapping& mapping) {
  const Annotation& annotation = candidate.annotation;
  const clang::FieldDecl* declaration = candidate.field;
  if (annotation.skip) checkSkipped(candidate, mapping);
  if (annotation.skip || rejectField(candidate, mapping)) return std::nullopt;
  auto type =
      mapping.typeOf(candidate.field, declaration->getType(), candidate.subject(), annotation);
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

}  // namespace suture::compiler::frontend
