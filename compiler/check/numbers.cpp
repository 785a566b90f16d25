#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "compiler/check/rules.h"
#include "compiler/check/units.h"

namespace suture::compiler::check {
namespace {

using Range = std::optional<std::pair<double, double>>;

std::string shown(double number) {
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  return nlohmann::json(number).dump();
}

class NumberRule {
 public:
  explicit NumberRule(model::Diagnostics& findings) : findings_(findings) {}

  void apply(const std::string& subject, const std::string& unit, const Range& range,
             const model::Source& source) {
    if (!unit.empty() && !isKnownUnit(unit)) {
      const std::optional<std::string> meant = nearestUnit(unit);
      addError(findings_, source, "unknown-unit", subject + " has the unknown unit '" + unit + "'",
               meant ? "did you mean '" + *meant + "'?"
                     : "units are those of SI, spelled as in UCUM: 'm', 'rad/s', 'N.m'");
    }
    if (range && !(range->first <= range->second)) {
      addError(
          findings_, source, "range-order",
          subject + " has an empty range: " + shown(range->first) + " to " + shown(range->second),
          "give the lowest value first; neither may be NaN");
    }
  }

  /// Reports a default out of range: a sender that leaves the field as it is, or that is older and
  /// lacks it, would have each message refused.
  void applyDefault(const model::Field& field) {
    if (!field.range || field.range->first > field.range->second) return;
    for (const double value : field.defaultNumbers) {
      if (applyDefault(field, "has", value)) return;
    }
    if (hasKnownNumber(field)) applyDefault(field, "is", defaultOf(field));
  }

 private:
  /// Returns true after an error.
  bool applyDefault(const model::Field& field, const char* verb, double value) {
    const bool isWithin = value >= boundOf(field.type, field.range->first) &&
                          value <= boundOf(field.type, field.range->second);
    if (isWithin) return false;
    addError(findings_, field.source, "default-range",
             "field '" + field.name + "' " + verb + " " + shown(value) +
                 " by default, outside its range " + shown(field.range->first) + " to " +
                 shown(field.range->second),
             "give it a default within its range, or make it a std::optional");
    return true;
  }

  /// Returns true for a number whose default was seen, and for several numbers that are all 0
  /// because no constructor or initialiser says anything else.
  static bool hasKnownNumber(const model::Field& field) {
    using Shape = model::Type::Shape;
    const model::Type& type = field.type;
    const bool unseen = field.isPreset && field.defaultJson.empty();
    if (type.shape == Shape::Scalar) return !unseen;
    const bool fixed = type.shape == Shape::Matrix ||
                       (type.shape == Shape::Array && type.element.front().shape == Shape::Scalar);
    return fixed && !field.isPreset;
  }

  /// Returns a bound as generated code compares a number with it: a float with the nearest float.
  static double boundOf(const model::Type& type, double bound) {
    if (!type.element.empty()) return boundOf(type.element.back(), bound);
    const bool isFloat =
        type.shape == model::Type::Shape::Scalar && type.scalar == model::Scalar::Float32;
    return isFloat ? static_cast<double>(static_cast<float>(bound)) : bound;
  }

  static double defaultOf(const model::Field& field) {
    const std::string& json = field.defaultJson;
    return std::strtod(json.c_str() + (json.starts_with('"') ? 1 : 0), nullptr);
  }

  model::Diagnostics& findings_;
};

void checkNumbersOf(const model::Interface& interface, NumberRule& rule) {
  for (const model::Command& command : interface.commands) {
    for (const model::Parameter& parameter : command.parameters) {
      rule.apply("parameter '" + parameter.name + "'", parameter.unit, parameter.range,
                 parameter.source);
    }
    rule.apply("the result of '" + command.name + "'", command.resultUnit, command.resultRange,
               command.source);
  }
  for (const model::Event& event : interface.events) {
    for (const model::Limits& limits : event.limits) {
      rule.apply("the payload of '" + event.name + "'", limits.unit, limits.range, event.source);
    }
  }
}

}  // namespace

void checkNumbers(const model::Header& header, model::Diagnostics& findings) {
  NumberRule rule(findings);
  for (const model::Struct& type : header.structs) {
    for (const model::Field& field : type.fields) {
      rule.apply("field '" + field.name + "'", field.unit, field.range, field.source);
      rule.applyDefault(field);
    }
  }
  for (const model::Interface& interface : header.interfaces) checkNumbersOf(interface, rule);
}

}  // namespace suture::compiler::check
