#include "bench/table2/codec.h"

#include <capnp/message.h>
#include <capnp/serialize.h>
#include <suture/base/errors.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "bench/table2/server.h"
#include "bench/table2/timed_loops.h"
#include "robot_types/pose.capnp.h"
#include "robot_types/pose.suture.h"

// The generated converters, which only generated code calls otherwise.
namespace robots {
void toWire(const PosePrmSlot& slot, wire::PosePrm::Builder out);
suture::Errc fromWire(wire::PosePrm::Reader in, PosePrmSlot& slot, suture::Duration shift);
}  // namespace robots

namespace bench {
namespace {

using robots::PosePrm;
using robots::PosePrmSlot;
namespace wire = robots::wire;

/// Room for one message, used again for each.
class Codec {
 public:
  kj::ArrayPtr<const kj::byte> encode(const PosePrm& value) {
    PosePrmSlot slot;
    if (!store(value, slot)) throw std::logic_error("the pose exceeds its own capacity");
    capnp::MallocMessageBuilder message(kj::arrayPtr(scratch_.data(), scratch_.size()));
    toWire(slot, message.initRoot<wire::PosePrm>());
    kj::ArrayOutputStream out(kj::arrayPtr(bytes_.data(), bytes_.size()).asBytes());
    capnp::writeMessage(out, message);
    return out.getArray();
  }

  static void decode(kj::ArrayPtr<const kj::byte> bytes, PosePrm& value) {
    const auto words = kj::arrayPtr(reinterpret_cast<const capnp::word*>(bytes.begin()),
                                    bytes.size() / sizeof(capnp::word));
    capnp::FlatArrayMessageReader message(words);
    PosePrmSlot slot;
    if (fromWire(message.getRoot<wire::PosePrm>(), slot, suture::Duration{0}) != suture::Errc{}) {
      throw std::logic_error("the pose does not survive its own wire form");
    }
    load(slot, value);
  }

 private:
  std::array<capnp::word, 64> scratch_{};
  std::array<capnp::word, 64> bytes_{};
};

bool same(const PosePrm& a, const PosePrm& b) {
  return a.timestamp == b.timestamp && a.automatic_timestamp == b.automatic_timestamp &&
         a.valid == b.valid && a.moving_frame == b.moving_frame &&
         a.reference_frame == b.reference_frame && a.position.matrix() == b.position.matrix();
}

void requireRoundTrip(Codec& codec, const PosePrm& value) {
  PosePrm back;
  Codec::decode(codec.encode(value), back);
  if (!same(value, back)) throw std::logic_error("the pose comes back changed from its wire form");
}

}  // namespace

CodecCost measureCodec(std::size_t loops) {
  Codec codec;
  PosePrm value = samplePose();
  requireRoundTrip(codec, value);
  const auto bytes = codec.encode(value);
  PosePrm target;

  CodecCost cost;
  cost.bytes = bytes.size();
  cost.encode = timedLoops(loops, kCodecLoop, [&] {
    keep(value);
    auto written = codec.encode(value);
    keep(written);
  });
  cost.create = timedLoops(loops, kCodecLoop, [] {
    auto created = std::make_unique<PosePrm>();
    keep(*created);
  });
  cost.decode = timedLoops(loops, kCodecLoop, [&] {
    Codec::decode(bytes, target);
    keep(target);
  });
  cost.sum = timedLoops(loops, kCodecLoop, [&] {
    keep(value);
    const auto written = codec.encode(value);
    auto created = std::make_unique<PosePrm>();
    Codec::decode(written, *created);
    keep(*created);
  });
  return cost;
}

}  // namespace bench
