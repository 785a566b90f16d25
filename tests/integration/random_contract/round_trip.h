#pragma once
// These send random values of a type through its slot and its message, and back.

#include <suture/base/encoding.h>
#include <suture/base/slots/shared_slot.h>
#include <suture/codec/wire.h>

#include <capnp/message.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "values.h"

namespace invented {

using suture::Errc;
using Bytes = std::vector<kj::byte>;

inline void require(bool condition, const char* type, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "%s: %s\n", type, what);
  std::exit(1);
}

template <class Slot>
std::unique_ptr<Slot> slotFullOf(int garbage) {
  auto slot = std::make_unique<Slot>();
  if constexpr (!suture::ownsMemory<Slot>) {
    std::memset(static_cast<void*>(slot.get()), garbage, sizeof(Slot));
  }
  return slot;
}

template <class Value, class Slot, class Message>
class RoundTrip {
 public:
  explicit RoundTrip(const char* name) : name_(name) {}

  void check(const Value& value, bool finite) {
    const auto slot = slotFullOf<Slot>(0xa5);
    expect(store(value, *slot), "a value within its bounds does not fit");
    expect(!finite || isValid(*slot), "a finite value is not valid");
    const Bytes bytes = encoded(*slot);
    expect(bytes == encoded(value), "two encodings differ");

    capnp::MallocMessageBuilder message;
    toWire(*slot, message.initRoot<Message>());
    const auto arrived = slotFullOf<Slot>(0x5a);
    const auto in = message.getRoot<Message>().asReader();
    expect(fromWire(in, *arrived, suture::Duration{}) == Errc{}, "what was sent is refused");
    expect(isValid(*arrived) == isValid(*slot), "what arrives is judged otherwise");
    load(*arrived, received_);  // over the value of the round before
    expect(same(received_, value), "what arrives is not what was sent");
    expect(bytes == encoded(received_), "what arrives is encoded otherwise");
    checkBytes(value, isValid(*slot));
  }

  /// `fill(value, random)` makes one member too long, if it has a length at all.
  template <class Fill>
  void checkBeyond(Random& random, const Fill& fill) {
    Value value{};
    random.length = Random::Length::Beyond;
    fill(value, random);
    const bool exceeds = random.length != Random::Length::Beyond;
    random.length = Random::Length::Any;
    const auto slot = std::make_unique<Slot>();
    expect(store(value, *slot) != exceeds, exceeds ? "one too many fits" : "a value does not fit");
    beyond_ += exceeds;
  }

  /// `put(value)` takes one number out of its range.
  template <class Put>
  void checkOutside(const Put& put) {
    Value value{};
    put(value);
    const auto slot = std::make_unique<Slot>();
    expect(store(value, *slot), "a number outside its range does not fit");
    expect(!isValid(*slot), "a number outside its range is valid");
  }

  int beyond() const { return beyond_; }

 private:
  void expect(bool condition, const char* what) const { require(condition, name_, what); }

  void checkBytes(const Value& value, bool valid) {
    const auto bytes = suture::encode(value);
    expect(bytes.has_value() == valid, "encode() judges otherwise");
    if (!valid) return;
    expect(suture::decode(*bytes, received_).has_value(), "what was encoded is not decoded");
    expect(same(received_, value), "what is decoded is not what was encoded");
  }

  Bytes encoded(const Value& value) const {
    const auto slot = slotFullOf<Slot>(0x3c);
    expect(store(value, *slot), "a value within its bounds does not fit");
    return encoded(*slot);
  }
  static Bytes encoded(const Slot& slot) {
    capnp::MallocMessageBuilder message;
    toWire(slot, message.initRoot<Message>());
    Bytes bytes;
    for (const auto segment : message.getSegmentsForOutput()) {
      bytes.insert(bytes.end(), segment.asBytes().begin(), segment.asBytes().end());
    }
    return bytes;
  }

  const char* name_;
  Value received_{};
  int beyond_ = 0;
};

/// Checks a few hundred values: of any length, empty, of the greatest length, and with NaN and
/// infinity inside.
template <class Trip, class Value>
void checkAll(Trip& trip, Random& random, Value) {
  using Length = Random::Length;
  for (int round = 0; round < 300; ++round) {
    random.length = round % 10 == 0 ? Length::Empty : round % 10 == 1 ? Length::Full : Length::Any;
    random.finite = round % 3 != 0;
    Value value{};
    fill(value, random);
    trip.check(value, random.finite);
  }
  random.length = Length::Any;
}

}  // namespace invented
