#pragma once
// These take C++ -> slot -> message -> slot -> C++ for any of the types under test.

#include <capnp/message.h>
#include <capnp/serialize.h>
#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/base/field_path.h>
#include <suture/base/slots/shared_slot.h>
#include <suture/base/time.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace shapes {

using suture::Errc;

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

/// Equal to the bit: NaN is NaN, and -0 is not 0.
inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// A type, its slot and its message: `Slot` and `Message` are the names that were generated.
template <class Value, class Slot, class Message>
struct RoundTrip {
  /// Encodes the value; the message stays to be looked at and damaged.
  typename Message::Builder send(const Value& value) {
    auto sent = std::make_unique<Slot>();
    EXPECT_TRUE(store(value, *sent));
    auto out = message->template initRoot<Message>();
    toWire(*sent, out);
    return out;
  }

  Errc receive() {
    if constexpr (!suture::ownsMemory<Slot>) {
      std::memset(static_cast<void*>(slot.get()), 0xa5, sizeof(Slot));  // as a slot in use is
    }
    return fromWire(message->template getRoot<Message>().asReader(), *slot, suture::Duration{});
  }

  /// Sends the value there and back.
  void carry(const Value& value, Value& received) {
    send(value);
    ASSERT_EQ(receive(), Errc{});
    load(*slot, received);
  }

  /// Returns which part of the value the check refuses; "" if it refuses none.
  std::string refused(const Value& value) {
    send(value);
    EXPECT_EQ(receive(), Errc{});
    suture::FieldPath path;
    const bool valid = isValid(*slot, &path);
    EXPECT_EQ(valid, path.empty());
    return std::string(path.text());
  }

  /// Does the same where it is sent: before its message is written.
  static std::string refusedUnsent(const Value& value) {
    auto one = std::make_unique<Slot>();
    EXPECT_TRUE(store(value, *one));
    suture::FieldPath path;
    const bool valid = isValid(*one, &path);
    EXPECT_EQ(valid, path.empty());
    return std::string(path.text());
  }

  bool fits(const Value& value) const {
    auto one = std::make_unique<Slot>();
    return store(value, *one);
  }

  /// Returns the message as it goes over a wire.
  std::vector<capnp::byte> bytes() {
    const auto words = capnp::messageToFlatArray(*message);
    return {words.asBytes().begin(), words.asBytes().end()};
  }

  std::unique_ptr<capnp::MallocMessageBuilder> message =
      std::make_unique<capnp::MallocMessageBuilder>();  // its destructor may throw
  std::unique_ptr<Slot> slot = std::make_unique<Slot>();
};

}  // namespace shapes
