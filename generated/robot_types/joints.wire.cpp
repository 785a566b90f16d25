// Written by suturec from robot_types/joints.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robot_types/joints.capnp.h"
#include "robot_types/joints.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const JointStateSlot& slot, wire::JointState::Builder out) {
  toWire(slot.name, out.initName(sizeOf(slot.name)));
  toWire(slot.position, out.initPosition(sizeOf(slot.position)));
  toWire(slot.velocity, out.initVelocity(sizeOf(slot.velocity)));
  toWire(slot.effort, out.initEffort(sizeOf(slot.effort)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      fromWire(in.getName(), slot.name),
      fromWire(in.getPosition(), slot.position),
      fromWire(in.getVelocity(), slot.velocity),
      fromWire(in.getEffort(), slot.effort),
  });
}

void toWire(const JointGoalSlot& slot, wire::JointGoal::Builder out) {
  toWire(slot.position, out.initPosition(sizeOf(slot.position)));
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::JointGoal::Reader in, JointGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return fromWire(in.getPosition(), slot.position);
}

void toWire(const JointSolutionSlot& slot, wire::JointSolution::Builder out) {
  toWire(slot.position, out.initPosition(8));
  out.setJoints(slot.joints);
  out.setFound(slot.found != 0);
}

suture::Errc fromWire(wire::JointSolution::Reader in, JointSolutionSlot& slot, suture::Duration) {
  slot.joints = in.getJoints();
  slot.found = in.getFound();
  return fromWire(in.getPosition(), slot.position);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::JointState& value) {
  return codec::encodeAs<robots::wire::JointState, robots::JointStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointState& value) {
  return codec::decodeAs<robots::wire::JointState, robots::JointStateSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::JointGoal& value) {
  return codec::encodeAs<robots::wire::JointGoal, robots::JointGoalSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointGoal& value) {
  return codec::decodeAs<robots::wire::JointGoal, robots::JointGoalSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::JointSolution& value) {
  return codec::encodeAs<robots::wire::JointSolution, robots::JointSolutionSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointSolution& value) {
  return codec::decodeAs<robots::wire::JointSolution, robots::JointSolutionSlot>(bytes, value);
}

}  // namespace suture
