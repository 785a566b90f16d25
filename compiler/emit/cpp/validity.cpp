#include "compiler/emit/cpp/validity.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "compiler/emit/text/contract.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

using model::Type;
using Shape = Type::Shape;
using Range = std::optional<std::pair<double, double>>;

bool isReal(model::Scalar scalar) {
  return scalar == model::Scalar::Float32 || scalar == model::Scalar::Float64;
}

std::string within(const std::string& slot, const Range& range) {
  return "suture::inRange(" + slot + ", " + cxxNumber(range->first) + ", " +
         cxxNumber(range->second) + ")";
}

bool usesPath(const std::string& condition) {
  return condition.find(", path") != std::string::npos;
}

std::string lambda(const std::string& parameter, const std::string& result) {
  const std::string capture = usesPath(result) ? "[path]" : "[]";
  return capture + "(" + parameter + ") {" + lambdaBody("return " + result + ";") + "}";
}

/// `path` is "nullptr" for a type whose elements have no single index in C++.
std::string allOf(const std::string& slot, const std::string& path, const std::string& parameter,
                  const std::string& each) {
  return "suture::allOf(" + slot + ", " + path + ", " + kBreak + lambda(parameter, each) + ")";
}

/// Returns the condition under which the coefficients of an Eigen type are valid.
std::string coefficientsCondition(const Type& type, const std::string& slot, const Range& range,
                                  unsigned depth) {
  const bool vector = type.shape == Shape::Matrix && (type.rows == 1 || type.columns == 1);
  if (!range && !isReal(type.scalar)) return "";
  if (!range) return "isValid(" + slot + (vector ? ", path)" : ")");
  const std::string item = "element" + depthSuffix(depth);
  return allOf(slot, vector ? "path" : "nullptr", cxxScalar(type.scalar) + " " + item,
               within(item, range));
}

/// Returns the lowest and the highest value of an integer, as near as a double comes to them.
std::pair<double, double> limitsOf(model::Scalar scalar) {
  const auto ofSigned = [](double half) { return std::pair{-half, half - 1}; };
  switch (scalar) {
    case model::Scalar::Int8: return ofSigned(0x1p7);
    case model::Scalar::Int16: return ofSigned(0x1p15);
    case model::Scalar::Int32: return ofSigned(0x1p31);
    case model::Scalar::UInt8: return {0, 0x1p8 - 1};
    case model::Scalar::UInt16: return {0, 0x1p16 - 1};
    case model::Scalar::UInt32: return {0, 0x1p32 - 1};
    case model::Scalar::UInt64: return {0, 0x1p64};
    default: return ofSigned(0x1p63);
  }
}

/// Tells if the runtime's isValid() has anything to check in the type.
bool isChecked(const Type& type) {
  switch (type.shape) {
    case Shape::Scalar:
    case Shape::AnyMatrix:
    case Shape::Matrix: return isReal(type.scalar);
    case Shape::Duration: return isReal(lock::wireScalar(type));
    case Shape::Quaternion:
    case Shape::Isometry:
    case Shape::Affine:
    case Shape::Struct:
    case Shape::Variant: return true;
    default: break;
  }
  return std::any_of(type.element.begin(), type.element.end(), isChecked);
}

/// Returns what the C++ type of a duration can count, as its slot does, if that holds more: a float
/// in its own unit, an integer in nanoseconds.
Range countedInSlot(const Type& type) {
  if (type.shape != Shape::Duration || type.scalar == model::Scalar::Float64) return std::nullopt;
  if (type.scalar == model::Scalar::Float32) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return std::pair{-kLargest, kLargest};
  }
  const double tick =
      1e9 * static_cast<double>(type.periodNumerator) / static_cast<double>(type.periodDenominator);
  const auto [lowest, highest] = limitsOf(type.scalar);
  constexpr double kSlot = 0x1p63;
  if (lowest * tick <= -kSlot && highest * tick >= kSlot) return std::nullopt;
  return std::pair{lowest * tick, highest * tick};
}

