#include "compiler/frontend/contract_mapper.h"

#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/ast/copies.h"
#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {
namespace {

std::string commandSubject(const clang::NamedDecl* method) {
  return "command '" + method->getNameAsString() + "'";
}

/// Rejects what no proxy could call. Returns true if it reported an error.
bool rejectMethod(const clang::CXXMethodDecl* method, Mapping& mapping) {
  const std::string subject = commandSubject(method);
  if (llvm::isa<clang::CXXConstructorDecl, clang::CXXDestructorDecl, clang::CXXConversionDecl>(
          method) ||
      method->isOverloadedOperator()) {
    mapping.error(method, "not-a-method", subject + " is not an ordinary method",
                  "give it a name of its own");
  } else if (method->isStatic()) {
    mapping.error(method, "static-command", subject + " is static; it belongs to no component",
                  "make it virtual");
  } else if (method->isDeleted()) {
    mapping.error(method, "deleted-command", subject + " is deleted; nobody could call it",
                  "remove it, or declare it as 'virtual ... = 0'");
  } else if (!method->isVirtual()) {
    mapping.error(method, "command-not-virtual",
                  subject + " is not virtual; a component could not implement it",
                  "declare it as 'virtual ... = 0'");
  } else if (method->getAccess() != clang::AS_public) {
    mapping.error(method, "private-command", subject + " is not public", "make it public");
  } else if (method->isVariadic()) {
    mapping.error(method, "variadic", subject + " takes variable arguments",
                  "declare each parameter");
  } else if (method->getRefQualifier() != clang::RQ_None || method->isVolatile()) {
    mapping.error(method, "qualified-method", subject + " is volatile or has a reference qualifier",
                  "drop the qualifier");
  } else {
    return false;
  }
  return true;
}

/// Returns the type of the value that a parameter passes, which must be a T or a const T&.
std::optional<clang::QualType> passedType(const clang::ParmVarDecl* parameter, Mapping& mapping) {
  const clang::QualType type = parameter->getType();
  const std::string subject = "parameter '" + parameter->getNameAsString() + "'";
  if (type->isRValueReferenceType()) {
    mapping.error(parameter, "rvalue-parameter", subject + " is an rvalue reference",
                  "take it by value or const reference");
    return std::nullopt;
  }
  if (!type->isLValueReferenceType()) return type.getUnqualifiedType();
  const clang::QualType referred = type->getPointeeType();
  if (!referred.isConstQualified()) {
    mapping.error(parameter, "output-parameter",
                  subject + " is an output through a non-const reference",
                  "return the result by value, or take a const reference");
    return std::nullopt;
  }
  if (referred->isArrayType()) {
    mapping.error(parameter, "c-array", subject + " is a C array, which is no value",
                  "use std::array");
    return std::nullopt;
  }
  return referred.getUnqualifiedType();
}

std::optional<model::Parameter> mapParameter(const clang::ParmVarDecl* declaration,
                                             Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(declaration, Kind::Field);
  if (!declaration->getIdentifier()) {
    mapping.error(declaration, "unnamed-parameter", "a parameter of a command has no name",
                  "name it; the name is on the wire");
    return std::nullopt;
  }
  if (annotation.was || annotation.since || !annotation.deprecated.empty() || annotation.skip ||
      annotation.fallback) {
    mapping.error(declaration, "misplaced-argument",
                  "only unit(), range(), capacity(), bulk() and name() apply to a parameter",
                  "a signature changes as a whole: say the rest in SUTURE_COMMAND()");
  }
  const auto passed = passedType(declaration, mapping);
  if (!passed) return std::nullopt;
  auto type = mapping.typeOf(declaration, *passed,
                             "parameter '" + declaration->getNameAsString() + "'", annotation);
  if (!type) return std::nullopt;
  const bool byReference = declaration->getType()->isReferenceType();
  if (!byReference && !canBeCopied(*passed, mapping.names().semantics())) {
    mapping.error(declaration, "uncopyable",
                  "parameter '" + declaration->getNameAsString() +
                      "' is taken by value, but its type cannot be copied",
                  "take it by const reference");
  }
  if (declaration->hasDefaultArg()) {
    mapping.error(declaration, "default-argument",
                  "the default argument of '" + declaration->getNameAsString() +
                      "' would not reach a remote caller",
                  "drop it, or declare a second command");
  }
  model::Parameter parameter;
  parameter.name = declaration->getNameAsString();
  parameter.wireName = wireMemberName(model::Named::Parameter, parameter.name, annotation.name);
  parameter.type = std::move(*type);
  parameter.byReference = byReference;
  parameter.unit = annotation.unit;
  parameter.range = annotation.range;
  parameter.source = mapping.sourceOf(declaration);
  return parameter;
}

/// Reports what a result, or an event's value, cannot say: it has neither a name nor a history of
/// its own.
void checkValueArguments(const clang::NamedDecl* declaration, const Annotation& field,
                         Mapping& mapping) {
  if (!field.name && !field.was && !field.since && field.deprecated.empty() && !field.skip &&
      !field.fallback) {
    return;
  }
  mapping.error(declaration, "misplaced-argument",
                "SUTURE_FIELD() on '" + declaration->getNameAsString() +
                    "' speaks of a value: only unit(), range(), capacity() and bulk() apply",
                "say the rest in the other annotation");
}

/// Reports a result that cannot get to its caller: a read hands it over by moving, and an answer by
/// copying if the class has no code for moving.
void checkResult(const clang::CXXMethodDecl* method, clang::QualType type, bool isRead,
                 Mapping& mapping) {
  clang::Sema& semantics = mapping.names().semantics();
  if (isRead ? canBeMoved(type, semantics) : movesByCode(type, semantics)) return;
  if (canBeCopied(type, semantics) && canBeMoved(type, semantics)) return;
  mapping.error(method, "uncopyable",
                "the result of " + commandSubject(method) + " cannot be handed to its caller: '" +
                    spelled(type.getUnqualifiedType(), mapping.context()) +
                    (isRead ? "' can be neither copied nor moved" : "' cannot be copied"),
                "let it be copied, or return a struct of what it holds");
}

void mapResult(const clang::CXXMethodDecl* method, const Annotation& field, model::Command& command,
               Mapping& mapping) {
  clang::QualType type = method->getReturnType();
  const bool reference = type->isLValueReferenceType() && type->getPointeeType().isConstQualified();
  if (reference) type = type->getPointeeType();
  if (reference) type = type.getUnqualifiedType();
  command.resultByReference = reference;
  command.resultUnit = field.unit;
  command.resultRange = field.range;
  command.result = mapping.typeOf(method, type, "the result of " + commandSubject(method), field);
  if (!command.result) return;
  checkResult(method, type, command.kind == model::CommandKind::Read, mapping);
}

/// Sets the kind of a command: const makes it a read, or a qualified read if it has parameters;
/// else it is a void or a write.
void mapKind(const clang::CXXMethodDecl* method, const Annotation& field, model::Command& command,
             Mapping& mapping) {
  using model::CommandKind;
  const bool parameters = method->getNumParams() > 0;
  const bool result = !method->getReturnType()->isVoidType();
  if (method->isConst()) {
    command.kind = parameters ? CommandKind::QualifiedRead : CommandKind::Read;
  } else if (result) {
    command.kind = parameters ? CommandKind::WriteReturn : CommandKind::VoidReturn;
  } else {
    command.kind = parameters ? CommandKind::Write : CommandKind::Void;
  }
  if (result) return mapResult(method, field, command, mapping);
  if (!method->isConst()) return;
  mapping.error(method, "const-without-result",
                commandSubject(method) + " is const, thus a read, but returns nothing",
                "return what it reads, or drop const to make it a write");
}

/// Reports an optional() command without a body, because providers that lack it need one.
void mapOptional(const clang::CXXMethodDecl* method, const Annotation& annotation,
                 model::Command& command, Mapping& mapping) {
  command.optional = annotation.optional;
  if (!command.optional || !method->isPureVirtual()) return;
  mapping.error(method, "optional-without-body",
                commandSubject(method) + " is optional() but has no body for those who lack it",
                "replace '= 0' by a body, such as '{}'");
}

model::Command mapCommand(const clang::CXXMethodDecl* method, Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(method, Kind::Command);
  const Annotation field = mapping.annotationOf(method, Kind::Field);
  checkValueArguments(method, field, mapping);
  model::Command command;
  command.name = method->getNameAsString();
  command.source = mapping.sourceOf(method);
  command.signature =
      mapping.sourceOf({method->getLocation(), method->getFunctionTypeLoc().getRParenLoc()});
  command.doc = mapping.documentationOf(method);
  command.queue = annotation.queue.value_or(model::kDefaultQueue);
  command.queueGiven = annotation.queue.has_value();
  command.latest = annotation.latest;
  command.ttlNanoseconds = annotation.ttlNanoseconds;
  command.deadlineNanoseconds = annotation.deadlineNanoseconds;
  command.concurrent = annotation.concurrent;
  command.direct = annotation.direct;
  command.isOverloaded = !method->getParent()->lookup(method->getDeclName()).isSingleResult();
  command.lifecycle = {annotation.since, annotation.deprecated};
  command.was = annotation.was;
  if (rejectMethod(method, mapping)) return command;
  mapKind(method, field, command, mapping);
  const bool reads = command.kind == model::CommandKind::Read;
  command.wireName = wireMemberName(reads ? model::Named::Read : model::Named::Command,
                                    command.name, annotation.name);
  mapOptional(method, annotation, command, mapping);
  for (const clang::ParmVarDecl* parameter : method->parameters()) {
    if (auto mapped = mapParameter(parameter, mapping)) {
      command.parameters.push_back(std::move(*mapped));
    }
  }
  return command;
}

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

model::Fix annotate(const clang::Decl* member, std::string macro, Mapping& mapping) {
  return mapping.fix(member->getBeginLoc(), model::Fix::Place::Before, std::move(macro));
}

/// Maps a command, and reports a virtual method without the macro or one that the base has already.
void mapMethod(const clang::CXXMethodDecl* method, model::Interface& result, Mapping& mapping) {
  const std::string name = "'" + method->getNameAsString() + "'";
  const bool command = isAnnotated(method, Kind::Command);
  const bool overrides = method->size_overridden_methods() > 0;
  if (command && overrides) {
    mapping
        .error(method, "repeated-command", "command " + name + " is a command of the base already",
               "drop SUTURE_COMMAND() here, or give the new command a name of its own")
        .notes.push_back({mapping.sourceOf(*method->begin_overridden_methods()), "it is this one"});
  } else if (command) {
    result.commands.push_back(mapCommand(method, mapping));
  } else if (method->isVirtual() && !overrides && !llvm::isa<clang::CXXDestructorDecl>(method)) {
    mapping
        .error(method, "unannotated-command",
               "virtual method " + name + " of a contract is not a command",
               "add SUTURE_COMMAND(), or make it non-virtual")
        .fixes = {annotate(method, "SUTURE_COMMAND() ", mapping)};
  }
}

void mapMembers(const clang::CXXRecordDecl* declaration, model::Interface& result,
                Mapping& mapping) {
  for (const clang::Decl* member : declaration->decls()) {
    if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member)) {
      mapMethod(method, result, mapping);
    } else if (const auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(member)) {
      if (!isAnnotated(pattern->getTemplatedDecl(), Kind::Command)) continue;
      mapping.error(pattern, "template-command",
                    commandSubject(pattern) + " is a template; it has no one signature",
                    "declare a command for each use");
    } else if (const auto* field = llvm::dyn_cast<clang::FieldDecl>(member)) {
      const clang::TemplateArgument* payload = eventArguments(field->getType());
      if (payload && isAnnotated(field, Kind::Event)) {
        result.events.push_back(mapEvent(field, *payload, mapping));
      } else {
        model::Diagnostic& finding = mapping.error(
            field, "contract-data",
            "member '" + field->getNameAsString() + "' of a contract is not an event",
            payload ? "add SUTURE_EVENT()"
                    : "declare an event as suture::EventOf<T>; keep data in the component");
        if (payload) finding.fixes = {annotate(field, "SUTURE_EVENT() ", mapping)};
      }
    }
  }
}

