#include "compiler/frontend/command_mapper.h"

#include "compiler/frontend/ast/copies.h"
#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {

std::string commandSubject(const clang::NamedDecl* method) {
  return "command '" + method->getNameAsString() + "'";
}

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

namespace {

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

}  // namespace

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

}  // namespace suture::compiler::frontend
