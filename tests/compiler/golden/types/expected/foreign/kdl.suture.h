// Written by suturec from foreign/kdl.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "foreign/kdl.h"

namespace foreign {

struct KDLVectorSlot {
  std::array<double, 3> data;  // m
};

inline bool store(const KDL::Vector& value, KDLVectorSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.data, slot.data);
  return fits;
}

inline void load(const KDLVectorSlot& slot, KDL::Vector& value) {
  using suture::load;
  load(slot.data, value.data);
}

struct KDLRotationSlot {
  std::array<double, 9> data;
};

inline bool store(const KDL::Rotation& value, KDLRotationSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.data, slot.data);
  return fits;
}

inline void load(const KDLRotationSlot& slot, KDL::Rotation& value) {
  using suture::load;
  load(slot.data, value.data);
}

struct KDLFrameSlot {
  KDLVectorSlot p;
  KDLRotationSlot M;
};

inline bool store(const KDL::Frame& value, KDLFrameSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.p, slot.p);
  fits &= store(value.M, slot.M);
  return fits;
}

inline void load(const KDLFrameSlot& slot, KDL::Frame& value) {
  using suture::load;
  load(slot.p, value.p);
  load(slot.M, value.M);
}

struct KDLTwistSlot {
  KDLVectorSlot vel;
  KDLVectorSlot rot;
};

inline bool store(const KDL::Twist& value, KDLTwistSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.vel, slot.vel);
  fits &= store(value.rot, slot.rot);
  return fits;
}

inline void load(const KDLTwistSlot& slot, KDL::Twist& value) {
  using suture::load;
  load(slot.vel, value.vel);
  load(slot.rot, value.rot);
}

struct KDLWrenchSlot {
  KDLVectorSlot force;
  KDLVectorSlot torque;
};

inline bool store(const KDL::Wrench& value, KDLWrenchSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  return fits;
}

inline void load(const KDLWrenchSlot& slot, KDL::Wrench& value) {
  using suture::load;
  load(slot.force, value.force);
  load(slot.torque, value.torque);
}

struct KDLJntArraySlot {
  suture::BoundedList<double, 7> data;
};

inline bool store(const KDL::JntArray& value, KDLJntArraySlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.data, slot.data);
  return fits;
}

inline void load(const KDLJntArraySlot& slot, KDL::JntArray& value) {
  using suture::load;
  load(slot.data, value.data);
}

/// All of them in a struct of ours.
struct MotionSlot {
  KDLFrameSlot frame;
  KDLTwistSlot twist;
  KDLWrenchSlot wrench;
  KDLJntArraySlot joints;
};

inline bool store(const Motion& value, MotionSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.frame, slot.frame);
  fits &= store(value.twist, slot.twist);
  fits &= store(value.wrench, slot.wrench);
  fits &= store(value.joints, slot.joints);
  return fits;
}

inline void load(const MotionSlot& slot, Motion& value) {
  using suture::load;
  load(slot.frame, value.frame);
  load(slot.twist, value.twist);
  load(slot.wrench, value.wrench);
  load(slot.joints, value.joints);
}

}  // namespace foreign
