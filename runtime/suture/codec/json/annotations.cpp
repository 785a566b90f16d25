#include <suture/codec/json/annotations.h>
#include <suture/rpc.capnp.h>

#include <cstdint>
#include <optional>

namespace suture::codec {
namespace {

// The ids of schemas/suture/meta.capnp, which capnp's C++ does not tell.
constexpr std::uint64_t kCxx = 0xd470381940aa15b6;
constexpr std::uint64_t kUnit = 0x9cebc59597ba1262;
constexpr std::uint64_t kBulk = 0xe60b8c2f94a7d135;
constexpr std::uint64_t kRemoved = 0xd3b1f04c6a8e9275;

template <class Declaration>
std::optional<std::string> annotationText(const Declaration& declaration,
                                          std::uint64_t annotation) {
  for (const auto one : declaration.getProto().getAnnotations()) {
    if (one.getId() != annotation) continue;
    const auto value = one.getValue();
    return value.isText() ? std::string(value.getText().cStr()) : std::string();
  }
  return std::nullopt;
}

template <class Declaration>
std::string nameIn(const Declaration& declaration) {
  return annotationText(declaration, kCxx).value_or(declaration.getProto().getName().cStr());
}

}  // namespace

std::string nameOf(capnp::StructSchema::Field field) { return nameIn(field); }

std::string nameOf(capnp::EnumSchema::Enumerant value) { return nameIn(value); }

std::string unitOf(capnp::StructSchema::Field field) {
  return annotationText(field, kUnit).value_or("");
}

std::string bulkOf(capnp::StructSchema::Field field) {
  return annotationText(field, kBulk).value_or("");
}

capnp::InterfaceSchema eventsOf(capnp::InterfaceSchema contract) {
  const auto subscribe = contract.getMethodByName("subscribe").getParamType();
  return subscribe.getFieldByName("events").getType().asInterface();
}

bool isSent(capnp::StructSchema::Field field) {
  const capnp::Type type = field.getType();
  return type.isStruct() && type.asStruct().getProto().getId() == capnp::typeId<wire::Sent>();
}

bool isRemoved(capnp::StructSchema::Field field) {
  return annotationText(field, kRemoved).has_value();
}

}  // namespace suture::codec
