#pragma once
// These are the converters of one generated type, as a fuzzer sees them: any message in, and what
// must hold of whatever is accepted.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/message.h>
#include <capnp/schema.h>
#include <suture/base/errors.h>
#include <suture/base/slots/shared_slot.h>
#include <suture/base/time.h>

#include <chrono>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "tests/fuzz/require.h"

namespace suture::fuzz {

struct Decoder {
  const char* name;
  capnp::StructSchema schema;
  /// Writes a default value as a message.
  void (*write)(capnp::MessageBuilder& out);
  /// Decodes `in`. Aborts when what was accepted does not survive being written and read again.
  void (*check)(capnp::MessageReader& in);
};

/// Returns the decoders under test; each fuzzer links one list.
std::span<const Decoder> decoders();

/// The clock of a peer that was started a week later differs by this.
inline constexpr Duration kShift = std::chrono::hours(24 * 7);

template <class Value, class Slot, class Message>
struct Checks {
  using Bytes = std::vector<kj::byte>;

  static void write(capnp::MessageBuilder& out) {
    const auto slot = used();
    require(store(Value{}, *slot));
    toWire(*slot, out.initRoot<Message>());
  }

  static void check(capnp::MessageReader& in) {
    const auto slot = used();
    if (fromWire(in.getRoot<Message>(), *slot, kShift) != Errc{}) return;
    const auto received = decoded(*slot);
    if constexpr (!ownsMemory<Slot>) {  // nothing was lost
      require(std::memcmp(received.get(), slot.get(), sizeof(Slot)) == 0);
    }
    require(encoded(*received) == encoded(*slot));
    FieldPath path;
    const bool valid = isValid(*received, &path);
    require(valid == path.empty());  // whatever is refused, it says what
    require(valid == isValid(*slot, nullptr));

    // A value may hold less than its slot, a duration in hours for one; but what it holds, stays.
    const auto loaded = throughValue(*received);
    require(encoded(*throughValue(*loaded)) == encoded(*loaded));
  }

 private:
  /// Returns a slot as it is in a running system: full of what was there before.
  static std::unique_ptr<Slot> used() {
    auto slot = std::make_unique<Slot>();
    if constexpr (!ownsMemory<Slot>) {
      std::memset(static_cast<void*>(slot.get()), 0xa5, sizeof(Slot));
    }
    return slot;
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

  static std::unique_ptr<Slot> decoded(const Slot& slot) {
    capnp::MallocMessageBuilder message;
    toWire(slot, message.initRoot<Message>());
    auto again = used();
    require(fromWire(message.getRoot<Message>().asReader(), *again, Duration{}) == Errc{});
    return again;
  }

  static std::unique_ptr<Slot> throughValue(const Slot& slot) {
    Value value{};
    load(slot, value);
    auto again = used();
    require(store(value, *again));
    return again;
  }
};

template <class Value, class Slot, class Message>
Decoder decoder(const char* name) {
  using Type = Checks<Value, Slot, Message>;
  return {name, capnp::Schema::from<Message>(), Type::write, Type::check};
}

}  // namespace suture::fuzz
