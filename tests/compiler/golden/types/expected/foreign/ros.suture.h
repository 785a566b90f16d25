// Written by suturec from foreign/ros.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "foreign/ros.h"

namespace foreign {

struct rosTimeSlot {
  std::uint32_t sec;
  std::uint32_t nsec;
};

inline bool store(const ros::Time& value, rosTimeSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.sec, slot.sec);
  fits &= store(value.nsec, slot.nsec);
  return fits;
}

inline void load(const rosTimeSlot& slot, ros::Time& value) {
  using suture::load;
  load(slot.sec, value.sec);
  load(slot.nsec, value.nsec);
}

struct HeaderSlot {
  std::uint32_t seq;
  rosTimeSlot stamp;
  suture::BoundedText<16> frame_id;
};

inline bool store(const Header& value, HeaderSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.seq, slot.seq);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.frame_id, slot.frame_id);
  return fits;
}

inline void load(const HeaderSlot& slot, Header& value) {
  using suture::load;
  load(slot.seq, value.seq);
  load(slot.stamp, value.stamp);
  load(slot.frame_id, value.frame_id);
}

struct PointSlot {
  double x;  // m
  double y;  // m
  double z;  // m
};

inline bool store(const Point& value, PointSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.x, slot.x);
  fits &= store(value.y, slot.y);
  fits &= store(value.z, slot.z);
  return fits;
}

inline void load(const PointSlot& slot, Point& value) {
  using suture::load;
  load(slot.x, value.x);
  load(slot.y, value.y);
  load(slot.z, value.z);
}

struct QuaternionSlot {
  double x;
  double y;
  double z;
  double w;
};

inline bool store(const Quaternion& value, QuaternionSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.x, slot.x);
  fits &= store(value.y, slot.y);
  fits &= store(value.z, slot.z);
  fits &= store(value.w, slot.w);
  return fits;
}

inline void load(const QuaternionSlot& slot, Quaternion& value) {
  using suture::load;
  load(slot.x, value.x);
  load(slot.y, value.y);
  load(slot.z, value.z);
  load(slot.w, value.w);
}

struct PoseSlot {
  PointSlot position;
  QuaternionSlot orientation;
};

inline bool store(const Pose& value, PoseSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.position, slot.position);
  fits &= store(value.orientation, slot.orientation);
  return fits;
}

inline void load(const PoseSlot& slot, Pose& value) {
  using suture::load;
  load(slot.position, value.position);
  load(slot.orientation, value.orientation);
}

struct PoseStampedSlot {
  HeaderSlot header;
  PoseSlot pose;
};

inline bool store(const PoseStamped& value, PoseStampedSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.header, slot.header);
  fits &= store(value.pose, slot.pose);
  return fits;
}

inline void load(const PoseStampedSlot& slot, PoseStamped& value) {
  using suture::load;
  load(slot.header, value.header);
  load(slot.pose, value.pose);
}

struct JointStateSlot {
  HeaderSlot header;
  suture::BoundedList<suture::BoundedText<12>, 4> name;
  suture::BoundedList<double, 4> position;  // rad
  suture::BoundedList<double, 4> velocity;
  suture::BoundedList<double, 4> effort;
};

inline bool store(const JointState& value, JointStateSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.header, slot.header);
  fits &= store(value.name, slot.name);
  fits &= store(value.position, slot.position);
  fits &= store(value.velocity, slot.velocity);
  fits &= store(value.effort, slot.effort);
  return fits;
}

inline void load(const JointStateSlot& slot, JointState& value) {
  using suture::load;
  load(slot.header, value.header);
  load(slot.name, value.name);
  load(slot.position, value.position);
  load(slot.velocity, value.velocity);
  load(slot.effort, value.effort);
}

}  // namespace foreign
