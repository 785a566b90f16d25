#pragma once
// The generated encode() and decode() of a type are built on these.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/any.h>
#include <capnp/message.h>
#include <suture/base/encoding.h>
#include <suture/base/field_path.h>
#include <suture/base/time.h>

#include <functional>
#include <memory>

namespace suture::codec {

std::vector<std::byte> flatBytes(capnp::MessageBuilder& message);
/// Calls `read` with the root. Returns its answer, or Errc::Invalid if the bytes are no message.
Errc readFlat(std::span<const std::byte> bytes,
              const std::function<Errc(capnp::AnyPointer::Reader)>& read);

template <class Struct, class Slot, class T>
Result<std::vector<std::byte>> encodeAs(const T& value) {
  const auto slot = std::make_unique<Slot>();  // may be too large for the stack
  if (!store(value, *slot)) return tl::unexpected(Errc::TooLarge);
  if (!isValid(*slot, static_cast<FieldPath*>(nullptr))) return tl::unexpected(Errc::Invalid);
  capnp::MallocMessageBuilder message;
  toWire(*slot, message.initRoot<Struct>());
  return flatBytes(message);
}

template <class Struct, class Slot, class T>
Result<> decodeAs(std::span<const std::byte> bytes, T& value) {
  const auto slot = std::make_unique<Slot>();
  const Errc error = readFlat(bytes, [&](capnp::AnyPointer::Reader root) {
    const Errc converted = fromWire(root.getAs<Struct>(), *slot, Duration{0});
    if (converted != Errc{}) return converted;
    return isValid(*slot, static_cast<FieldPath*>(nullptr)) ? Errc{} : Errc::Invalid;
  });
  if (error == Errc{}) load(*slot, value);
  return resultOf<void>(error);
}

}  // namespace suture::codec
