#include <suture/base/errors.h>
#include <suture/codec/json/annotations.h>
#include <suture/codec/json/json_reals.h>
#include <suture/codec/json/optional_value.h>
#include <suture/codec/json/packed_numbers.h>
#include <suture/codec/json/to_json.h>

#include <charconv>
#include <cstdlib>

namespace suture::codec {
namespace {

using capnp::DynamicValue;

// A peer may send a schema of groups in groups without end.
constexpr int kDeepest = 64;

[[noreturn]] void refuse() {
  throw SetupError("show a value", "it is nested deeper than anything of ours",
                   "What sent it is not what it seems");
}

/// Returns the double of fewest digits that is this float: 0.1f is shown as 0.1.
double shortest(float value) {
  char text[32];
  *std::to_chars(text, text + sizeof(text) - 1, value).ptr = '\0';
  return std::strtod(text, nullptr);
}

class Converter {
 public:
  explicit Converter(Labels labels) : labels_(labels) {}

  Json convert(capnp::DynamicStruct::Reader value, int depth) {
    if (depth > kDeepest) refuse();
    if (const auto some = optionalIn(value.getSchema())) {
      KJ_IF_MAYBE (set, value.which()) {
        if (*set != *some) return nullptr;
      }
      return convertField(value, *some, depth);
    }
    Json object = Json::object();
    for (const auto field : value.getSchema().getNonUnionFields()) add(object, value, field, depth);
    KJ_IF_MAYBE (field, value.which()) add(object, value, *field, depth);
    return object;
  }

 private:
  void add(Json& object, capnp::DynamicStruct::Reader value, capnp::StructSchema::Field field,
           int depth) {
    if (isRemoved(field)) return;
    std::string label = nameOf(field);
    const std::string unit = unitOf(field);
    if (labels_ == Labels::Units && !unit.empty()) label += " [" + unit + "]";
    object[label] = convertField(value, field, depth);
  }

  Json convertField(capnp::DynamicStruct::Reader value, capnp::StructSchema::Field field,
                    int depth) {
    const auto one = value.get(field);
    if (one.getType() != DynamicValue::DATA) return convertAny(one, field.getType(), depth);
    const auto bytes = one.as<capnp::Data>();
    return numbersIn({bytes.begin(), bytes.size()}, bulkOf(field));
  }

  Json convertAny(const DynamicValue::Reader& value, capnp::Type type, int depth) {
    switch (value.getType()) {
      case DynamicValue::BOOL: return value.as<bool>();
      case DynamicValue::INT: return value.as<std::int64_t>();
      case DynamicValue::UINT: return value.as<std::uint64_t>();
      case DynamicValue::FLOAT:
        return realToJson(type.isFloat32() ? shortest(value.as<float>()) : value.as<double>());
      case DynamicValue::TEXT: {
        const auto text = value.as<capnp::Text>();
        return std::string(text.begin(), text.size());
      }
      case DynamicValue::DATA: {
        const auto bytes = value.as<capnp::Data>();
        return numbersIn({bytes.begin(), bytes.size()}, "");
      }
      case DynamicValue::ENUM: return convertEnum(value.as<capnp::DynamicEnum>());
      case DynamicValue::LIST: return convertList(value.as<capnp::DynamicList>(), depth + 1);
      case DynamicValue::STRUCT: return convert(value.as<capnp::DynamicStruct>(), depth + 1);
      case DynamicValue::CAPABILITY: return "(capability)";
      case DynamicValue::ANY_POINTER: return "(pointer)";
      case DynamicValue::UNKNOWN:
      case DynamicValue::VOID: return nullptr;
    }
    return nullptr;
  }

  Json convertEnum(capnp::DynamicEnum value) {
    KJ_IF_MAYBE (known, value.getEnumerant()) return nameOf(*known);
    return value.getRaw();
  }

  Json convertList(capnp::DynamicList::Reader list, int depth) {
    if (depth > kDeepest) refuse();
    Json array = Json::array();
    const auto type = list.getSchema().getElementType();
    for (const auto element : list) array.push_back(convertAny(element, type, depth));
    return array;
  }

  const Labels labels_;
};

}  // namespace

Json toJson(capnp::DynamicStruct::Reader value, Labels labels) {
  return Converter(labels).convert(value, 0);
}

Json payloadToJson(capnp::DynamicStruct::Reader message, Labels labels) {
  Json all = toJson(message, labels);
  if (!all.is_object()) return all;
  all.erase("stamp");
  if (all.empty()) return nullptr;
  return all.size() == 1 ? Json(all.begin().value()) : all;
}

}  // namespace suture::codec
