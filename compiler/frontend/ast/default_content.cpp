#include "compiler/frontend/ast/default_content.h"

#include <clang/AST/ExprCXX.h>
#include <clang/AST/RecursiveASTVisitor.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

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

/// Holds the outcome of a constructor such as std::vector(3, 1.0).
struct Repeated {
  std::uint64_t count = 0;
  const clang::Expr* value = nullptr;  ///< null if it was not said
};

/// Looks into an initialiser and its type side by side, as far as both are alike.
class ContentFinder {
 public:
  explicit ContentFinder(const clang::ASTContext& context) : context_(context) {}

  DefaultContent in(const clang::Expr* initialiser, const model::Type& type) {
    visit(initialiser, type);
    return std::move(content_);
  }

 private:
  using Shape = model::Type::Shape;
  using Elements = std::span<clang::Expr* const>;

  void visit(const clang::Expr* expression, const model::Type& type) {
    switch (type.shape) {
      case Shape::Scalar: return addNumber(expression, type.scalar);
      case Shape::Text: return visitText(expression, type);
      case Shape::List:
      case Shape::Map: return visitList(expression, type);
      case Shape::Array: return visitArray(expression, type);
      case Shape::Optional:
        if (const clang::Expr* const held = heldIn(expression)) visit(held, type.element.front());
        return;
      default: return;
    }
  }

  /// Adds the number as a scalar of that kind holds it, since 0.7 is another number in a float.
  void addNumber(const clang::Expr* expression, model::Scalar kind) {
    clang::Expr::EvalResult result;
    if (expression->isInstantiationDependent()) return;
    if (!expression->EvaluateAsRValue(result, context_)) return;
    double number = 0;
    if (result.Val.isInt()) {
      const llvm::APSInt& value = result.Val.getInt();
      number = value.isSigned() ? static_cast<double>(value.getSExtValue())
                                : static_cast<double>(value.getZExtValue());
    } else if (result.Val.isFloat()) {
      llvm::APFloat value = result.Val.getFloat();
      bool inexact = false;
      value.convert(llvm::APFloat::IEEEdouble(), llvm::APFloat::rmNearestTiesToEven, &inexact);
      number = value.convertToDouble();
    } else {
      return;
    }
    if (kind == model::Scalar::Float32) number = static_cast<double>(static_cast<float>(number));
    const bool isReal = kind == model::Scalar::Float32 || kind == model::Scalar::Float64;
    content_.numbers.push_back(isReal ? number : std::trunc(number));
  }

  void compare(std::uint64_t length, const model::Type& type) {
    content_.isTooLong |= type.capacity.value_or(0) != 0 && length > *type.capacity;
  }

  void visitText(const clang::Expr* expression, const model::Type& type) {
    if (const clang::StringLiteral* const literal = literalIn(expression)) {
      compare(literal->getByteLength(), type);
    } else if (const auto characters = listedIn(expression)) {
      compare(characters->size(), type);
    } else if (const auto repeated = repeatedIn(expression)) {
      compare(repeated->count, type);
    }
  }

  void visitList(const clang::Expr* expression, const model::Type& type) {
    if (const auto elements = listedIn(expression)) {
      compare(elements->size(), type);
      for (const clang::Expr* const element : *elements) visitElement(element, type);
    } else if (const auto repeated = repeatedIn(expression)) {
      compare(repeated->count, type);
      if (repeated->count == 0) return;
      if (repeated->value != nullptr) {
        visitElement(repeated->value, type);
      } else if (type.element.back().shape == Shape::Scalar) {
        content_.numbers.push_back(0);
      }
    }
  }

  /// A range() of a map is that of its values, and so is a capacity() behind that of its keys.
  void visitElement(const clang::Expr* element, const model::Type& type) {
    if (type.shape != Shape::Map) return visit(element, type.element.front());
    const auto* const pair = firstIn<clang::CXXConstructExpr>(element);
    if (pair == nullptr || pair->getNumArgs() != 2) return;
    const model::Type& key = type.element.front();
    if (key.shape == Shape::Text) visitText(pair->getArg(0), key);
    visit(pair->getArg(1), type.element.back());
  }

