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
    if (named && !(space && space->isInline())) {
      return joined(scopeOf(context->getParent()), named->getNameAsString());
    }
    context = context->getParent();
  }
  return "";
}

// Names in capitals are taken as words: capnp would spell FOO's constant as F_O_O.
std::string quiet(std::string name) {
  if (name.find_first_of("abcdefghijklmnopqrstuvwxyz") != std::string::npos) return name;
  return llvm::StringRef(name).lower();
}

}  // namespace

std::string qualifiedName(const clang::NamedDecl* declaration) {
  return joined(scopeOf(declaration->getDeclContext()), declaration->getNameAsString());
}

std::string namespaceOf(const clang::Decl* declaration) {
  return scopeOf(declaration->getDeclContext()->getEnclosingNamespaceContext());
}

std::string wireTypeName(const clang::NamedDecl* declaration,
                         const std::optional<std::string>& given) {
  return given ? *given : model::titleCase(model::camelCase(declaration->getNameAsString()));
}

std::string wireMemberName(const std::string& cxxName, const std::optional<std::string>& given) {
  return model::camelCase(quiet(given.value_or(cxxName)));
}

}  // namespace suture::compiler::frontend
