#include "compiler/frontend/ast/initialiser.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/AST/Stmt.h>

#include <algorithm>

namespace suture::compiler::frontend {
namespace {

// Returns the default constructor that a user wrote, or null. If it is a template that can be
// called without arguments, this returns its pattern, because clang shows no more of it.
const clang::CXXConstructorDecl* writtenConstructor(const clang::CXXRecordDecl* record) {
  for (const clang::CXXConstructorDecl* one : record->ctors()) {
    if (one->isDefaultConstructor()) return one->isUserProvided() ? one : nullptr;
  }
  for (const clang::Decl* one : record->decls()) {
    const auto* pattern = llvm::isa<clang::FunctionTemplateDecl>(one)
                              ? llvm::dyn_cast<clang::CXXConstructorDecl>(one->getAsFunction())
                              : nullptr;
    if (pattern != nullptr && pattern->isDefaultConstructor()) return pattern;
  }
  return nullptr;
}

const clang::CXXConstructorDecl* writtenConstructor(const clang::FieldDecl* field) {
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(field->getParent());
  return record == nullptr ? nullptr : writtenConstructor(record);
}

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

// Looks into the pattern, since clang instantiates an initialiser only for a constructor that asks.
const clang::Expr* inTemplate(const clang::FieldDecl* field) {
  const clang::FieldDecl* const pattern = patternOf(field);
  const clang::Expr* found = pattern == field ? nullptr : pattern->getInClassInitializer();
  return found == nullptr || found->isInstantiationDependent() ? nullptr : found;
}

// Tells if what the constructor does cannot be seen in its body, because it delegates to another
// constructor or is defined in another file.
bool isElsewhere(const clang::CXXConstructorDecl* constructor) {
  const clang::CXXConstructorDecl* const definition = definitionOf(constructor);
  return definition == nullptr || definition->isDelegatingConstructor();
}

/// Looks in a constructor's body for a member, or for a call that may set any.
class Mentions : public clang::RecursiveASTVisitor<Mentions> {
 public:
  explicit Mentions(const clang::FieldDecl* field) : field_(field) {}

  bool in(clang::Stmt* body) {
    TraverseStmt(body);
    return found_;
  }

  bool VisitMemberExpr(clang::MemberExpr* one) { return go(one->getMemberDecl() == field_); }
  bool VisitCXXThisExpr(clang::CXXThisExpr* one) { return go(!one->isImplicit()); }
  bool VisitCXXMemberCallExpr(clang::CXXMemberCallExpr* one) {
    return go(llvm::isa<clang::CXXThisExpr>(one->getImplicitObjectArgument()->IgnoreImpCasts()));
  }

 private:
  bool go(bool found) {
    found_ = found_ || found;
    return !found_;
  }

  const clang::FieldDecl* const field_;
  bool found_ = false;
};

}  // namespace

const clang::Expr* initialiserOf(const clang::FieldDecl* field) {
  if (const clang::Expr* found = inConstructor(field)) {
    return found->isInstantiationDependent() ? nullptr : found;
  }
  if (!field->hasInClassInitializer()) return nullptr;
  const clang::Expr* found = field->getInClassInitializer();
  return found != nullptr ? found : inTemplate(field);
}

const clang::FieldDecl* patternOf(const clang::FieldDecl* field) {
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(field->getParent());
  const clang::CXXRecordDecl* const pattern =
      record ? record->getTemplateInstantiationPattern() : nullptr;
  if (pattern == nullptr) return field;
  const auto same =
      std::find_if(pattern->field_begin(), pattern->field_end(),
                   [&](const auto* one) { return one->getFieldIndex() == field->getFieldIndex(); });
  return same == pattern->field_end() ? field : *same;
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

bool mayBeAssigned(const clang::FieldDecl* field) {
  const clang::CXXConstructorDecl* const constructor = writtenConstructor(field);
  if (constructor == nullptr) return false;
  if (const clang::Expr* found = inConstructor(field)) return found->isInstantiationDependent();
  return isElsewhere(constructor) || Mentions(field).in(definitionOf(constructor)->getBody());
}

bool mayBeInitialised(const clang::CXXRecordDecl* record, const clang::CXXBaseSpecifier& base) {
  const clang::CXXConstructorDecl* const constructor = writtenConstructor(record);
  if (constructor == nullptr) return false;
  if (isElsewhere(constructor)) return true;
  const clang::CXXConstructorDecl* const definition = definitionOf(constructor);
  const auto* body = llvm::dyn_cast<clang::CompoundStmt>(definition->getBody());
  const bool listed = std::any_of(
      definition->init_begin(), definition->init_end(), [&](const clang::CXXCtorInitializer* one) {
        return one->isWritten() && one->isBaseInitializer() &&
               record->getASTContext().hasSameType(clang::QualType(one->getBaseClass(), 0),
                                                   base.getType());
      });
  return listed || body == nullptr || !body->body_empty();
}

}  // namespace suture::compiler::frontend
