#include "bench/compiler/handwritten/conversions.h"
#include "bench/compiler/handwritten/parts.h"

namespace handwritten {
namespace {

constexpr unsigned kMaxCoefficients = 48;

capnp::uint sizeOf(const auto& values) { return static_cast<capnp::uint>(values.size()); }

}  // namespace

void write(const robots::JointState& value, wire::JointState::Builder out) {
  writeTexts(value.name, out.initName(sizeOf(value.name)));
  write(value.position, out.initPosition(sizeOf(value.position)));
  write(value.velocity, out.initVelocity(sizeOf(value.velocity)));
  write(value.effort, out.initEffort(sizeOf(value.effort)));
  out.setStamp(suture::toNanoseconds(value.stamp));
  out.setValid(value.valid);
}

void read(wire::JointState::Reader in, robots::JointState& value) {
  readTexts(in.getName(), value.name);
  read(in.getPosition(), value.position);
  read(in.getVelocity(), value.velocity);
  read(in.getEffort(), value.effort);
  value.stamp = suture::fromNanoseconds(in.getStamp());
  value.valid = in.getValid();
}

void write(const robots::JointGoal& value, wire::JointGoal::Builder out) {
  write(value.position, out.initPosition(sizeOf(value.position)));
  out.setStamp(suture::toNanoseconds(value.stamp));
}

void read(wire::JointGoal::Reader in, robots::JointGoal& value) {
  read(in.getPosition(), value.position);
  value.stamp = suture::fromNanoseconds(in.getStamp());
}

void write(const robots::JointSolution& value, wire::JointSolution::Builder out) {
  write(value.position, out.initPosition(sizeOf(value.position)));
  out.setJoints(value.joints);
  out.setFound(value.found);
}

void read(wire::JointSolution::Reader in, robots::JointSolution& value) {
  read(in.getPosition(), value.position);
  value.joints = in.getJoints();
  value.found = in.getFound();
}

void write(const robots::JointVelocityGoal& value, wire::JointVelocityGoal::Builder out) {
  write(value.goal, out.initGoal(sizeOf(value.goal)));
  write(value.acceleration, out.initAcceleration(sizeOf(value.acceleration)));
  write(value.deceleration, out.initDeceleration(sizeOf(value.deceleration)));
  write(value.guard, out.initGuard(sizeOf(value.guard)));
  write(value.mask, out.initMask(sizeOf(value.mask)));
  out.setStamp(suture::toNanoseconds(value.stamp));
}

void read(wire::JointVelocityGoal::Reader in, robots::JointVelocityGoal& value) {
  read(in.getGoal(), value.goal);
  read(in.getAcceleration(), value.acceleration);
  read(in.getDeceleration(), value.deceleration);
  read(in.getGuard(), value.guard);
  read(in.getMask(), value.mask);
  value.stamp = suture::fromNanoseconds(in.getStamp());
}

void write(const robots::JointEffortGoal& value, wire::JointEffortGoal::Builder out) {
  write(value.effort, out.initEffort(sizeOf(value.effort)));
  write(value.mask, out.initMask(sizeOf(value.mask)));
  out.setStamp(suture::toNanoseconds(value.stamp));
}

void read(wire::JointEffortGoal::Reader in, robots::JointEffortGoal& value) {
  read(in.getEffort(), value.effort);
  read(in.getMask(), value.mask);
  value.stamp = suture::fromNanoseconds(in.getStamp());
}

namespace {

wire::JointType write(robots::JointType type) {
  switch (type) {
    case robots::JointType::Undefined: return wire::JointType::UNDEFINED;
    case robots::JointType::Prismatic: return wire::JointType::PRISMATIC;
    case robots::JointType::Revolute: return wire::JointType::REVOLUTE;
    case robots::JointType::Universal: return wire::JointType::UNIVERSAL;
    case robots::JointType::BallSocket: return wire::JointType::BALL_SOCKET;
    case robots::JointType::Inactive: return wire::JointType::INACTIVE;
  }
  KJ_UNREACHABLE;
}

robots::JointType read(wire::JointType type) {
  switch (type) {
    case wire::JointType::UNDEFINED: return robots::JointType::Undefined;
    case wire::JointType::PRISMATIC: return robots::JointType::Prismatic;
    case wire::JointType::REVOLUTE: return robots::JointType::Revolute;
    case wire::JointType::UNIVERSAL: return robots::JointType::Universal;
    case wire::JointType::BALL_SOCKET: return robots::JointType::BallSocket;
    case wire::JointType::INACTIVE: return robots::JointType::Inactive;
  }
  KJ_FAIL_REQUIRE("not a type of joint", static_cast<unsigned>(type));
}

}  // namespace

void write(const robots::JointConfiguration& value, wire::JointConfiguration::Builder out) {
  writeTexts(value.name, out.initName(sizeOf(value.name)));
  auto types = out.initType(sizeOf(value.type));
  for (capnp::uint i = 0; i < types.size(); ++i) types.set(i, write(value.type[i]));
  write(value.position_min, out.initPositionMin(sizeOf(value.position_min)));
  write(value.position_max, out.initPositionMax(sizeOf(value.position_max)));
  write(value.velocity_min, out.initVelocityMin(sizeOf(value.velocity_min)));
  write(value.velocity_max, out.initVelocityMax(sizeOf(value.velocity_max)));
  write(value.acceleration_min, out.initAccelerationMin(sizeOf(value.acceleration_min)));
  write(value.acceleration_max, out.initAccelerationMax(sizeOf(value.acceleration_max)));
  write(value.effort_min, out.initEffortMin(sizeOf(value.effort_min)));
  write(value.effort_max, out.initEffortMax(sizeOf(value.effort_max)));
  out.setValid(value.valid);
}

void read(wire::JointConfiguration::Reader in, robots::JointConfiguration& value) {
  readTexts(in.getName(), value.name);
  const auto types = in.getType();
  KJ_REQUIRE(types.size() <= kMaxElements, "a list is too long");
  value.type.resize(types.size());
  for (capnp::uint i = 0; i < types.size(); ++i) value.type[i] = read(types[i]);
  read(in.getPositionMin(), value.position_min);
  read(in.getPositionMax(), value.position_max);
  read(in.getVelocityMin(), value.velocity_min);
  read(in.getVelocityMax(), value.velocity_max);
  read(in.getAccelerationMin(), value.acceleration_min);
  read(in.getAccelerationMax(), value.acceleration_max);
  read(in.getEffortMin(), value.effort_min);
  read(in.getEffortMax(), value.effort_max);
  value.valid = in.getValid();
}

void write(const robots::Jacobian& value, wire::Jacobian::Builder out) {
  out.setJoints(value.joints);
  write(value.coefficients, out.initCoefficients(sizeOf(value.coefficients)));
  out.setStamp(suture::toNanoseconds(value.stamp));
  out.setValid(value.valid);
}

void read(wire::Jacobian::Reader in, robots::Jacobian& value) {
  value.joints = in.getJoints();
  read(in.getCoefficients(), value.coefficients, kMaxCoefficients);
  value.stamp = suture::fromNanoseconds(in.getStamp());
  value.valid = in.getValid();
}

}  // namespace handwritten
