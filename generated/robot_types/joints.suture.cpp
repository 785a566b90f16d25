// Written by suturec from robot_types/joints.h. Do not edit.
#include "robot_types/joints.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
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
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
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
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
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

bool isValid(const JointStateSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.position, path)) return suture::refusedAt(path, "position");
  if (!isValid(slot.velocity, path)) return suture::refusedAt(path, "velocity");
  return isValid(slot.effort, path) || suture::refusedAt(path, "effort");
}

bool isValid(const JointGoalSlot& slot, suture::FieldPath* path) {
  return isValid(slot.position, path) || suture::refusedAt(path, "position");
}

bool isValid(const JointSolutionSlot& slot, suture::FieldPath* path) {
  return isValid(slot.position, path) || suture::refusedAt(path, "position");
}

}  // namespace robots
