#include "suture/generated_codec.h"

#include <capnp/message.h>
#include <capnp/serialize.h>

#include <cstring>

#include "echo.capnp.h"
#include "echo.suture.h"
#include "harness/fail.h"
#include "harness/keep.h"

// These are the generated converters, which only generated code calls otherwise.
namespace peers {
void toWire(const PoseSlot& slot, wire::Pose::Builder out);
suture::Errc fromWire(wire::Pose::Reader in, PoseSlot& slot, suture::Duration shift);
}  // namespace peers

namespace peers {

std::size_t GeneratedCodec::throughSlot(const Pose& pose, Pose& back) {
  PoseSlot slot;
  if (!store(pose, slot)) fail("the pose exceeds its own capacity");
  keep(slot);
  load(slot, back);
  return sizeof slot;
}

std::size_t GeneratedCodec::throughMessage(const Pose& pose, Pose& back) {
  std::size_t words = 0;
  {
    capnp::MallocMessageBuilder message(kj::arrayPtr(scratch_.data(), scratch_.size()));
    PoseSlot slot;
    if (!store(pose, slot)) fail("the pose exceeds its own capacity");
    toWire(slot, message.initRoot<wire::Pose>());
    const auto segments = message.getSegmentsForOutput();
    words = segments[0].size();
    std::memcpy(bytes_.data(), segments[0].begin(), segments[0].asBytes().size());
  }  // the message clears what it took of the scratch
  keep(bytes_);
  const kj::ArrayPtr<const capnp::word> segments[] = {kj::arrayPtr(bytes_.data(), words)};
  capnp::SegmentArrayMessageReader message(kj::arrayPtr(segments, 1));
  PoseSlot slot;
  if (fromWire(message.getRoot<wire::Pose>(), slot, suture::Duration{0}) != suture::Errc{}) {
    fail("the pose does not survive its own wire form");
  }
  load(slot, back);
  return words * sizeof(capnp::word);
}

}  // namespace peers
