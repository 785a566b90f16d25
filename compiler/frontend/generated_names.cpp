#include "compiler/frontend/generated_names.h"

#include <clang/AST/DeclTemplate.h>

#include <algorithm>
#include <vector>

#include "compiler/frontend/ast/names.h"

namespace suture::compiler::frontend {
namespace {

std::vector<std::string> namesFor(const clang::TagDecl* declaration, Kind kind) {
  const std::string name = declaration->getNameAsString();
  std::vector<std::string> names{"wire"};  // capnp has this namespace
  if (kind == Kind::Type) names.push_back(name + "Slot");
  if (kind == Kind::Interface) {
    names.insert(names.end(), {name + "Command", name + "Event", name + "Column"});
  }
  return names;
}

/// Returns a user's own declaration of the name, or null. It leaves out what a user took over from
/// the runtime with a using-declaration, because that is the same thing.
const clang::NamedDecl* ownDeclaration(const clang::DeclContext* space, const std::string& name,
                                       clang::ASTContext& context) {
  for (const clang::NamedDecl* found : space->lookup(&context.Idents.get(name))) {
    const bool clashes = llvm::isa<clang::TypeDecl, clang::TemplateDecl, clang::ValueDecl>(found);
    if (clashes) return found;
  }
  return nullptr;
}

/// Returns what else than functions has the name, or null. A struct may share its
/// name with one.
const clang::NamedDecl* otherThanFunctions(const clang::DeclContext* space, const char* name,
                                           clang::ASTContext& context) {
  for (const clang::NamedDecl* found : space->lookup(&context.Idents.get(name))) {
    const bool fits =
        llvm::isa<clang::FunctionDecl, clang::FunctionTemplateDecl, clang::TagDecl>(found);
    const bool clashes = llvm::isa<clang::TypeDecl, clang::TemplateDecl, clang::ValueDecl>(found);
    if (clashes && !fits) return found;
  }
  return nullptr;
}

/// Returns the functions that are generated for what the declaration is.
std::vector<const char*> functionsFor(const clang::TagDecl* declaration, Kind kind) {
  static constexpr auto kOfTypes = {"load",        "store",  "isValid",
                                    "shiftStamps", "toWire", "fromWire"};
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(declaration);
  if (!record) return {};
  if (kind == Kind::Type) return kOfTypes;
  const auto takes = [](const clang::CXXMethodDecl* method) {
    return isAnnotated(method, Kind::Command) && method->getNumParams() > 0;
  };
  const bool any = std::any_of(record->method_begin(), record->method_end(), takes);
  return std::vector<const char*>(any ? 1 : 0, "store");
}

/// Returns what a user has declared in namespace wire, where capnp declares a type of that name.
const clang::NamedDecl* wireDeclaration(const clang::DeclContext* space, const std::string& name,
                                        clang::ASTContext& context) {
  for (const clang::NamedDecl* found : space->lookup(&context.Idents.get("wire"))) {
    const auto* wire = llvm::dyn_cast<clang::NamespaceDecl>(found);
    if (!wire) continue;
    for (const clang::NamedDecl* inside : wire->lookup(&context.Idents.get(name))) {
      const clang::SourceManager& sources = context.getSourceManager();
      const auto file = sources.getFilename(sources.getFileLoc(inside->getLocation()));
      if (!file.ends_with(".capnp.h")) return inside;
    }
  }
  return nullptr;
}

}  // namespace

void checkGeneratedNames(const clang::TagDecl* declaration, Kind kind, Mapping& mapping) {
  if (namespaceOf(declaration) == "suture") return;  // there the names are the runtime's
  const clang::DeclContext* space = declaration->getDeclContext()->getRedeclContext();
  const auto report = [&](const clang::NamedDecl* found, const std::string& name) {
    if (!found || !mapping.once(found)) return;
    model::Diagnostic& finding = mapping.error(
        found, "generated-name", "the code generated for this namespace declares '" + name + "'",
        "choose another name, or another namespace");
    if (found == declaration) return;
    finding.notes.push_back(
        {mapping.sourceOf(declaration), "it is generated for what this header annotates"});
  };
  for (const std::string& name : namesFor(declaration, kind)) {
    report(ownDeclaration(space, name, mapping.context()), name);
  }
  for (const char* const name : functionsFor(declaration, kind)) {
    report(otherThanFunctions(space, name, mapping.context()), name);
  }
  if (kind == Kind::Component) return;  // it is not on the wire
  const std::string onWire =
      wireTypeName(kind == Kind::Interface ? model::Named::Contract : model::Named::Type,
                   declaration, Mapping::peek(declaration, kind).name);
  report(wireDeclaration(space, onWire, mapping.context()), "wire::" + onWire);
}

}  // namespace suture::compiler::frontend
