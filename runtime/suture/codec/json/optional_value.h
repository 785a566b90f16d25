#pragma once
// This reads std::optional as suturec writes it: a union of `none` and `some`, and nothing else.

#include <capnp/schema.h>

#include <optional>

namespace suture::codec {

/// Returns the field `some` of such a struct.
inline std::optional<capnp::StructSchema::Field> optionalIn(capnp::StructSchema schema) {
  const auto alternatives = schema.getUnionFields();
  if (schema.getFields().size() != 2 || alternatives.size() != 2) return std::nullopt;
  const bool named = alternatives[0].getProto().getName() == "none" &&
                     alternatives[1].getProto().getName() == "some";
  if (!named || !alternatives[0].getType().isVoid()) return std::nullopt;
  return alternatives[1];
}

}  // namespace suture::codec
