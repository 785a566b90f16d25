#include "bench/compiler/handwritten/conversions.h"
#include "bench/compiler/handwritten/parts.h"

namespace handwritten {
namespace {

template <class Rotation, class Builder>
void writeRotation(const Rotation& r, Builder& out) {
  out.setM00(r(0, 0));
  out.setM01(r(0, 1));
  out.setM02(r(0, 2));
  out.setM10(r(1, 0));
  out.setM11(r(1, 1));
  out.setM12(r(1, 2));
  out.setM20(r(2, 0));
  out.setM21(r(2, 1));
  out.setM22(r(2, 2));
}

template <class Reader, class Rotation>
void readRotation(const Reader& in, Rotation& r) {
  r(0, 0) = in.getM00();
  r(0, 1) = in.getM01();
  r(0, 2) = in.getM02();
  r(1, 0) = in.getM10();
  r(1, 1) = in.getM11();
  r(1, 2) = in.getM12();
  r(2, 0) = in.getM20();
  r(2, 1) = in.getM21();
  r(2, 2) = in.getM22();
}

}  // namespace

void write(const Eigen::Vector3d& value, suture::wire::Vec3::Builder out) {
  out.setX(value.x());
  out.setY(value.y());
  out.setZ(value.z());
}

void read(suture::wire::Vec3::Reader in, Eigen::Vector3d& value) {
  value = {in.getX(), in.getY(), in.getZ()};
}

void write(const Eigen::Isometry3d& value, suture::wire::Pose::Builder out) {
  writeRotation(value.matrix(), out);
  out.setX(value(0, 3));
  out.setY(value(1, 3));
  out.setZ(value(2, 3));
}

void read(suture::wire::Pose::Reader in, Eigen::Isometry3d& value) {
  readRotation(in, value);
  value(0, 3) = in.getX();
  value(1, 3) = in.getY();
  value(2, 3) = in.getZ();
}

void write(const robots::PoseStamped& value, wire::PoseStamped::Builder out) {
  write(value.pose, out.initPose());
  out.setStamp(suture::toNanoseconds(value.stamp));
  out.setValid(value.valid);
}

void read(wire::PoseStamped::Reader in, robots::PoseStamped& value) {
  KJ_REQUIRE(in.hasPose(), "a stamped pose without its pose");
  read(in.getPose(), value.pose);
  value.stamp = suture::fromNanoseconds(in.getStamp());
  value.valid = in.getValid();
}

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
