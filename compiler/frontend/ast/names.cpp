#include "compiler/frontend/ast/names.h"

#include <clang/AST/DeclCXX.h>

#include "compiler/model/naming.h"

namespace suture::compiler::frontend {
namespace {

std::string joined(const std::string& scope, const std::string& name) {
  return scope.empty() ? name : scope + "::" + name;
}

std::string scopeOf(const clang::DeclContext* context) {
  while (context && !context->isTranslationUnit()) {
    const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(context);
    const auto* named = llvm::dyn_cast<clang::NamedDecl>(context);
    if (named && !(space && (space->isInline() || space->isAnonymousNamespace()))) {
      return joined(scopeOf(context->getParent()), plainName(named));
    }
    context = context->getParent();
  }
  return "";
}

std::string titled(const std::string& name) { return model::titleCase(model::camelCase(name)); }

// Takes names in capitals as words, because capnp would spell FOO's constant as F_O_O.
std::string quiet(std::string name) {
  if (name.find_first_of("abcdefghijklmnopqrstuvwxyz") != std::string::npos) return name;
  return llvm::StringRef(name).lower();
}

}  // namespace

std::string plainName(const clang::NamedDecl* declaration) {
  const auto* tag = llvm::dyn_cast<clang::TagDecl>(declaration);
  const clang::NamedDecl* alias = tag ? tag->getTypedefNameForAnonDecl() : nullptr;
  return (alias ? alias : declaration)->getNameAsString();
}

std::string qualifiedName(const clang::NamedDecl* declaration) {
  return joined(scopeOf(declaration->getDeclContext()), plainName(declaration));
}

std::string rootedName(const clang::NamedDecl* declaration) {
  return (namespaceOf(declaration).empty() ? "::" : "") + qualifiedName(declaration);
}

std::string namespaceOf(const clang::Decl* declaration) {
  return scopeOf(declaration->getDeclContext()->getEnclosingNamespaceContext());
}

std::string wireTypeName(model::Named kind, const clang::NamedDecl* declaration,
                         const std::optional<std::string>& given) {
  if (given) return *given;
  std::string name = titled(plainName(declaration));
  for (const clang::DeclContext* scope = declaration->getDeclContext(); scope->isRecord();
       scope = scope->getParent()) {
    name = titled(plainName(llvm::cast<clang::TagDecl>(scope))) + name;
  }
  return model::freeName(kind, std::move(name));
}

std::string wireMemberName(const std::string& cxxName, const std::optional<std::string>& given) {
  return model::camelCase(quiet(given.value_or(cxxName)));
}

std::string wireMemberName(model::Named kind, const std::string& cxxName,
                           const std::optional<std::string>& given) {
  std::string name = wireMemberName(cxxName, given);
  return given ? name : model::freeName(kind, std::move(name));
}

}  // namespace suture::compiler::frontend
