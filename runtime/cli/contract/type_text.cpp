#include "cli/contract/type_text.h"

namespace suture::cli {
namespace {

/// Returns "at most 16 of ".
std::string boundText(const Json& type) {
  const Json& capacity = valueAt(type, "capacity");
  return capacity.is_number_integer() ? "at most " + capacity.dump() + " of " : "";
}

std::string listText(const Json& types, const char* between) {
  std::string text;
  for (const Json& one : types) text += (text.empty() ? "" : between) + typeText(one);
  return text;
}

std::string matrixText(const Json& type) {
  const Json &rows = valueAt(type, "rows"), &columnCount = valueAt(type, "columns");
  const std::string scalar = textAt(type, "scalar");
  if (columnCount == 1) return "vector of " + rows.dump() + " " + scalar;
  return rows.dump() + " x " + columnCount.dump() + " matrix of " + scalar;
}

std::string clockTypeText(const Json& type) {
  return "time, ns of the " + textAt(type, "clock") + " clock";
}

}  // namespace

std::string typeText(const Json& type) {
  std::string kind = textAt(type, "kind");
  const Json& element = valueAt(type, "element");
  if (kind == "struct" || kind == "enum") return textAt(type, "name");
  if (kind == "text") {
    const Json& capacity = valueAt(type, "capacity");
    return capacity.is_number_integer() ? "text of at most " + capacity.dump() + " bytes" : kind;
  }
  if (kind == "list" || kind == "set") return kind + " of " + boundText(type) + typeText(element);
  if (kind == "array") return valueAt(type, "length").dump() + " of " + typeText(element);
  if (kind == "matrix") return matrixText(type);
  if (kind == "any matrix") return "matrix of " + textAt(type, "scalar");
  if (kind == "quaternion") return "quaternion w, x, y, z";
  if (kind == "isometry") return "rotation and translation";
  if (kind == "affine") return "affine transform";
  if (kind == "duration") return "duration, ns";
  if (kind == "time") return clockTypeText(type);
  if (kind == "optional") return "optional " + typeText(element);
  if (kind == "variant") return listText(listAt(type, "alternatives"), " or ");
  if (kind == "tuple") return listText(listAt(type, "elements"), " and ");
  if (kind == "map") {
    return "map of " + boundText(type) + typeText(valueAt(type, "key")) + " to " +
           typeText(valueAt(type, "value"));
  }
  return kind;
}

std::string valueTypeText(const Json& described) {
  std::string text = typeText(valueAt(described, "type"));
  if (const std::string unit = textAt(described, "unit"); !unit.empty()) text += " [" + unit + "]";
  const Json& range = valueAt(described, "range");
  if (range.is_array() && range.size() == 2) {
    const auto bound = [](const Json& one) {  // "-inf" and "inf" are words
      return one.is_string() ? one.get<std::string>() : one.dump();
    };
    text += ", " + bound(range[0]) + " to " + bound(range[1]);
  }
  return text;
}

}  // namespace suture::cli
