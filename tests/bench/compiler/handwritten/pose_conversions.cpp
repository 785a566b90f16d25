#include "bench/compiler/handwritten/conversions.h"
#include "bench/compiler/handwritten/parts.h"

namespace handwritten {

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

void write(const robots::TransformStamped& value, wire::TransformStamped::Builder out) {
  write(value.transform, out.initTransform());
  out.setReferenceFrame(value.reference_frame);
  out.setMovingFrame(value.moving_frame);
  out.setStamp(suture::toNanoseconds(value.stamp));
  out.setValid(value.valid);
}

void read(wire::TransformStamped::Reader in, robots::TransformStamped& value) {
  KJ_REQUIRE(in.hasTransform(), "a stamped transform without its transform");
  read(in.getTransform(), value.transform);
  value.reference_frame = in.getReferenceFrame();
  value.moving_frame = in.getMovingFrame();
  value.stamp = suture::fromNanoseconds(in.getStamp());
  value.valid = in.getValid();
}

}  // namespace handwritten
