#include "compiler/frontend/ast/default_content.h"

#include <clang/AST/ExprCXX.h>
#include <clang/AST/RecursiveASTVisitor.h>

namespace suture::compiler::frontend {
namespace {

/// Returns the first argument of a construction if it is the only one that is written, else null.
const clang::Expr* onlyArgument(const clang::CXXConstructExpr* construct) {
  if (construct->getNumArgs() == 0) return nullptr;
  for (unsigned i = 1; i < construct->getNumArgs(); ++i) {
    if (!construct->getArg(i)->isDefaultArgument()) return nullptr;
  }
  return construct->getArg(0);
}

/// Returns what a construction or conversion makes its value of; null if `expression` is neither.
const clang::Expr* below(const clang::Expr* expression) {
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(expression)) {
    return list->getNumInits() == 1 ? list->getInit(0) : nullptr;
  }
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(expression)) {
    return cast->getSubExpr();
  }
  const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(expression);
  return construct == nullptr ? nullptr : onlyArgument(construct);
}

/// Returns the first expression of its kind on the way down, or null if there is none.
template <class Kind>
const Kind* firstIn(const clang::Expr* expression) {
  while (expression != nullptr) {
    expression = expression->IgnoreImplicit()->IgnoreParens();
    if (const auto* found = llvm::dyn_cast<Kind>(expression)) return found;
    expression = below(expression);
  }
  return nullptr;
}

/// Evaluates whatever is a floating-point number below an expression.
class NanFinder : public clang::RecursiveASTVisitor<NanFinder> {
 public:
  explicit NanFinder(const clang::ASTContext& context) : context_(context) {}

  bool in(const clang::Expr* expression) {
    TraverseStmt(const_cast<clang::Expr*>(expression));  // the visitor changes nothing
    return found_;
  }

  bool VisitExpr(clang::Expr* expression) {
    if (expression->isInstantiationDependent()) return true;
    if (!expression->getType()->isRealFloatingType()) return true;
    clang::Expr::EvalResult result;
    found_ = expression->EvaluateAsRValue(result, context_) && result.Val.isFloat() &&
             result.Val.getFloat().isNaN();
    return !found_;
  }

 private:
  const clang::ASTContext& context_;
  bool found_ = false;
};

}  // namespace

const clang::StringLiteral* literalIn(const clang::Expr* initialiser) {
  return firstIn<clang::StringLiteral>(initialiser);
}

std::optional<std::size_t> lengthOf(const clang::Expr* initialiser) {
  if (const clang::StringLiteral* const literal = literalIn(initialiser)) {
    return literal->getByteLength();
  }
  const auto* const elements = firstIn<clang::CXXStdInitializerListExpr>(initialiser);
  if (elements == nullptr) return std::nullopt;
  const auto* const list =
      llvm::dyn_cast<clang::InitListExpr>(elements->getSubExpr()->IgnoreImplicit());
  return list == nullptr ? std::nullopt : std::optional<std::size_t>(list->getNumInits());
}

bool holdsNan(const clang::Expr* initialiser, const clang::ASTContext& context) {
  return NanFinder(context).in(initialiser);
}

}  // namespace suture::compiler::frontend
