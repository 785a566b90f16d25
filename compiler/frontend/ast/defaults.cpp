#include "compiler/frontend/ast/defaults.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/Expr.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/frontend/ast/default_content.h"
#include "compiler/frontend/ast/initialiser.h"

namespace suture::compiler::frontend {
namespace {

using Shape = model::Type::Shape;
using State = Default::State;

std::string dumped(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string enumJson(const clang::EnumDecl* declaration, const llvm::APSInt& value) {
  for (const clang::EnumConstantDecl* enumerator : declaration->enumerators()) {
    if (llvm::APSInt::isSameValue(enumerator->getInitVal(), value)) {
      return dumped(enumerator->getNameAsString());
    }
  }
  return "";
}

Default enumerator(const clang::EnumDecl* declaration, const llvm::APSInt& value) {
  const std::string json = enumJson(declaration, value);
  return json.empty() ? Default{State::NoEnumerator} : Default{State::Constant, json};
}

/// Returns the enumerator whose value is 0, which C++ gives a member that says nothing. On the wire
/// it need not be the zero: that is the enumerator which the lock has first.
Default zeroOf(const clang::FieldDecl* field, const model::Type& type) {
  const auto* enumeration = field->getType()->getAs<clang::EnumType>();
  if (type.shape != Shape::Enum || enumeration == nullptr) return {};
  return enumerator(enumeration->getDecl(), llvm::APSInt::get(0));
}

/// Returns nothing where no enumerator has the value 0: then a receiver takes the first one.
Default zeroIfAny(const clang::FieldDecl* field, const model::Type& type) {
  const Default zero = zeroOf(field, type);
  return zero.state == State::Constant ? zero : Default{};
}

// JSON has no words for infinity; these are the ones that a schema uses.
Default real(double value) {
  if (std::isnan(value)) return {State::NotANumber};
  if (std::isinf(value)) return {State::Constant, value > 0 ? dumped("inf") : dumped("-inf")};
  return {State::Constant, dumped(value)};
}

double realOf(llvm::APFloat number) {
  bool inexact = false;
  number.convert(llvm::APFloat::IEEEdouble(), llvm::APFloat::rmNearestTiesToEven, &inexact);
  return number.convertToDouble();
}

std::string integerJson(const llvm::APSInt& value) {
  return value.isSigned() ? dumped(value.getSExtValue()) : dumped(value.getZExtValue());
}

Default scalar(clang::QualType type, const clang::APValue& value) {
  if (value.isFloat()) return real(realOf(value.getFloat()));
  if (!value.isInt()) return {State::NotConstant};
  if (const auto* enumeration = type->getAs<clang::EnumType>()) {
    return enumerator(enumeration->getDecl(), value.getInt());
  }
  if (!type->isBooleanType()) return {State::Constant, integerJson(value.getInt())};
  return {State::Constant, value.getInt().getBoolValue() ? "true" : "false"};
}

// Looks into classes of one number, such as durations and points in time.
const clang::APValue& onlyNumber(const clang::APValue& value) {
  const bool one =
      value.isStruct() && value.getStructNumBases() == 0 && value.getStructNumFields() == 1;
  return one ? onlyNumber(value.getStructField(0)) : value;
}

// Spells nanoseconds as seconds, exactly: 20,000,000 are "0.02".
std::string secondsJson(std::int64_t nanoseconds) {
  const std::uint64_t size = nanoseconds < 0 ? 0 - static_cast<std::uint64_t>(nanoseconds)
                                             : static_cast<std::uint64_t>(nanoseconds);
  std::string fraction = std::to_string(size % 1'000'000'000);
  fraction.insert(0, 9 - fraction.size(), '0');
  fraction.erase(std::max<std::size_t>(fraction.find_last_not_of('0') + 1, 1));
  return (nanoseconds < 0 ? "-" : "") + std::to_string(size / 1'000'000'000) + "." + fraction;
}

Default duration(const clang::APValue& value, const model::Type& type) {
  const clang::APValue& ticks = onlyNumber(value);
  if (ticks.isFloat()) {
    return real(realOf(ticks.getFloat()) * static_cast<double>(type.periodNumerator) /
                static_cast<double>(type.periodDenominator));
  }
  if (!ticks.isInt()) return {State::NotConstant};
  const std::int64_t tick = type.periodNumerator * (1'000'000'000 / type.periodDenominator);
  std::int64_t nanoseconds = 0;
  if (__builtin_mul_overflow(ticks.getInt().getExtValue(), tick, &nanoseconds)) {
    return {State::NotConstant};
  }
  return {State::Constant, secondsJson(nanoseconds)};
}

Default timePoint(const clang::APValue& value) {
  const clang::APValue& ticks = onlyNumber(value);
  return {ticks.isInt() && ticks.getInt() == 0 ? State::Nothing : State::NotConstant};
}

bool isNumber(const model::Type& type) {
  return type.shape == Shape::Scalar || type.shape == Shape::Enum ||
         type.shape == Shape::Duration || type.shape == Shape::TimePoint;
}

Default numberOf(const clang::Expr* initialiser, const clang::FieldDecl* field,
                 const model::Type& type) {
  clang::Expr::EvalResult result;
  if (!initialiser->EvaluateAsRValue(result, field->getASTContext())) return {State::NotConstant};
  switch (type.shape) {
    case Shape::Duration: return duration(result.Val, type);
    case Shape::TimePoint: return timePoint(result.Val);
    default: return scalar(field->getType().getCanonicalType(), result.Val);
  }
}

Default seenDefault(const clang::FieldDecl* field, const model::Type& type) {
  const clang::Expr* const initialiser = initialiserOf(field);
  if (initialiser == nullptr && field->hasInClassInitializer()) {
    return {isNumber(type) ? State::NotConstant : State::Nothing};
  }
  if (initialiser == nullptr) return zeroIfAny(field, type);
  if (initialiser->containsErrors()) return {};
  if (saysNothing(initialiser)) {
    // A template cannot name an enumerator of each of its arguments.
    const bool inTemplate = llvm::isa<clang::ClassTemplateSpecializationDecl>(field->getParent());
    return inTemplate ? zeroIfAny(field, type) : zeroOf(field, type);
  }
  if (isNumber(type)) return numberOf(initialiser, field, type);
  if (holdsNan(initialiser, field->getASTContext())) return {State::NotANumber};
  DefaultContent content = contentOf(initialiser, type, field->getASTContext());
  if (content.isTooLong) return {State::TooLong};
  const clang::StringLiteral* const literal = literalIn(initialiser);
  const bool text = literal != nullptr && literal->getCharByteWidth() == 1;
  if (text) return {State::Constant, dumped(literal->getString().str())};
  return {.numbers = std::move(content.numbers)};
}

}  // namespace

Default defaultOf(const clang::FieldDecl* field, const model::Type& type) {
  Default found = seenDefault(field, type);
  if (!mayBeAssigned(field)) return found;
  found.numbers.clear();
  if (isNumber(type)) found.state = State::Unseen;
  return found;
}

bool isPreset(const clang::FieldDecl* field) {
  if (mayBeAssigned(field)) return true;
  const clang::Expr* const initialiser = initialiserOf(field);
  if (initialiser == nullptr) return field->hasInClassInitializer();
  return !saysNothing(initialiser);
}

}  // namespace suture::compiler::frontend
