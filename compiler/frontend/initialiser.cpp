#include "compiler/frontend/initialiser.h"

#include <clang/AST/ExprCXX.h>
#include <clang/AST/Stmt.h>

#include <algorithm>

namespace suture::compiler::frontend {
namespace {

const clang::CXXConstructorDecl* definitionOf(const clang::CXXConstructorDecl* constructor) {
  const clang::FunctionDecl* definition = nullptr;
  if (!constructor->hasBody(definition)) return nullptr;
  return llvm::cast<clang::CXXConstructorDecl>(definition);
}

const clang::Expr* inConstructor(const clang::FieldDecl* field) {
  const clang::CXXConstructorDecl* constructor = writtenConstructor(field);
  if (constructor != nullptr) constructor = definitionOf(constructor);
  if (constructor == nullptr) return nullptr;
  for (const clang::CXXCtorInitializer* one : constructor->inits()) {
    if (one->isWritten() && one->getMember() == field) return one->getInit();
  }
  return nullptr;
}

// Clang instantiates that of a template's member when a constructor asks for it, and nobody does.
const clang::Expr* inTemplate(const clang::FieldDecl* field) {
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(field->getParent());
  const clang::CXXRecordDecl* pattern =
      record ? record->getTemplateInstantiationPattern() : nullptr;
  if (pattern == nullptr) return nullptr;
  const auto same =
      std::find_if(pattern->field_begin(), pattern->field_end(),
                   [&](const auto* one) { return one->getFieldIndex() == field->getFieldIndex(); });
  const clang::Expr* found = same == pattern->field_end() ? nullptr : same->getInClassInitializer();
  return found == nullptr || found->isInstantiationDependent() ? nullptr : found;
}

}  // namespace

const clang::Expr* initialiserOf(const clang::FieldDecl* field) {
  if (const clang::Expr* found = inConstructor(field)) return found;
  if (!field->hasInClassInitializer()) return nullptr;
  const clang::Expr* found = field->getInClassInitializer();
  return found != nullptr ? found : inTemplate(field);
}

bool saysNothing(const clang::Expr* initialiser) {
  initialiser = initialiser->IgnoreImplicit();
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(initialiser)) {
    const clang::InitListExpr* written = list->isSyntacticForm() ? list : list->getSyntacticForm();
    return written != nullptr && written->getNumInits() == 0;
  }
  if (llvm::isa<clang::ImplicitValueInitExpr, clang::CXXScalarValueInitExpr>(initialiser))
    return true;
  const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(initialiser);
  return construct != nullptr && construct->getNumArgs() == 0;
}

const clang::CXXConstructorDecl* writtenConstructor(const clang::FieldDecl* field) {
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(field->getParent());
  if (record == nullptr) return nullptr;
  for (const clang::CXXConstructorDecl* one : record->ctors()) {
    if (one->isDefaultConstructor() && one->isUserProvided()) return one;
  }
  return nullptr;
}

bool mayAssign(const clang::CXXConstructorDecl* constructor) {
  const clang::CXXConstructorDecl* const definition = definitionOf(constructor);
  if (definition == nullptr || definition->isDelegatingConstructor()) return true;
  const auto* body = llvm::dyn_cast_or_null<clang::CompoundStmt>(definition->getBody());
  return body == nullptr || !body->body_empty();
}

}  // namespace suture::compiler::frontend