/// Tells if a slot, of the type or of a type in it, can hold a number that the C++ type does not
/// have, which the runtime's isValid() cannot know: the enum does not declare it, or the duration
/// cannot count so far.
bool isNarrower(const Type& type) {
  return type.shape == Shape::Enum || countedInSlot(type).has_value() ||
         std::any_of(type.element.begin(), type.element.end(), isNarrower);
}

/// Returns the condition of a type that one overload of the runtime's isValid() judges as a whole.
std::string wholeCondition(const Type& type, const std::string& slot) {
  return isChecked(type) ? "isValid(" + slot + ", path)" : "";
}

std::string condition(const Type& type, const std::string& slot, const Range& range,
                      const Context& context, unsigned depth);

std::string mapCondition(const Type& type, const std::string& slot, const Range& range,
                         const Context& context, unsigned depth) {
  if (!range && !isNarrower(type)) return wholeCondition(type, slot);
  const std::string item = "element" + depthSuffix(depth);
  const std::string key = condition(type.element.front(), item + ".key", {}, context, depth + 1);
  const std::string value =
      condition(type.element.back(), item + ".value", range, context, depth + 1);
  const std::string itemType = elementSlot(type, context, context.header.cxxNamespace);
  return allOf(slot, "path", "const " + itemType + "& " + item,
               key + (key.empty() || value.empty() ? "" : " && ") + value);
}

/// Returns the C++ of a function that tells if a slot of the type is valid.
std::string checkOf(const Type& type, const Context& context, unsigned depth) {
  if (type.shape == Shape::Enum) return enumCheck(type.name, context);
  if (!isNarrower(type)) return "suture::Valid{path}";
  const std::string item = "element" + depthSuffix(depth);
  const std::string itemType = slotType(type, context, context.header.cxxNamespace);
  return lambda("const " + itemType + "& " + item, condition(type, item, {}, context, depth + 1));
}

/// Returns the condition of a tuple or a variant, with a check for each of its types.
std::string eachCondition(const char* function, const Type& type, const std::string& slot,
                          const Context& context, unsigned depth) {
  if (!isNarrower(type)) return wholeCondition(type, slot);
  std::string checks;
  for (const Type& element : type.element) {
    checks += std::string(", ") + kBreak + checkOf(element, context, depth + 1);
  }
  return function + ("(" + slot) + ", path" + checks + ")";
}

/// Returns the condition of a duration, which has no range() of its own, but may be infinite where
/// it is by default.
std::string durationCondition(const Type& type, const std::string& slot, const Range& range) {
  if (range) return within(slot, range);
  if (const Range counted = countedInSlot(type)) return within(slot, counted);
  return isChecked(type) ? "isValid(" + slot + ")" : "";
}

std::string sequenceCondition(const Type& type, const std::string& slot, const Range& range,
                              const Context& context, unsigned depth) {
  const Type& element = type.element.front();
  const std::string item = "element" + depthSuffix(depth);
  const std::string each = condition(element, item, range, context, depth + 1);
  if (each.empty()) return "";
  if (element.shape == Shape::Scalar && !range) return "isValid(" + slot + ", path)";
  const std::string itemType = slotType(element, context, context.header.cxxNamespace);
  return allOf(slot, "path", "const " + itemType + "& " + item, each);
}

/// Returns an expression of type bool; it is empty when there is nothing to check.
std::string condition(const Type& type, const std::string& slot, const Range& range,
                      const Context& context, unsigned depth) {
  switch (type.shape) {
    case Shape::Scalar:
      if (type.scalar == model::Scalar::Bool) return "";
      if (range) return within(slot, range);
      return isReal(type.scalar) ? "isValid(" + slot + ")" : "";
    case Shape::Duration: return durationCondition(type, slot, range);
    case Shape::Struct: return "isValid(" + slot + ", path)";
    case Shape::Enum: return enumCheck(type.name, context) + "(" + slot + ")";
    case Shape::Text:
    case Shape::TimePoint:
    case Shape::Nothing: return "";
    case Shape::Matrix:
    case Shape::AnyMatrix:
    case Shape::Quaternion:
    case Shape::Isometry:
    case Shape::Affine: return coefficientsCondition(type, slot, range, depth);
    case Shape::Tuple: return eachCondition("suture::allItems", type, slot, context, depth);
    case Shape::Variant: return eachCondition("suture::theOneOf", type, slot, context, depth);
    case Shape::Map: return mapCondition(type, slot, range, context, depth);
    case Shape::Optional:
      if (!range && !isNarrower(type)) return wholeCondition(type, slot);
      [[fallthrough]];
    case Shape::List:
    case Shape::Array: return sequenceCondition(type, slot, range, context, depth);
  }
  return "";
}

