// Written by suturec from robot_types/kinematics_query.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "robot_types/kinematics_query.h"

namespace robots {

struct ForwardKinematicsRequestSlot {
  suture::BoundedList<double, 8> jp;  // rad
};

inline bool store(const ForwardKinematicsRequest& value, ForwardKinematicsRequestSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.jp, slot.jp);
  return fits;
}

inline void load(const ForwardKinematicsRequestSlot& slot, ForwardKinematicsRequest& value) {
  using suture::load;
  load(slot.jp, value.jp);
}

struct ForwardKinematicsResponseSlot {
  std::array<double, 12> cp;  // Eigen::Isometry3d, m
  std::uint8_t result;        // bool
  suture::BoundedText<63> message;
};

inline bool store(const ForwardKinematicsResponse& value, ForwardKinematicsResponseSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.cp, slot.cp);
  fits &= store(value.result, slot.result);
  fits &= store(value.message, slot.message);
  return fits;
}

inline void load(const ForwardKinematicsResponseSlot& slot, ForwardKinematicsResponse& value) {
  using suture::load;
  load(slot.cp, value.cp);
  load(slot.result, value.result);
  load(slot.message, value.message);
}

struct InverseKinematicsRequestSlot {
  std::array<double, 12> cp;          // Eigen::Isometry3d, m
  suture::BoundedList<double, 8> jp;  // rad
};

inline bool store(const InverseKinematicsRequest& value, InverseKinematicsRequestSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.cp, slot.cp);
  fits &= store(value.jp, slot.jp);
  return fits;
}

inline void load(const InverseKinematicsRequestSlot& slot, InverseKinematicsRequest& value) {
  using suture::load;
  load(slot.cp, value.cp);
  load(slot.jp, value.jp);
}

struct InverseKinematicsResponseSlot {
  suture::BoundedList<double, 8> jp;  // rad
  std::uint8_t result;                // bool
  suture::BoundedText<63> message;
};

inline bool store(const InverseKinematicsResponse& value, InverseKinematicsResponseSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.jp, slot.jp);
  fits &= store(value.result, slot.result);
  fits &= store(value.message, slot.message);
  return fits;
}

inline void load(const InverseKinematicsResponseSlot& slot, InverseKinematicsResponse& value) {
  using suture::load;
  load(slot.jp, value.jp);
  load(slot.result, value.result);
  load(slot.message, value.message);
}

}  // namespace robots
