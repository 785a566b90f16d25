// Written by suturec from foreign/kdl.h. Do not edit.
#include "foreign/kdl.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace foreign {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(KDL::Vector::data), double[3]>);
static_assert(std::is_same_v<decltype(KDL::Rotation::data), double[9]>);
static_assert(std::is_same_v<decltype(KDL::Frame::p), KDL::Vector>);
static_assert(std::is_same_v<decltype(KDL::Frame::M), KDL::Rotation>);
static_assert(std::is_same_v<decltype(KDL::Twist::vel), KDL::Vector>);
static_assert(std::is_same_v<decltype(KDL::Twist::rot), KDL::Vector>);
static_assert(std::is_same_v<decltype(KDL::Wrench::force), KDL::Vector>);
static_assert(std::is_same_v<decltype(KDL::Wrench::torque), KDL::Vector>);
static_assert(std::is_same_v<decltype(KDL::JntArray::data), Eigen::VectorXd>);
static_assert(std::is_same_v<decltype(Motion::frame), KDL::Frame>);
static_assert(std::is_same_v<decltype(Motion::twist), KDL::Twist>);
static_assert(std::is_same_v<decltype(Motion::wrench), KDL::Wrench>);
static_assert(std::is_same_v<decltype(Motion::joints), KDL::JntArray>);

}  // namespace

bool store(const KDL::Vector& value, KDLVectorSlot& slot) {
  bool fits = true;
  fits &= store(value.data, slot.data);
  return fits;
}

void load(const KDLVectorSlot& slot, KDL::Vector& value) {
  load(slot.data, value.data);
}

bool store(const KDL::Rotation& value, KDLRotationSlot& slot) {
  bool fits = true;
  fits &= store(value.data, slot.data);
  return fits;
}

void load(const KDLRotationSlot& slot, KDL::Rotation& value) {
  load(slot.data, value.data);
}

bool store(const KDL::Frame& value, KDLFrameSlot& slot) {
  bool fits = true;
  fits &= store(value.p, slot.p);
  fits &= store(value.M, slot.M);
  return fits;
}

void load(const KDLFrameSlot& slot, KDL::Frame& value) {
  load(slot.p, value.p);
  load(slot.M, value.M);
}

bool store(const KDL::Twist& value, KDLTwistSlot& slot) {
  bool fits = true;
  fits &= store(value.vel, slot.vel);
  fits &= store(value.rot, slot.rot);
  return fits;
}

void load(const KDLTwistSlot& slot, KDL::Twist& value) {
  load(slot.vel, value.vel);
  load(slot.rot, value.rot);
}

bool store(const KDL::Wrench& value, KDLWrenchSlot& slot) {
  bool fits = true;
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  return fits;
}

void load(const KDLWrenchSlot& slot, KDL::Wrench& value) {
  load(slot.force, value.force);
  load(slot.torque, value.torque);
}

bool store(const KDL::JntArray& value, KDLJntArraySlot& slot) {
  bool fits = true;
  fits &= store(value.data, slot.data);
  return fits;
}

void load(const KDLJntArraySlot& slot, KDL::JntArray& value) {
  load(slot.data, value.data);
}

bool store(const Motion& value, MotionSlot& slot) {
  bool fits = true;
  fits &= store(value.frame, slot.frame);
  fits &= store(value.twist, slot.twist);
  fits &= store(value.wrench, slot.wrench);
  fits &= store(value.joints, slot.joints);
  return fits;
}

void load(const MotionSlot& slot, Motion& value) {
  load(slot.frame, value.frame);
  load(slot.twist, value.twist);
  load(slot.wrench, value.wrench);
  load(slot.joints, value.joints);
}

bool isValid(const KDLVectorSlot& slot, suture::FieldPath* path) {
  return isValid(slot.data, path) || suture::refusedAt(path, "data");
}

bool isValid(const KDLRotationSlot& slot, suture::FieldPath* path) {
  return isValid(slot.data, path) || suture::refusedAt(path, "data");
}

bool isValid(const KDLFrameSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.p, path)) return suture::refusedAt(path, "p");
  return isValid(slot.M, path) || suture::refusedAt(path, "M");
}

bool isValid(const KDLTwistSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.vel, path)) return suture::refusedAt(path, "vel");
  return isValid(slot.rot, path) || suture::refusedAt(path, "rot");
}

bool isValid(const KDLWrenchSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.force, path)) return suture::refusedAt(path, "force");
  return isValid(slot.torque, path) || suture::refusedAt(path, "torque");
}

bool isValid(const KDLJntArraySlot& slot, suture::FieldPath* path) {
  if (!suture::allOf(slot.data, path, [](const double& element) {
    return suture::inRange(element, -6.5, 6.5);
  })) {
    return suture::refusedAt(path, "data");
  }
  return true;
}

bool isValid(const MotionSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.frame, path)) return suture::refusedAt(path, "frame");
  if (!isValid(slot.twist, path)) return suture::refusedAt(path, "twist");
  if (!isValid(slot.wrench, path)) return suture::refusedAt(path, "wrench");
  return isValid(slot.joints, path) || suture::refusedAt(path, "joints");
}

}  // namespace foreign