std::string conditionOf(const WireValue& value, const Context& context) {
  return condition(value.type, value.slot, value.range, context, 0);
}

/// Returns the expression by which a check refuses the value.
std::string refusalOf(const WireValue& value) {
  return value.member.empty() ? "false" : "suture::refusedAt(path, \"" + value.member + "\")";
}

void emitRefusal(Code& code, const std::string& unless, const std::string& refusal) {
  const std::string line = "  if (!" + unless + ") return " + refusal + ";";
  const bool isOneLine = unless.find(kBody) == std::string::npos && line.size() <= Code::kColumns;
  if (isOneLine) {
    code.line("if (!", unless, ") return ", refusal, ";");
  } else {
    code.open("if (!", unless, ") {").line("return ", refusal, ";").close("}");
  }
}

constexpr std::string_view kStructCheck = "isValid";

std::string structCheck(const Type& type, const Context& context) {
  return qualifier(type.name, context).append(kStructCheck);
}

}  // namespace

std::string enumCheck(const std::string& enumName, const Context& context) {
  return qualifier(enumName, context) + "isKnown" +
         model::unqualified(generatedName(enumName, context.lookup));
}

bool isStructCheck(const std::string& check) { return check.ends_with(kStructCheck); }

std::string argumentsCheck(const model::Interface& interface, const model::Command& command,
                           const Context& context) {
  if (!hasConditions(argumentValues(command), context)) return "";
  return "accepts" + prefixOf(interface, context) + model::titleCase(command.wireName);
}

std::string resultCheck(const model::Interface& interface, const model::Command& command,
                        const Context& context) {
  if (!command.result || !hasConditions(resultValues(command), context)) return "";
  if (command.result->shape == Shape::Struct) return structCheck(*command.result, context);
  return "accepts" + prefixOf(interface, context) + model::titleCase(command.wireName) + "Result";
}

std::string payloadCheck(const model::Interface& interface, const model::Event& event,
                         const Context& context) {
  if (!hasConditions(payloadValues(event), context)) return "";
  if (event.payload.size() == 1 && event.payload.front().shape == Shape::Struct) {
    return structCheck(event.payload.front(), context);
  }
  return "accepts" + prefixOf(interface, context) + model::titleCase(event.wireName) + "Event";
}

bool hasConditions(const std::vector<WireValue>& values, const Context& context) {
  return std::any_of(values.begin(), values.end(),
                     [&](const WireValue& value) { return !conditionOf(value, context).empty(); });
}

std::string validityParameters(const std::string& slot, const std::vector<WireValue>& values,
                               const Context& context) {
  const bool tells = std::any_of(values.begin(), values.end(), [&](const WireValue& value) {
    const std::string one = conditionOf(value, context);
    return !one.empty() && (usesPath(one) || !value.member.empty());
  });
  return "const " + slot + (hasConditions(values, context) ? "& slot, " : "&, ") + kBreak +
         (tells ? "suture::FieldPath* path" : "suture::FieldPath*");
}

void emitValidity(Code& code, const std::vector<WireValue>& values, const Context& context) {
  std::vector<const WireValue*> checked;
  for (const WireValue& value : values) {
    if (!conditionOf(value, context).empty()) checked.push_back(&value);
  }
  std::string last = "true";
  for (const WireValue* const value : checked) {
    const std::string one = conditionOf(*value, context);
    const std::string refusal = refusalOf(*value);
    if (value != checked.back() || one.find(kBody) != std::string::npos) {
      emitRefusal(code, one, refusal);
    } else {
      last = value->member.empty() ? one : one + " || " + kBreak + refusal;
    }
  }
  code.line("return ", last, ";");
}

}  // namespace suture::compiler::emit
