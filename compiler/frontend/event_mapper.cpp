#include "compiler/frontend/event_mapper.h"

#include <clang/AST/DeclTemplate.h>

#include <vector>

#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/command_mapper.h"

namespace suture::compiler::frontend {
namespace {

/// Returns where the event's type names its value `index`; the range is invalid if an alias names
/// it.
clang::SourceRange argumentRange(const clang::FieldDecl* field, unsigned index) {
  const clang::TypeSourceInfo* written = field->getTypeSourceInfo();
  if (!written) return {};
  clang::TypeLoc place = written->getTypeLoc();
  if (const auto elaborated = place.getAs<clang::ElaboratedTypeLoc>()) {
    place = elaborated.getNamedTypeLoc();
  }
  const auto arguments = place.getAs<clang::TemplateSpecializationTypeLoc>();
  if (!arguments || index >= arguments.getNumArgs()) return {};
  return arguments.getArgLoc(index).getSourceRange();
}

/// Rejects a value of type void. Returns true if it reported an error.
bool rejectVoid(const clang::FieldDecl* field, clang::QualType type, unsigned index,
                Mapping& mapping) {
  if (!type->isVoidType()) return false;
  model::Diagnostic& finding =
      mapping.error(field, "event-payload",
                    "event '" + field->getNameAsString() + "' carries 'void', which is no value",
                    "an event that carries nothing is a suture::EventOf<>");
  const clang::SourceRange range = argumentRange(field, index);
  if (range.isValid()) finding.fixes = {mapping.fix(range, model::Fix::Place::Instead, "")};
  return true;
}

/// Returns the SUTURE_FIELD of each value, in order; it is a default one if nothing was said.
std::vector<Annotation> valueAnnotations(const clang::FieldDecl* field, unsigned values,
                                         Mapping& mapping) {
  std::vector<Annotation> all = mapping.annotationsOf(field, Kind::Field);
  for (const Annotation& one : all) checkValueArguments(field, one, mapping);
  if (!all.empty() && all.size() != values) {
    mapping.error(
        field, "event-payload",
        "event '" + field->getNameAsString() + "' carries " + std::to_string(values) +
            " values but has SUTURE_FIELD() " + std::to_string(all.size()) +
            (all.size() == 1 ? " time" : " times"),
        values == 0 ? "drop it" : "write one for each value, in order; an empty one says nothing");
  }
  all.resize(values);
  return all;
}

void mapPayload(const clang::FieldDecl* field, const clang::TemplateArgument& payload,
                model::Event& event, Mapping& mapping) {
  const std::vector<Annotation> annotations = valueAnnotations(field, payload.pack_size(), mapping);
  for (unsigned i = 0; i < payload.pack_size(); ++i) {
    const clang::QualType value = payload.pack_begin()[i].getAsType();
    if (rejectVoid(field, value, i, mapping)) continue;
    auto type = mapping.typeOf(
        field, value, "the payload of event '" + field->getNameAsString() + "'", annotations[i]);
    if (!type) continue;
    event.payload.push_back(std::move(*type));
    event.limits.push_back({annotations[i].unit, annotations[i].range});
  }
}

}  // namespace

const clang::TemplateArgument* eventArguments(clang::QualType type) {
  const auto* instance = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(
      type.getCanonicalType()->getAsCXXRecordDecl());
  if (!instance || qualifiedName(instance->getSpecializedTemplate()) != "suture::EventOf") {
    return nullptr;
  }
  return &instance->getTemplateArgs()[0];
}

model::Event mapEvent(const clang::FieldDecl* field, const clang::TemplateArgument& payload,
                      Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(field, Kind::Event);
  const std::string subject = "event '" + field->getNameAsString() + "'";
  model::Event event;
  event.member = field->getNameAsString();
  event.name = annotation.name.value_or(event.member);
  event.wireName = wireMemberName(model::Named::Event, event.name, std::nullopt);
  if (mapping.context().Idents.get(event.name).isKeyword(mapping.context().getLangOpts())) {
    mapping.error(field, "reserved-name",
                  subject + " is called '" + event.name + "', which C++ keeps for itself",
                  "choose another with name(\"...\")");
  }
  event.queue = annotation.queue.value_or(model::kDefaultQueue);
  event.queueGiven = annotation.queue.has_value();
  event.latest = annotation.latest;
  event.latched = annotation.latched;
  event.lifecycle = {annotation.since, annotation.deprecated};
  event.was = annotation.was;
  event.doc = mapping.documentationOf(field);
  event.source = mapping.sourceOf(field);
  mapPayload(field, payload, event, mapping);
  return event;
}

}  // namespace suture::compiler::frontend
