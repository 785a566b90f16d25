#include "bench/compiler/handwritten/record_conversions.h"

#include "bench/compiler/handwritten/parts.h"

namespace handwritten {

void write(const robots::PoseSample& value, wire::PoseSample::Builder out) {
  auto rotation = out.initRotation();
  writeRotation(value.rotation, rotation);
  write(value.position, out.initPosition());
  out.setStamp(suture::toNanoseconds(value.stamp));
  out.setSequence(value.sequence);
  out.setFlags(value.flags);
}

void read(wire::PoseSample::Reader in, robots::PoseSample& value) {
  KJ_REQUIRE(in.hasRotation() && in.hasPosition(), "a pose without its parts");
  readRotation(in.getRotation(), value.rotation);
  read(in.getPosition(), value.position);
  value.stamp = suture::fromNanoseconds(in.getStamp());
  value.sequence = in.getSequence();
  value.flags = in.getFlags();
}

void write(const robots::PosePrm& value, wire::PosePrm::Builder out) {
  out.setTimestamp(suture::toNanoseconds(value.timestamp));
  out.setAutomaticTimestamp(value.automatic_timestamp);
  out.setValid(value.valid);
  out.setMovingFrame(textOf(value.moving_frame));
  out.setReferenceFrame(textOf(value.reference_frame));
  write(value.position, out.initPosition());
}

void read(wire::PosePrm::Reader in, robots::PosePrm& value) {
  KJ_REQUIRE(in.hasPosition(), "a pose without its position");
  value.timestamp = suture::fromNanoseconds(in.getTimestamp());
  value.automatic_timestamp = in.getAutomaticTimestamp();
  value.valid = in.getValid();
  read(in.getMovingFrame(), value.moving_frame);
  read(in.getReferenceFrame(), value.reference_frame);
  read(in.getPosition(), value.position);
}

}  // namespace handwritten
