#include "compiler/frontend/contract_mapper.h"

#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/names.h"
#include "compiler/frontend/type_mapper.h"

namespace suture::compiler::frontend {
namespace {

std::string commandSubject(const clang::NamedDecl* method) {
  return "command '" + method->getNameAsString() + "'";
}

/// What no proxy could call. True if an error was reported.
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

/// The value type behind how a parameter is passed: T and const T& only.
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
  if (annotation.was) {
    mapping.error(declaration, "misplaced-argument", "was() does not apply to a parameter",
                  "parameters are known by their place");
  }
  const auto passed = passedType(declaration, mapping);
  if (!passed) return std::nullopt;
  auto type = mapping.typeOf(declaration, *passed,
                             "parameter '" + declaration->getNameAsString() + "'", annotation);
  if (!type) return std::nullopt;
  if (declaration->hasDefaultArg()) {
    mapping.error(declaration, "default-argument",
                  "the default argument of '" + declaration->getNameAsString() +
                      "' would not reach a remote caller",
                  "drop it, or declare a second command");
  }
  model::Parameter parameter;
  parameter.name = declaration->getNameAsString();
  parameter.wireName = wireMemberName(parameter.name, annotation.name);
  parameter.type = std::move(*type);
  parameter.byReference = declaration->getType()->isReferenceType();
  parameter.unit = annotation.unit;
  parameter.range = annotation.range;
  parameter.source = mapping.sourceOf(declaration);
  return parameter;
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
}

/// Const decides: const = the read family, else void or write.
void mapKind(const clang::CXXMethodDecl* method, const Annotation& field, model::Command& command,
             Mapping& mapping) {
  const bool parameters = method->getNumParams() > 0;
  const bool result = !method->getReturnType()->isVoidType();
  if (method->isConst()) {
    command.kind = parameters ? model::CommandKind::QualifiedRead : model::CommandKind::Read;
    if (result) return mapResult(method, field, command, mapping);
    mapping.error(method, "const-without-result",
                  commandSubject(method) + " is const, thus a read, but returns nothing",
                  "return what it reads, or drop const to make it a write");
    return;
  }
  command.kind = parameters ? model::CommandKind::Write : model::CommandKind::Void;
  if (result) {
    mapping.error(method, "command-with-result",
                  commandSubject(method) + " changes state and returns a value, which is not " +
                      "supported yet",
                  "make it const if it only reads, or return void and publish an event");
  }
}

model::Command mapCommand(const clang::CXXMethodDecl* method, Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(method, Kind::Command);
  const Annotation field = mapping.annotationOf(method, Kind::Field);
  model::Command command;
  command.name = method->getNameAsString();
  command.wireName = wireMemberName(command.name, annotation.name);
  command.source = mapping.sourceOf(method);
  command.doc = mapping.documentationOf(method);
  command.queue = annotation.queue.value_or(model::kDefaultQueue);
  command.queueGiven = annotation.queue.has_value();
  command.latest = annotation.latest;
  command.ttlNanoseconds = annotation.ttlNanoseconds;
  command.was = annotation.was;
  if (rejectMethod(method, mapping)) return command;
  mapKind(method, field, command, mapping);
  for (const clang::ParmVarDecl* parameter : method->parameters()) {
    if (auto mapped = mapParameter(parameter, mapping)) {
      command.parameters.push_back(std::move(*mapped));
    }
  }
  return command;
}

model::Event mapEvent(const clang::FieldDecl* field, const clang::TemplateArgument& payload,
                      Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(field, Kind::Event);
  const Annotation bounds = mapping.annotationOf(field, Kind::Field);
  const std::string subject = "event '" + field->getNameAsString() + "'";
  model::Event event;
  event.member = field->getNameAsString();
  event.name = annotation.name.value_or(event.member);
  event.wireName = wireMemberName(event.name, std::nullopt);
  if (mapping.context().Idents.get(event.name).isKeyword(mapping.context().getLangOpts())) {
    mapping.error(field, "reserved-name",
                  subject + " is called '" + event.name + "', which C++ keeps for itself",
                  "choose another with name(\"...\")");
  }
  event.payloadUnit = bounds.unit;
  event.payloadRange = bounds.range;
  event.queue = annotation.queue.value_or(model::kDefaultQueue);
  event.queueGiven = annotation.queue.has_value();
  event.latest = annotation.latest;
  event.latched = annotation.latched;
  event.was = annotation.was;
  event.doc = mapping.documentationOf(field);
  event.source = mapping.sourceOf(field);
  if (payload.pack_size() > 1) {
    mapping.error(field, "event-payload", subject + " carries more than one value",
                  "put them into one SUTURE_TYPE");
  } else if (payload.pack_size() == 1) {
    auto type = mapping.typeOf(field, payload.pack_begin()->getAsType(),
                               "the payload of " + subject, bounds);
    if (type) event.payload.push_back(std::move(*type));
  }
  return event;
}

model::Fix annotate(const clang::Decl* member, std::string macro, Mapping& mapping) {
  return mapping.fix(member->getBeginLoc(), model::Fix::Place::Before, std::move(macro));
}

void mapMembers(const clang::CXXRecordDecl* declaration, model::Interface& result,
                Mapping& mapping) {
  for (const clang::Decl* member : declaration->decls()) {
    if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member)) {
      if (isAnnotated(method, Kind::Command)) {
        result.commands.push_back(mapCommand(method, mapping));
      } else if (method->isVirtual() && !llvm::isa<clang::CXXDestructorDecl>(method)) {
        mapping
            .error(
                method, "unannotated-command",
                "virtual method '" + method->getNameAsString() + "' of a contract is not a command",
                "add SUTURE_COMMAND(), or make it non-virtual")
            .fixes = {annotate(method, "SUTURE_COMMAND() ", mapping)};
      }
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
  result.wireName = wireTypeName(declaration, annotation.name);
  result.doc = mapping.documentationOf(declaration);
  result.source = mapping.sourceOf(declaration);
  if (declaration->getNumBases() > 0) {
    mapping.error(declaration, "contract-base",
                  "contract '" + declaration->getNameAsString() +
                      "' has a base class, which is not supported yet",
                  "declare all its commands and events in it");
  }
  mapMembers(declaration, result, mapping);
  return result;
}

}  // namespace suture::compiler::frontend
