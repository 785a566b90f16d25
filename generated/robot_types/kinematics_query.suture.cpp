// Written by suturec from robot_types/kinematics_query.h. Do not edit.
#include "robot_types/kinematics_query.suture.h"

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
static_assert(std::is_same_v<decltype(ForwardKinematicsRequest::jp), std::vector<double>>);
static_assert(std::is_same_v<decltype(ForwardKinematicsResponse::cp), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(ForwardKinematicsResponse::result), bool>);
static_assert(std::is_same_v<decltype(ForwardKinematicsResponse::message), std::string>);
static_assert(std::is_same_v<decltype(InverseKinematicsRequest::cp), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(InverseKinematicsRequest::jp), std::vector<double>>);
static_assert(std::is_same_v<decltype(InverseKinematicsResponse::jp), std::vector<double>>);
static_assert(std::is_same_v<decltype(InverseKinematicsResponse::result), bool>);
static_assert(std::is_same_v<decltype(InverseKinematicsResponse::message), std::string>);

}  // namespace

bool store(const ForwardKinematicsRequest& value, ForwardKinematicsRequestSlot& slot) {
  bool fits = true;
  fits &= store(value.jp, slot.jp);
  return fits;
}

void load(const ForwardKinematicsRequestSlot& slot, ForwardKinematicsRequest& value) {
  load(slot.jp, value.jp);
}

void reserve(const ForwardKinematicsRequestSlot*, ForwardKinematicsRequest& value) {
  suture::reserveFor<decltype(ForwardKinematicsRequestSlot::jp)>(value.jp);
}

bool store(const ForwardKinematicsResponse& value, ForwardKinematicsResponseSlot& slot) {
  bool fits = true;
  fits &= store(value.cp, slot.cp);
  fits &= store(value.result, slot.result);
  fits &= store(value.message, slot.message);
  return fits;
}

void load(const ForwardKinematicsResponseSlot& slot, ForwardKinematicsResponse& value) {
  load(slot.cp, value.cp);
  load(slot.result, value.result);
  load(slot.message, value.message);
}

void reserve(const ForwardKinematicsResponseSlot*, ForwardKinematicsResponse& value) {
  suture::reserveFor<decltype(ForwardKinematicsResponseSlot::message)>(value.message);
}

bool store(const InverseKinematicsRequest& value, InverseKinematicsRequestSlot& slot) {
  bool fits = true;
  fits &= store(value.cp, slot.cp);
  fits &= store(value.jp, slot.jp);
  return fits;
}

void load(const InverseKinematicsRequestSlot& slot, InverseKinematicsRequest& value) {
  load(slot.cp, value.cp);
  load(slot.jp, value.jp);
}

void reserve(const InverseKinematicsRequestSlot*, InverseKinematicsRequest& value) {
  suture::reserveFor<decltype(InverseKinematicsRequestSlot::jp)>(value.jp);
}

bool store(const InverseKinematicsResponse& value, InverseKinematicsResponseSlot& slot) {
  bool fits = true;
  fits &= store(value.jp, slot.jp);
  fits &= store(value.result, slot.result);
  fits &= store(value.message, slot.message);
  return fits;
}

void load(const InverseKinematicsResponseSlot& slot, InverseKinematicsResponse& value) {
  load(slot.jp, value.jp);
  load(slot.result, value.result);
  load(slot.message, value.message);
}

void reserve(const InverseKinematicsResponseSlot*, InverseKinematicsResponse& value) {
  suture::reserveFor<decltype(InverseKinematicsResponseSlot::jp)>(value.jp);
  suture::reserveFor<decltype(InverseKinematicsResponseSlot::message)>(value.message);
}

bool isValid(const ForwardKinematicsRequestSlot& slot, suture::FieldPath* path) {
  return isValid(slot.jp, path) || suture::refusedAt(path, "jp");
}

bool isValid(const ForwardKinematicsResponseSlot& slot, suture::FieldPath* path) {
  return isValid(slot.cp) || suture::refusedAt(path, "cp");
}

bool isValid(const InverseKinematicsRequestSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.cp)) return suture::refusedAt(path, "cp");
  return isValid(slot.jp, path) || suture::refusedAt(path, "jp");
}

bool isValid(const InverseKinematicsResponseSlot& slot, suture::FieldPath* path) {
  return isValid(slot.jp, path) || suture::refusedAt(path, "jp");
}

}  // namespace robots
