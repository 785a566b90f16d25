#include "cli/contract/from_json.h"
#include <suture/base/nearest.h>
#include <suture/codec/json/annotations.h>
#include <suture/codec/json/json_integers.h>
#include <suture/codec/json/json_reals.h>
#include <suture/codec/json/optional_value.h>
#include <suture/codec/json/packed_numbers.h>
#include "cli/command_line/options.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace suture::cli {
namespace {

using capnp::Type;
using Which = capnp::schema::Type::Which;

[[noreturn]] void refuse(const std::string& path, const std::string& found,
                         const std::string& remedy) {
  throw UsageError(path.empty() ? "the arguments" : "argument '" + path + "'", found, remedy);
}

std::string under(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + "." + name;
}

std::string shown(const Json& json) {
  constexpr std::size_t kMost = 60;
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

bool isOurs(capnp::StructSchema::Field field) {
  return codec::isSent(field) || field.getType().isInterface() || codec::isRemoved(field);
}

/// A FieldPlace is a field of a struct, to be set.
struct FieldPlace {
  capnp::DynamicStruct::Builder owner;
  capnp::StructSchema::Field field;

  Type type() const { return field.getType(); }
  std::string bulk() const { return codec::bulkOf(field); }
  void set(const capnp::DynamicValue::Reader& value) { owner.set(field, value); }
  auto initStruct() { return owner.init(field).as<capnp::DynamicStruct>(); }
  auto initList(unsigned size) { return owner.init(field, size).as<capnp::DynamicList>(); }
};

/// An ElementPlace is an element of a list, to be set.
struct ElementPlace {
  capnp::DynamicList::Builder owner;
  unsigned index;

  Type type() const { return owner.getSchema().getElementType(); }
  std::string bulk() const { return ""; }
  void set(const capnp::DynamicValue::Reader& value) { owner.set(index, value); }
  auto initStruct() { return owner[index].as<capnp::DynamicStruct>(); }
  auto initList(unsigned size) { return owner.init(index, size).as<capnp::DynamicList>(); }
};

template <class Integer, class Place>
void setInteger(Place place, const Json& json, const std::string& path) {
  const auto value = codec::integerOf<Integer>(json);
  if (!value) {
    using Limits = std::numeric_limits<Integer>;
    refuse(path, "it is " + shown(json),
           "Give a whole number from " + std::to_string(Limits::min()) + " to " +
               std::to_string(Limits::max()));
  }
  place.set(*value);
}

template <class Real, class Place>
void setReal(Place place, const Json& json, const std::string& path) {
  const auto value = codec::realOf<Real>(json);
  if (!value && json.is_number()) {
    refuse(path, "it is " + shown(json), "Give a number that a Float32 can hold");
  }
  if (!value) refuse(path, "it is " + shown(json), "Give a number");
  place.set(*value);
}

template <class Place>
void setText(Place place, const Json& json, const std::string& path) {
  if (!json.is_string()) refuse(path, "it is " + shown(json), "Give a text, \"like this\"");
  const std::string& text = json.get_ref<const std::string&>();
  place.set(capnp::Text::Reader(text.c_str(), text.size()));
}

template <class Place>
void setData(Place place, const Json& json, const std::string& path) {
  std::vector<std::uint8_t> bytes;
  try {
    bytes = codec::bytesOf(json, place.bulk());
  } catch (const std::exception&) {
    const std::string kind = place.bulk().empty() ? "UInt8" : place.bulk();
    refuse(path, "it is " + shown(json), "Give a list of numbers, each a " + kind);
  }
  place.set(capnp::Data::Reader(bytes.data(), bytes.size()));
}

template <class Place>
void setEnum(Place place, const Json& json, const std::string& path) {
  std::vector<std::string> names;
  for (const auto value : place.type().asEnum().getEnumerants()) {
    names.push_back(codec::nameOf(value));
    if (json == names.back()) return place.set(capnp::DynamicEnum(value));
  }
  refuse(path, "it is " + shown(json), "Give one of " + listNames(names));
}

template <class Place>
void setValue(Place place, const Json& json, const std::string& path);

template <class Place>
void setList(Place place, const Json& json, const std::string& path) {
  if (!json.is_array()) refuse(path, "it is " + shown(json), "Give a list, [like, this]");
  const auto list = place.initList(static_cast<unsigned>(json.size()));
  for (unsigned i = 0; i < json.size(); ++i) {
    setValue(ElementPlace{list, i}, json[i], path + "[" + std::to_string(i) + "]");
  }
}

template <class Place>
void setValue(Place place, const Json& json, const std::string& path) {
  switch (place.type().which()) {
    case Which::VOID: return place.set(capnp::VOID);
    case Which::BOOL:
      if (!json.is_boolean()) refuse(path, "it is " + shown(json), "Give true or false");
      return place.set(json.get<bool>());
    case Which::INT8: return setInteger<std::int8_t>(place, json, path);
    case Which::INT16: return setInteger<std::int16_t>(place, json, path);
    case Which::INT32: return setInteger<std::int32_t>(place, json, path);
    case Which::INT64: return setInteger<std::int64_t>(place, json, path);
    case Which::UINT8: return setInteger<std::uint8_t>(place, json, path);
    case Which::UINT16: return setInteger<std::uint16_t>(place, json, path);
    case Which::UINT32: return setInteger<std::uint32_t>(place, json, path);
    case Which::UINT64: return setInteger<std::uint64_t>(place, json, path);
    case Which::FLOAT32: return setReal<float>(place, json, path);
    case Which::FLOAT64: return setReal<double>(place, json, path);
    case Which::TEXT: return setText(place, json, path);
    case Which::DATA: return setData(place, json, path);
    case Which::LIST: return setList(place, json, path);
    case Which::ENUM: return setEnum(place, json, path);
    case Which::STRUCT: return fill(place.initStruct(), json, path);
    case Which::INTERFACE:
    case Which::ANY_POINTER: refuse(path, "it is no value", "This command is not for tools");
  }
}

std::vector<capnp::StructSchema::Field> wanted(const auto& fields) {
  std::vector<capnp::StructSchema::Field> all;
  for (const auto field : fields) {
    if (!isOurs(field)) all.push_back(field);
  }
  return all;
}

void requireKnown(const Json& json, const std::vector<std::string>& names,
                  const std::string& path) {
  for (const auto& [key, value] : json.items()) {
    if (std::find(names.begin(), names.end(), key) != names.end()) continue;
    refuse(under(path, key), "no such name; known are " + listNames(names),
           remedyForName(key, names));
  }
}

/// Finds which alternative of a union is given.
capnp::StructSchema::Field alternativeIn(const Json& json,
                                         const std::vector<capnp::StructSchema::Field>& all,
                                         const std::string& path) {
  std::vector<std::string> names;
  std::vector<capnp::StructSchema::Field> given;
  for (const auto field : all) {
    names.push_back(codec::nameOf(field));
    if (json.contains(names.back())) given.push_back(field);
  }
  if (given.size() != 1) {
    refuse(path, std::to_string(given.size()) + " of its alternatives are given",
           "Give one of " + listNames(names));
  }
  return given.front();
}

/// Returns the type of an optional value instead of that of the option.
Type withoutOption(Type type) {
  if (!type.isStruct()) return type;
  const auto some = codec::optionalIn(type.asStruct());
  return some ? some->getType() : type;
}

/// Returns the type of that element or field, if there can be one.
std::optional<Type> typeOf(Type owner, const std::string& name) {
  if (owner.isList()) return owner.asList().getElementType();
  if (!owner.isStruct()) return std::nullopt;
  for (const auto field : owner.asStruct().getFields()) {
    if (codec::nameOf(field) == name) return field.getType();
  }
  return std::nullopt;
}

}  // namespace

bool leadsToText(capnp::StructSchema schema, std::string_view path, const Json& value) {
  std::optional<Type> type = schema;
  while (type && !path.empty()) {
    const std::string name(path.substr(0, path.find('.')));
    path.remove_prefix(std::min(name.size() + 1, path.size()));
    type = typeOf(withoutOption(*type), name);
  }
  if (!type) return false;
  return type->isText() || (withoutOption(*type).isText() && !value.is_null());
}

void fill(capnp::DynamicStruct::Builder out, const Json& json, const std::string& path) {
  const capnp::StructSchema schema = out.getSchema();
  if (const auto some = codec::optionalIn(schema)) {
    if (json.is_null()) return out.set("none", capnp::VOID);
    return setValue(FieldPlace{out, *some}, json, path);
  }
  if (!json.is_object()) refuse(path, "it is " + shown(json), "Give its fields, {\"name\": value}");
  auto fields = wanted(schema.getNonUnionFields());
  const auto alternatives = wanted(schema.getUnionFields());
  std::vector<std::string> names;
  for (const auto field : fields) names.push_back(codec::nameOf(field));
  for (const auto field : alternatives) names.push_back(codec::nameOf(field));
  requireKnown(json, names, path);
  if (!alternatives.empty()) fields.push_back(alternativeIn(json, alternatives, path));
  for (const auto field : fields) {
    const std::string name = codec::nameOf(field);
    if (!json.contains(name)) {
      refuse(under(path, name), "it is not given",
             (names.size() > 1 ? "Give all of " : "Give ") + listNames(names) +
                 "; nothing is filled in");
    }
    setValue(FieldPlace{out, field}, json[name], under(path, name));
  }
}

}  // namespace suture::cli
