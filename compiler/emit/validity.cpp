// Which numbers a provider may act on: NaN and what lies outside a range() stop at the border.

#include <algorithm>

#include "compiler/emit/contract.h"
#include "compiler/emit/wire_form.h"

namespace suture::compiler::emit {
namespace {

using model::Type;
using Shape = Type::Shape;
using Range = std::optional<std::pair<double, double>>;

bool isReal(model::Scalar scalar) {
  return scalar == model::Scalar::Float32 || scalar == model::Scalar::Float64;
}

std::string within(const std::string& slot, const Range& range, double scale) {
  return "inRange(" + slot + ", " + number(range->first * scale) + ", " +
         number(range->second * scale) + ")";
}

std::string allOf(const std::string& slot, const std::string& parameter, const std::string& each) {
  return "allOf(" + slot + ", " + kBreak + "[](" + parameter + ") {" +
         lambdaBody("return " + each + ";") + "})";
}

/// Of an Eigen type.
std::string coefficientsCondition(const Type& type, const std::string& slot, const Range& range) {
  if (!range) return isReal(type.scalar) ? "isValid(" + slot + ")" : "";
  return allOf(slot, cxxScalar(type.scalar) + " element", within("element", range, 1));
}

std::string condition(const Type& type, const std::string& slot, const Range& range,
                      const Context& context, unsigned depth);

std::string sequenceCondition(const Type& type, const std::string& slot, const Range& range,
                              const Context& context, unsigned depth) {
  const Type& element = type.element.front();
  const std::string item = "element" + depthSuffix(depth);
  const std::string each = condition(element, item, range, context, depth + 1);
  if (each.empty()) return "";
  if (element.shape == Shape::Scalar && !range) return "isValid(" + slot + ")";
  const std::string itemType = slotType(element, context, context.header.cxxNamespace);
  return allOf(slot, "const " + itemType + "& " + item, each);
}

/// An expression of type bool; empty when there is nothing to check.
std::string condition(const Type& type, const std::string& slot, const Range& range,
                      const Context& context, unsigned depth) {
  switch (type.shape) {
    case Shape::Scalar:
      if (type.scalar == model::Scalar::Bool) return "";
      if (range) return within(slot, range, 1);
      return isReal(type.scalar) ? "isValid(" + slot + ")" : "";
    case Shape::Duration:
      return range ? within(slot, range, 1e9) : "";  // said in seconds, held in nanoseconds
    case Shape::Struct: return "isValid(" + slot + ")";
    case Shape::Enum:
    case Shape::Text:
    case Shape::TimePoint: return "";
    case Shape::Matrix:
    case Shape::Quaternion:
    case Shape::Isometry: return coefficientsCondition(type, slot, range);
    case Shape::List:
    case Shape::Array: return sequenceCondition(type, slot, range, context, depth);
  }
  return "";
}

}  // namespace

bool hasConditions(const std::vector<WireValue>& values, const Context& context) {
  return std::any_of(values.begin(), values.end(), [&](const WireValue& value) {
    return !condition(value.type, value.slot, value.range, context, 0).empty();
  });
}

void emitValidity(Code& code, const std::vector<WireValue>& values, const std::string& valid,
                  const std::string& invalid, const Context& context) {
  std::string rest;
  for (const WireValue& value : values) {
    const std::string one = condition(value.type, value.slot, value.range, context, 0);
    const bool hasLambda = one.find(kBody) != std::string::npos;
    if (hasLambda) code.open("if (!", one, ") {").line("return ", invalid, ";").close("}");
    if (one.empty() || hasLambda) continue;
    if (!rest.empty()) rest += std::string(" && ") + kBreak;
    rest += one;
  }
  if (rest.empty()) {
    code.line("return ", valid, ";");
  } else if (valid == "true") {
    code.line("return ", rest, ";");
  } else {
    code.line("return ", rest, " ? ", kBreakText, valid, " : ", kBreakText, invalid, ";");
  }
}

}  // namespace suture::compiler::emit
