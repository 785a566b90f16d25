#include "compiler/lock/schema/default_value.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "compiler/lock/schema/wire_type.h"

namespace suture::compiler::lock {
namespace {

using Shape = model::Type::Shape;

/// Takes the quotes from a JSON string, and leaves anything else as it is.
std::string word(const std::string& json) {
  return json.starts_with('"') ? json.substr(1, json.size() - 2) : json;
}

/// Makes "20000000" of "0.02", digit by digit.
std::string nanoseconds(const std::string& seconds) {
  const std::size_t point = seconds.find('.');
  std::string digits = seconds.substr(0, point);
  const std::string fraction = point == std::string::npos ? "" : seconds.substr(point + 1);
  digits += fraction + std::string(9 - fraction.size(), '0');
  const std::size_t sign = digits.starts_with('-') ? 1 : 0;
  const std::size_t first = std::min(digits.find_first_not_of('0', sign), digits.size() - 1);
  return digits.erase(sign, first - sign);
}

/// Turns the seconds of a duration into nanoseconds, or into its own count where that is real.
std::string capnpDuration(const std::string& json, const model::Type& type) {
  if (json.starts_with('"')) return word(json);  // this is "inf" or "-inf"
  if (wireScalar(type) == model::Scalar::Int64) return nanoseconds(json);
  const double seconds = std::strtod(json.c_str(), nullptr);
  return capnpNumber(seconds * static_cast<double>(type.periodDenominator) /
                     static_cast<double>(type.periodNumerator));
}

std::string capnpEnumerator(const std::string& name, const model::Enum& type) {
  for (const model::Enumerator& enumerator : type.enumerators) {
    if (enumerator.name == name) return enumerator.wireName;
  }
  return "";
}

}  // namespace

std::string capnpNumber(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return std::string(text, end);
}

std::string capnpDefault(const model::Field& field, const model::Lookup& lookup) {
  const std::string& json = field.defaultJson;
  if (json.empty()) return "";
  const auto unlessZero = [](const std::string& text) {
    return text == "0" || text == "0.0" || text == "false" ? "" : text;
  };
  switch (field.type.shape) {
    case Shape::Scalar: return unlessZero(word(json));
    case Shape::Duration: return unlessZero(capnpDuration(json, field.type));
    case Shape::Enum:
      if (const model::Enum* const type = lookup.findEnum(field.type.name)) {
        return capnpEnumerator(word(json), *type);
      }
      return "";
    default: return "";
  }
}

}  // namespace suture::compiler::lock
