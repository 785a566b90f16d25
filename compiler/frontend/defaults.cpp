#include "compiler/frontend/defaults.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>
#include <clang/AST/ExprCXX.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace suture::compiler::frontend {
namespace {

std::string dumped(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// The string literal below the conversions and constructions around it; null if there is more than
// one.
const clang::StringLiteral* literalIn(const clang::Expr* expression) {
  expression = expression->IgnoreImplicit()->IgnoreParens();
  if (const auto* literal = llvm::dyn_cast<clang::StringLiteral>(expression)) return literal;
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(expression)) {
    return list->getNumInits() == 1 ? literalIn(list->getInit(0)) : nullptr;
  }
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(expression)) {
    return literalIn(cast->getSubExpr());
  }
  const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(expression);
  if (!construct || construct->getNumArgs() == 0) return nullptr;
  for (unsigned i = 1; i < construct->getNumArgs(); ++i) {
    if (!construct->getArg(i)->isDefaultArgument()) return nullptr;
  }
  return literalIn(construct->getArg(0));
}

std::string enumJson(const clang::EnumDecl* declaration, const llvm::APSInt& value) {
  for (const clang::EnumConstantDecl* enumerator : declaration->enumerators()) {
    if (llvm::APSInt::isSameValue(enumerator->getInitVal(), value)) {
      return dumped(enumerator->getNameAsString());
    }
  }
  return "";
}

std::string scalarJson(clang::QualType type, const clang::APValue& value) {
  if (value.isFloat()) {
    llvm::APFloat number = value.getFloat();
    bool inexact = false;
    number.convert(llvm::APFloat::IEEEdouble(), llvm::APFloat::rmNearestTiesToEven, &inexact);
    const double plain = number.convertToDouble();
    return std::isfinite(plain) ? dumped(plain) : "";
  }
  if (!value.isInt()) return "";
  if (const auto* enumeration = type->getAs<clang::EnumType>()) {
    return enumJson(enumeration->getDecl(), value.getInt());
  }
  if (type->isBooleanType()) return value.getInt().getBoolValue() ? "true" : "false";
  return value.getInt().isSigned() ? dumped(value.getInt().getSExtValue())
                                   : dumped(value.getInt().getZExtValue());
}

}  // namespace

bool isConstant(const clang::Expr* initialiser, const clang::ASTContext& context) {
  const auto* list = llvm::dyn_cast<clang::InitListExpr>(initialiser->IgnoreImplicit());
  if (list && list->getNumInits() == 0) return true;
  clang::Expr::EvalResult result;
  return initialiser->EvaluateAsRValue(result, context);
}

std::string defaultJsonOf(const clang::FieldDecl* field) {
  const clang::Expr* initialiser = field->getInClassInitializer();
  if (!initialiser || initialiser->containsErrors()) return "";
  const clang::QualType type = field->getType().getCanonicalType();
  if (type->isArithmeticType() || type->isEnumeralType()) {
    if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(initialiser->IgnoreImplicit())) {
      if (list->getNumInits() == 0) return "";
    }
    clang::Expr::EvalResult result;
    if (!initialiser->EvaluateAsRValue(result, field->getASTContext())) return "";
    return scalarJson(type, result.Val);
  }
  const clang::StringLiteral* literal = literalIn(initialiser);
  const bool text = literal && literal->getCharByteWidth() == 1;
  return text ? dumped(literal->getString().str()) : "";
}

}  // namespace suture::compiler::frontend
