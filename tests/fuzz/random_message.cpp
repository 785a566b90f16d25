#include "tests/fuzz/random_message.h"

#include <capnp/dynamic.h>
#include <suture/framing/message_header.h>

#include <algorithm>
#include <limits>
#include <string>

namespace suture::fuzz {
namespace {

using capnp::DynamicList;
using capnp::DynamicStruct;
using capnp::DynamicValue;
using Which = capnp::schema::Type::Which;

constexpr int kDepth = 12;  // a struct that holds itself does so no deeper

template <class T>
DynamicValue::Reader oneOf(std::initializer_list<T> values, Random& random) {
  return values.begin()[random() % values.size()];
}

DynamicValue::Reader integer(Random& random) {
  if (random() % 2 == 0) return oneOf<std::int64_t>({0, 1, 2, 3}, random);
  return oneOf<std::int64_t>({0, 1, -1, 127, -128, 65535, 1'000'000'000}, random);
}

DynamicValue::Reader real(Random& random) {
  using Limits = std::numeric_limits<double>;
  return oneOf<double>({0.0, -0.0, 0.5, -3.25, Limits::quiet_NaN(), Limits::infinity(),
                        Limits::denorm_min(), Limits::max(), static_cast<double>(random()) / 1e6},
                       random);
}

/// Numbers are cut to what the field holds: capnp checks that they fit.
DynamicValue::Reader number(Which type, Random& random) {
  switch (type) {
    case Which::BOOL: return random() % 2 == 0;
    case Which::FLOAT32: return static_cast<float>(real(random).as<double>());
    case Which::FLOAT64: return real(random);
    case Which::INT8: return static_cast<std::int8_t>(integer(random).as<std::int64_t>());
    case Which::INT16: return static_cast<std::int16_t>(integer(random).as<std::int64_t>());
    case Which::INT32: return static_cast<std::int32_t>(integer(random).as<std::int64_t>());
    case Which::UINT8: return static_cast<std::uint8_t>(integer(random).as<std::int64_t>());
    case Which::UINT16: return static_cast<std::uint16_t>(integer(random).as<std::int64_t>());
    case Which::UINT32: return static_cast<std::uint32_t>(integer(random).as<std::int64_t>());
    case Which::UINT64: return static_cast<std::uint64_t>(integer(random).as<std::int64_t>());
    default: break;
  }
  return oneOf<std::int64_t>(
      {integer(random).as<std::int64_t>(), std::numeric_limits<std::int64_t>::max(),
       std::numeric_limits<std::int64_t>::min()},
      random);
}

class Filler {
 public:
  explicit Filler(Random& random) : random_(random) {}

  void fill(DynamicStruct::Builder out, int depth) {
    for (const auto field : out.getSchema().getNonUnionFields()) fillField(out, field, depth);
    const auto alternatives = out.getSchema().getUnionFields();
    if (alternatives.size() > 0) {
      fillField(out, alternatives[random_() % alternatives.size()], depth);
    }
  }

 private:
  void fillField(DynamicStruct::Builder out, capnp::StructSchema::Field field, int depth) {
    if (depth == 0) return;
    const capnp::Type type = field.getType();
    if (type.isVoid() || type.isEnum()) return out.set(field, plain(type));
    if (type.isText() || type.isData()) return fillBytes(out, field);
    if (type.isStruct()) {
      auto inner = out.has(field) ? out.get(field) : out.init(field);
      return fill(inner.as<DynamicStruct>(), depth - 1);
    }
    if (!type.isList()) return out.set(field, number(type.which(), random_));
    // Perhaps no other length than the one that it has is valid.
    const bool keeps = out.has(field) && random_() % 2 == 0;
    auto list =
        keeps ? out.get(field).as<DynamicList>() : out.init(field, length()).as<DynamicList>();
    for (capnp::uint i = 0; i < list.size(); ++i) fillElement(list, i, depth - 1);
  }

  void fillElement(DynamicList::Builder list, capnp::uint i, int depth) {
    const capnp::Type type = list.getSchema().getElementType();
    if (depth == 0) return;
    if (type.isVoid() || type.isEnum()) return list.set(i, plain(type));
    if (type.isText()) return list.set(i, DynamicValue::Reader(text().c_str()));
    if (type.isStruct()) return fill(list[i].as<DynamicStruct>(), depth - 1);
    if (type.isData()) return;
    if (!type.isList()) return list.set(i, number(type.which(), random_));
    auto inner = list.init(i, length()).as<DynamicList>();
    for (capnp::uint j = 0; j < inner.size(); ++j) fillElement(inner, j, depth - 1);
  }

  void fillBytes(DynamicStruct::Builder out, capnp::StructSchema::Field field) {
    const std::string bytes = text();
    if (field.getType().isText()) return out.set(field, DynamicValue::Reader(bytes.c_str()));
    out.set(field,
            capnp::Data::Reader(reinterpret_cast<const kj::byte*>(bytes.data()), bytes.size()));
  }

  DynamicValue::Reader plain(capnp::Type type) {
    if (type.isVoid()) return capnp::VOID;
    const auto count = type.asEnum().getEnumerants().size();
    const auto ordinal = static_cast<std::uint16_t>(random_() % (count + 1));  // one that is none
    return capnp::DynamicEnum(type.asEnum(), ordinal);
  }

  /// Returns a length that most containers admit, and sometimes one that no container does; it is
  /// 0 once there are many elements.
  capnp::uint length() {
    const auto most = random_() % 8 == 0 ? 90u : 5u;
    const auto wanted = static_cast<capnp::uint>(random_() % most);
    const capnp::uint given = std::min(wanted, left_);
    left_ -= given;
    return given;
  }

  std::string text() {
    return std::string(random_() % 12, static_cast<char>('a' + random_() % 26));
  }

  Random& random_;
  capnp::uint left_ = 20'000;  // elements: lists of lists of what holds itself have no end
};

}  // namespace

std::vector<std::byte> randomFrame(const Decoder& decoder, Random& random) {
  capnp::MallocMessageBuilder message;
  decoder.write(message);
  const auto root = message.getRoot<DynamicStruct>(decoder.schema);
  Filler(random).fill(root, kDepth);
  std::vector<std::byte> frame;
  framing::appendMessage(message.getSegmentsForOutput(), frame);
  return frame;
}

}  // namespace suture::fuzz
