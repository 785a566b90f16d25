#include "compiler/frontend/generated_names.h"

#include <clang/AST/DeclTemplate.h>

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

}  // namespace

void checkGeneratedNames(const clang::TagDecl* declaration, Kind kind, Mapping& mapping) {
  if (namespaceOf(declaration) == "suture") return;  // there the names are the runtime's
  const clang::DeclContext* space = declaration->getDeclContext()->getRedeclContext();
  for (const std::string& name : namesFor(declaration, kind)) {
    const clang::NamedDecl* found = ownDeclaration(space, name, mapping.context());
    if (!found || !mapping.once(found)) continue;
    model::Diagnostic& finding = mapping.error(
        found, "generated-name", "the code generated for this namespace declares '" + name + "'",
        "choose another name, or another namespace");
    if (found == declaration) continue;
    finding.notes.push_back(
        {mapping.sourceOf(declaration), "it is generated for what this header annotates"});
  }
}

}  // namespace suture::compiler::frontend
