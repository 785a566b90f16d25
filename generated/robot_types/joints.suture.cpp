// Written by suturec from robot_types/joints.h. Do not edit.
#include "robot_types/joints.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "robot_types/joints.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(JointState::name), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(JointState::position), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointState::velocity), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointState::effort), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointState::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(JointState::valid), bool>);
static_assert(std::is_same_v<decltype(JointGoal::position), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointGoal::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(JointSolution::position), std::array<double, 8>>);
static_assert(std::is_same_v<decltype(JointSolution::joints), std::uint32_t>);
static_assert(std::is_same_v<decltype(JointSolution::found), bool>);

}  // namespace

bool store(const JointState& value, JointStateSlot& slot) {
  bool fits = true;
  fits &= store(value.name, slot.name);
  fits &= store(value.position, slot.position);
  fits &= store(value.velocity, slot.velocity);
  fits &= store(value.effort, slot.effort);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const JointStateSlot& slot, JointState& value) {
  load(slot.name, value.name);
  load(slot.position, value.position);
  load(slot.velocity, value.velocity);
  load(slot.effort, value.effort);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void reserve(const JointStateSlot*, JointState& value) {
  suture::reserveFor<decltype(JointStateSlot::name)>(value.name);
  suture::reserveFor<decltype(JointStateSlot::position)>(value.position);
  suture::reserveFor<decltype(JointStateSlot::velocity)>(value.velocity);
  suture::reserveFor<decltype(JointStateSlot::effort)>(value.effort);
}

void shiftStamps(JointStateSlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

bool store(const JointGoal& value, JointGoalSlot& slot) {
  bool fits = true;
  fits &= store(value.position, slot.position);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const JointGoalSlot& slot, JointGoal& value) {
  load(slot.position, value.position);
  load(slot.stamp, value.stamp);
}

void reserve(const JointGoalSlot*, JointGoal& value) {
  suture::reserveFor<decltype(JointGoalSlot::position)>(value.position);
}

void shiftStamps(JointGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

bool store(const JointSolution& value, JointSolutionSlot& slot) {
  bool fits = true;
  fits &= store(value.position, slot.position);
  fits &= store(value.joints, slot.joints);
  fits &= store(value.found, slot.found);
  return fits;
}

void load(const JointSolutionSlot& slot, JointSolution& value) {
  load(slot.position, value.position);
  load(slot.joints, value.joints);
  load(slot.found, value.found);
}

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
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::rpc::firstError({
      fromWire(in.getName(), slot.name),
      fromWire(in.getPosition(), slot.position),
      fromWire(in.getVelocity(), slot.velocity),
      fromWire(in.getEffort(), slot.effort),
  });
}

bool isValid(const JointStateSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.position, path)) return suture::refusedAt(path, "position");
  if (!isValid(slot.velocity, path)) return suture::refusedAt(path, "velocity");
  return isValid(slot.effort, path) || suture::refusedAt(path, "effort");
}

void toWire(const JointGoalSlot& slot, wire::JointGoal::Builder out) {
  toWire(slot.position, out.initPosition(sizeOf(slot.position)));
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::JointGoal::Reader in, JointGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  return fromWire(in.getPosition(), slot.position);
}

bool isValid(const JointGoalSlot& slot, suture::FieldPath* path) {
  return isValid(slot.position, path) || suture::refusedAt(path, "position");
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

bool isValid(const JointSolutionSlot& slot, suture::FieldPath* path) {
  return isValid(slot.position, path) || suture::refusedAt(path, "position");
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::JointState& value) {
  return rpc::encodeAs<robots::wire::JointState, robots::JointStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointState& value) {
  return rpc::decodeAs<robots::wire::JointState, robots::JointStateSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::JointGoal& value) {
  return rpc::encodeAs<robots::wire::JointGoal, robots::JointGoalSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointGoal& value) {
  return rpc::decodeAs<robots::wire::JointGoal, robots::JointGoalSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::JointSolution& value) {
  return rpc::encodeAs<robots::wire::JointSolution, robots::JointSolutionSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointSolution& value) {
  return rpc::decodeAs<robots::wire::JointSolution, robots::JointSolutionSlot>(bytes, value);
}

}  // namespace suture
