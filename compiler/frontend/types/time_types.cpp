#include "compiler/frontend/types/time_types.h"

#include <optional>

#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/types/scalars.h"

namespace suture::compiler::frontend {
namespace {

using Specialisation = clang::ClassTemplateSpecializationDecl;

struct Ratio {
  std::int64_t numerator = 1, denominator = 1;
  bool operator==(const Ratio&) const = default;
};

constexpr Ratio kNano{1, 1'000'000'000};

std::optional<Ratio> ratioOf(const clang::TemplateArgument& argument) {
  const auto* type =
      llvm::dyn_cast_or_null<Specialisation>(argument.getAsType()->getAsCXXRecordDecl());
  if (!type || qualifiedName(type->getSpecializedTemplate()) != "std::ratio") return std::nullopt;
  return Ratio{type->getTemplateArgs()[0].getAsIntegral().getSExtValue(),
               type->getTemplateArgs()[1].getAsIntegral().getSExtValue()};
}

// Returns the library's own name for common durations, which a reader of generated code expects.
std::string spellingOf(const model::Type& rep, Ratio period) {
  if (rep.spelling == "std::int64_t") {
    if (period == kNano) return "std::chrono::nanoseconds";
    if (period == Ratio{1, 1'000'000}) return "std::chrono::microseconds";
    if (period == Ratio{1, 1'000}) return "std::chrono::milliseconds";
    if (period == Ratio{1, 1}) return "std::chrono::seconds";
    if (period == Ratio{60, 1}) return "std::chrono::minutes";
    if (period == Ratio{3600, 1}) return "std::chrono::hours";
  }
  if (period == Ratio{1, 1}) return "std::chrono::duration<" + rep.spelling + ">";
  return "std::chrono::duration<" + rep.spelling + ", std::ratio<" +
         std::to_string(period.numerator) + ", " + std::to_string(period.denominator) + ">>";
}

}  // namespace

MappedType mapDuration(const Specialisation* type, const NamedTypes&) {
  const clang::QualType rep = type->getTemplateArgs()[0].getAsType().getCanonicalType();
  const std::optional<Ratio> period = ratioOf(type->getTemplateArgs()[1]);
  const auto* builtin = rep->getAs<clang::BuiltinType>();
  if (!builtin || !period || builtin->getKind() == clang::BuiltinType::Bool) {
    return TypeProblem{"unsupported-duration", "its representation is not a plain number",
                       "use a std::chrono duration, such as std::chrono::milliseconds"};
  }
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  const bool exact = kNanoseconds % period->denominator == 0 || builtin->isFloatingPoint();
  if (!exact) {
    return TypeProblem{"unsupported-duration", "its ticks are no whole nanoseconds",
                       "use std::chrono::nanoseconds, or a representation of double"};
  }
  MappedType mapped = mapBuiltin(builtin);
  if (auto* duration = std::get_if<model::Type>(&mapped)) {
    duration->shape = model::Type::Shape::Duration;
    duration->periodNumerator = period->numerator;
    duration->periodDenominator = period->denominator;
    duration->spelling = spellingOf(*duration, *period);
  }
  return mapped;
}

MappedType mapTimePoint(const Specialisation* type, const NamedTypes&) {
  const auto* clock = type->getTemplateArgs()[0].getAsType()->getAsCXXRecordDecl();
  const std::string name = clock ? qualifiedName(clock) : "";
  const auto* duration = llvm::dyn_cast_or_null<Specialisation>(
      type->getTemplateArgs()[1].getAsType()->getAsCXXRecordDecl());
  model::Type mapped;
  mapped.shape = model::Type::Shape::TimePoint;
  mapped.clock = name == "std::chrono::steady_clock" ? model::Clock::Steady : model::Clock::System;
  mapped.spelling = name + "::time_point";
  const bool known = name == "std::chrono::steady_clock" || name == "std::chrono::system_clock";
  const bool nanoseconds =
      duration &&
      duration->getTemplateArgs()[0].getAsType()->isSpecificBuiltinType(clang::BuiltinType::Long) &&
      ratioOf(duration->getTemplateArgs()[1]) == kNano;
  if (!known || !nanoseconds) {
    return TypeProblem{"unsupported-stamp",
                       known ? "a stamp counts nanoseconds in a std::int64_t"
                             : "a stamp is a time_point of the steady or system clock",
                       "use suture::Time, or std::chrono::system_clock::time_point"};
  }
  return mapped;
}

}  // namespace suture::compiler::frontend