/// Accepts one base at most, itself a contract, because its commands keep their numbers in every
/// contract that derives from it.
void mapBase(const clang::CXXRecordDecl* declaration, model::Interface& result, Mapping& mapping) {
  const std::string subject = "contract '" + declaration->getNameAsString() + "'";
  if (declaration->getNumBases() > 1) {
    mapping.error(declaration, "contract-bases", subject + " has more than one base class",
                  "derive from one contract; a component may provide several");
    return;
  }
  for (const clang::CXXBaseSpecifier& base : declaration->bases()) {
    const auto* record = base.getType().getCanonicalType()->getAsCXXRecordDecl();
    if (!record || !isAnnotated(record, Kind::Interface)) {
      mapping.error(declaration, "contract-base",
                    subject + " has the base class '" + spelled(base.getType(), mapping.context()) +
                        "', which is not a SUTURE_INTERFACE",
                    "annotate the base with SUTURE_INTERFACE(), or declare its methods here");
    } else if (base.isVirtual() || base.getAccessSpecifier() != clang::AS_public) {
      mapping.error(
          declaration, "contract-base-access",
          subject + " derives from '" + record->getNameAsString() + "' privately or virtually",
          "derive from it as 'public " + record->getNameAsString() + "'");
    } else {
      result.base = qualifiedName(record);
    }
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

model::Interface mapInterfaceDeclaration(const clang::CXXRecordDecl* declaration,
                                         Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(declaration, Kind::Interface);
  model::Interface result;
  result.name = qualifiedName(declaration);
  result.wireName = wireTypeName(model::Named::Contract, declaration, annotation.name);
  result.doc = mapping.documentationOf(declaration);
  result.source = mapping.sourceOf(declaration);
  result.version = annotation.version.value_or(1);
  result.crtk = annotation.crtk;
  result.was = annotation.was;
  result.lifecycle = {annotation.since, annotation.deprecated};
  mapBase(declaration, result, mapping);
  mapMembers(declaration, result, mapping);
  return result;
}

}  // namespace suture::compiler::frontend
