#include "compiler/emit/docs/page_types.h"

#include <map>
#include <nlohmann/json.hpp>

#include "compiler/emit/docs/markdown.h"
#include "compiler/emit/text/call_words.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

using model::Type;
using Shape = Type::Shape;

/// Returns the C++ type without "std::" and "_t", in code: "int32" or "double".
std::string scalarWords(model::Scalar scalar) {
  if (scalar == model::Scalar::Float64) return "`double`";
  if (scalar == model::Scalar::Float32) return "`float`";
  std::string name(lock::capnpScalar(scalar));
  for (char& c : name) c = static_cast<char>(c | 0x20);
  return inCode(name);
}

/// Puts brackets around a part that has a comma in it.
std::string part(const std::string& words) {
  return words.find(", ") == std::string::npos ? words : "(" + words + ")";
}

std::string bound(const std::optional<unsigned>& capacity, const char* unit = "") {
  return capacity ? ", at most " + std::to_string(*capacity) + unit : "";
}

std::string extents(unsigned rows, unsigned columns) {
  return std::to_string(rows) + " x " + std::to_string(columns);
}

std::string matrix(const Type& type) {
  const std::string scalar = scalarWords(type.scalar);
  if (type.columns == 1) return "vector of " + std::to_string(type.rows) + " " + scalar;
  return extents(type.rows, type.columns) + " matrix of " + scalar;
}

std::string anyMatrix(const Type& type) {
  std::string words = "matrix of " + scalarWords(type.scalar);
  if (!type.capacity && !type.columnCapacity) return words;
  if (!type.columnCapacity) return words + bound(type.capacity, " rows");
  if (!type.capacity) return words + bound(type.columnCapacity, " columns");
  return words + ", at most " + extents(*type.capacity, *type.columnCapacity);
}

std::string duration(const Type& type) {
  static const std::map<std::pair<std::int64_t, std::int64_t>, const char*> kPeriods{
      {{1, 1}, "s"},    {{1, 1'000}, "ms"}, {{1, 1'000'000}, "us"}, {{1, 1'000'000'000}, "ns"},
      {{60, 1}, "min"}, {{3600, 1}, "h"}};
  const auto known = kPeriods.find({type.periodNumerator, type.periodDenominator});
  if (known != kPeriods.end()) return std::string("duration in ") + known->second;
  return "duration in " + std::to_string(type.periodNumerator) + "/" +
         std::to_string(type.periodDenominator) + " s";
}

/// Returns the initialiser as the header has it, from its JSON.
std::string defaultWords(const model::Field& field) {
  const std::string& json = field.defaultJson;
  if (json.empty()) return "";
  const auto value = nlohmann::json::parse(json);
  const char* const unit = field.type.shape == model::Type::Shape::Duration ? " s" : "";
  return inCode((value.is_string() ? value.get<std::string>() : json) + unit);
}

std::string about(const model::Documentation& doc, const model::Lifecycle& lifecycle) {
  const std::string more = lifecycleWords(lifecycle);
  return prose(doc.text) + (doc.text.empty() || more.empty() ? "" : " ") + more;
}

std::string paragraph(const std::string& text) { return text.empty() ? "" : text + "\n\n"; }

}  // namespace

std::string lifecycleWords(const model::Lifecycle& lifecycle) {
  std::string words;
  if (lifecycle.since) words = "Since version " + std::to_string(*lifecycle.since) + ".";
  if (lifecycle.deprecated.empty()) return words;
  return words + (words.empty() ? "" : " ") + "**Deprecated:** " + prose(lifecycle.deprecated) +
         ".";
}

