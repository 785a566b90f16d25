#include "compiler/frontend/contract_mapper.h"

#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/command_mapper.h"
#include "compiler/frontend/event_mapper.h"

namespace suture::compiler::frontend {
namespace {

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
