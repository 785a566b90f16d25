#include "bench/table2/codec.h"

#include <capnp/message.h>
#include <capnp/serialize.h>
#include <suture/base/errors.h>
#include <suture/framing/message_header.h>

#include <array>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "bench/table2/sample_pose.h"
#include "bench/timed_loops.h"
#include "robot_types/pose.capnp.h"
#include "robot_types/pose.suture.h"

// These are the generated converters, which only generated code calls otherwise.
namespace robots {
void toWire(const PosePrmSlot& slot, wire::PosePrm::Builder out);
suture::Errc fromWire(wire::PosePrm::Reader in, PosePrmSlot& slot, suture::Duration shift);
}  // namespace robots

namespace bench {
namespace {

using robots::PosePrm;
using robots::PosePrmSlot;

using Segment = kj::ArrayPtr<const capnp::word>;

/// Builds one message in memory that is used again for the next, and leaves it zeroed as it must
/// be.
class ReusingBuilder final : public capnp::MessageBuilder {
 public:
  explicit ReusingBuilder(std::span<capnp::word> memory) : memory_(memory) {}
  ~ReusingBuilder() noexcept(false) override { std::memset(memory_.data(), 0, usedBytes_); }

  kj::ArrayPtr<const Segment> finish() {
    const auto segments = getSegmentsForOutput();
    usedBytes_ = segments[0].asBytes().size();
    return segments;
  }
  kj::ArrayPtr<capnp::word> allocateSegment(capnp::uint minimumSize) override {
    if (minimumSize > memory_.size()) throw std::logic_error("a pose larger than its message");
    return kj::arrayPtr(memory_.data(), memory_.size());
  }

 private:
  std::span<capnp::word> memory_;
  std::size_t usedBytes_ = 0;
};

/// Turns objects into the frames of a stream and back, as a lane does it.
class Codec {
 public:
  std::span<const std::byte> encode(const PosePrm& value) {
    PosePrmSlot slot;
    if (!store(value, slot)) throw std::logic_error("the pose exceeds its own capacity");
    ReusingBuilder message(scratch_);
    toWire(slot, message.initRoot<robots::wire::PosePrm>());
    frame_.clear();
    suture::framing::appendMessage(message.finish(), frame_);
    return frame_;
  }

  static void decode(std::span<const std::byte> frame, PosePrm& value) {
    const auto parsed = suture::framing::parseMessageHeader(frame, {});
    if (!parsed.header || parsed.header->segments != 1) throw std::logic_error("not one message");
    const auto* words = reinterpret_cast<const capnp::word*>(frame.data());
    const Segment segments[] = {
        kj::arrayPtr(words + parsed.header->headerBytes / sizeof(capnp::word),
                     suture::framing::segmentWords(frame, 0))};
    capnp::SegmentArrayMessageReader message(kj::arrayPtr(segments, 1));
    PosePrmSlot slot;
    if (fromWire(message.getRoot<robots::wire::PosePrm>(), slot, suture::Duration{0}) !=
        suture::Errc{}) {
      throw std::logic_error("the pose does not survive its own wire form");
    }
    load(slot, value);
  }

 private:
  std::array<capnp::word, 64> scratch_{};
  std::vector<std::byte> frame_;
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
    auto created = std::make_unique_for_overwrite<PosePrm>();
    keep(*created);
  });
  cost.decode = timedLoops(loops, kCodecLoop, [&] {
    Codec::decode(bytes, target);
    keep(target);
  });
  cost.sum = timedLoops(loops, kCodecLoop, [&] {
    keep(value);
    const auto written = codec.encode(value);
    auto created = std::make_unique_for_overwrite<PosePrm>();
    Codec::decode(written, *created);
    keep(*created);
  });
  return cost;
}

}  // namespace bench