std::string PageTypes::words(const Type& type) const {
  const std::string bytes = type.bulk ? ", one block of bytes on the wire" : "";
  switch (type.shape) {
    case Shape::Scalar: return scalarWords(type.scalar);
    case Shape::Enum:
    case Shape::Struct: return words(type.name);
    case Shape::Text: return "text" + bound(type.capacity, " bytes");
    case Shape::Array:
    case Shape::List: return sequence(type) + bytes;
    case Shape::Matrix: return matrix(type) + bytes;
    case Shape::Quaternion: return "quaternion (w, x, y, z)";
    case Shape::Isometry: return "rotation and translation";
    case Shape::Affine: return "affine transform";
    case Shape::Duration: return duration(type);
    case Shape::TimePoint:
      return type.clock == model::Clock::Steady ? "stamp (steady clock)" : "stamp (system clock)";
    case Shape::AnyMatrix: return anyMatrix(type) + bytes;
    default: return composite(type);
  }
}

/// Returns the C++ type of a member; "" for `double` or Pose, whose words say it already.
std::string PageTypes::cxxWords(const Type& type) const {
  if (type.shape == Shape::Scalar || type.shape == Shape::Enum || type.shape == Shape::Struct)
    return "";
  return inCode(cxxType(type, context_.header.cxxNamespace));
}

std::string PageTypes::sequence(const Type& type) const {
  const std::string element = part(words(type.element.front()));
  if (type.shape == Shape::Array) {
    return "array of " + element + ", exactly " + std::to_string(type.rows);
  }
  return (type.distinct ? "set of " : "list of ") + element + bound(type.capacity);
}

std::string PageTypes::composite(const Type& type) const {
  switch (type.shape) {
    case Shape::Optional: return "optional " + part(words(type.element.front()));
    case Shape::Map: return "map of " + list(type, " to ") + bound(type.capacity);
    case Shape::Tuple: return "together " + list(type, " and ");
    case Shape::Variant: return "one of " + list(type, " or ");
    default: return "nothing";
  }
}

std::string PageTypes::list(const Type& type, const char* separator) const {
  std::string all;
  for (const Type& element : type.element) {
    all += (all.empty() ? "" : separator) + part(words(element));
  }
  return all;
}

std::string PageTypes::words(const std::string& name) const {
  const std::string shortName = inCode(relative(name, context_.header.cxxNamespace));
  return shown_.contains(name) ? link(shortName, anchorOf(heading(name))) : shortName;
}

std::string PageTypes::value(const Type& type, const model::Limits& limits) const {
  const std::string range = rangeWords(limits);
  return words(type) + (limits.unit.empty() ? "" : ", " + limits.unit) +
         (range.empty() ? "" : ", " + range);
}

std::string PageTypes::heading(const std::string& name) const {
  return relative(name, context_.header.cxxNamespace) +
         (context_.lookup.findEnum(name) ? " (enum)" : " (struct)");
}

std::string PageTypes::section(const model::Enum& declaration) const {
  MarkdownTable table({"name", "value", "about"});
  for (const model::Enumerator& one : declaration.enumerators) {
    std::string words = about(one.doc, one.lifecycle);
    if (one.fallback) {
      words += (words.empty() ? "" : " ") +
               std::string("Stands for every value that a receiver does not know.");
    }
    table.add({inCode(one.name), valueText(declaration, one), words});
  }
  return "### " + heading(declaration.name) + "\n\n" +
         paragraph(about(declaration.doc, declaration.lifecycle)) + table.text();
}

std::string PageTypes::section(const model::Struct& declaration) const {
  MarkdownTable table({"field", "type", "C++", "unit", "range", "default", "about"});
  for (const model::Field& field : declaration.fields) {
    table.add({inCode(field.name), words(field.type), cxxWords(field.type), field.unit,
               rangeWords({field.unit, field.range}), defaultWords(field),
               about(field.doc, field.lifecycle)});
  }
  return "### " + heading(declaration.name) + "\n\n" +
         paragraph(about(declaration.doc, declaration.lifecycle)) + table.text();
}

std::string PageTypes::sections() const {
  std::string text;
  for (const model::Struct* const one : shown_.structs()) text += section(*one);
  for (const model::Enum* const one : shown_.enums()) text += section(*one);
  return text;
}

}  // namespace suture::compiler::emit