  void visitArray(const clang::Expr* expression, const model::Type& type) {
    const clang::InitListExpr* list = listIn(expression);
    // A std::array holds an array.
    if (list != nullptr && list->getType()->isRecordType()) {
      list = list->getNumInits() == 1 ? listIn(list->getInit(0)) : nullptr;
    }
    if (list == nullptr) return;
    const model::Type& element = type.element.front();
    for (const clang::Expr* const one : list->inits()) visit(one, element);
    if (list->getNumInits() < type.rows && element.shape == Shape::Scalar) {
      content_.numbers.push_back(0);
    }
  }

  static const clang::InitListExpr* listIn(const clang::Expr* expression) {
    const auto* const list = llvm::dyn_cast<clang::InitListExpr>(expression->IgnoreImplicit());
    const bool written = list != nullptr && list->getSemanticForm() != nullptr;
    return written ? list->getSemanticForm() : list;
  }

  /// Returns the elements of a std::initializer_list, as of "std::vector{1, 2}".
  static std::optional<Elements> listedIn(const clang::Expr* expression) {
    const auto* const elements = firstIn<clang::CXXStdInitializerListExpr>(expression);
    const auto* const list =
        elements == nullptr
            ? nullptr
            : llvm::dyn_cast<clang::InitListExpr>(elements->getSubExpr()->IgnoreImplicit());
    if (list == nullptr) return std::nullopt;
    return Elements(list->inits().data(), list->getNumInits());
  }

  /// Returns the value that a std::optional is made of; null if there is none or it is not seen.
  static const clang::Expr* heldIn(const clang::Expr* expression) {
    const auto* const construct = firstIn<clang::CXXConstructExpr>(expression);
    return construct == nullptr ? nullptr : onlyArgument(construct);
  }

  /// Returns what a constructor of a count and a value makes, which may lie below copies.
  std::optional<Repeated> repeatedIn(const clang::Expr* expression) const {
    while (expression != nullptr) {
      expression = expression->IgnoreImplicit()->IgnoreParens();
      const auto* const construct = llvm::dyn_cast<clang::CXXConstructExpr>(expression);
      if (construct != nullptr && takesCount(construct)) {
        clang::Expr::EvalResult count;
        if (!construct->getArg(0)->EvaluateAsInt(count, context_)) return std::nullopt;
        const bool said = construct->getNumArgs() > 1 && !construct->getArg(1)->isDefaultArgument();
        const clang::Expr* const second = said ? construct->getArg(1) : nullptr;
        const bool isAllocator = said && second->getType()->isRecordType() &&
                                 construct->getConstructor()->getNumParams() == 2;
        return Repeated{count.Val.getInt().getZExtValue(), isAllocator ? nullptr : second};
      }
      expression = below(expression);
    }
    return std::nullopt;
  }

  /// The number that an unordered container is made of counts its buckets.
  static bool takesCount(const clang::CXXConstructExpr* construct) {
    const clang::CXXConstructorDecl* const constructor = construct->getConstructor();
    return construct->getNumArgs() > 0 && constructor->getParent()->isInStdNamespace() &&
           !constructor->getParent()->getName().starts_with("unordered_") &&
           constructor->getParamDecl(0)->getType()->isUnsignedIntegerType();
  }

  const clang::ASTContext& context_;
  DefaultContent content_;
};

}  // namespace

const clang::StringLiteral* literalIn(const clang::Expr* initialiser) {
  return firstIn<clang::StringLiteral>(initialiser);
}

DefaultContent contentOf(const clang::Expr* initialiser, const model::Type& type,
                         const clang::ASTContext& context) {
  return ContentFinder(context).in(initialiser, type);
}

bool holdsNan(const clang::Expr* initialiser, const clang::ASTContext& context) {
  return NanFinder(context).in(initialiser);
}

}  // namespace suture::compiler::frontend
