// Written by suturec from foreign/ros.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "foreign/ros.h"

namespace foreign {

struct rosTimeSlot {
  std::uint32_t sec;
  std::uint32_t nsec;
};

bool store(const ros::Time& value, rosTimeSlot& slot);
void load(const rosTimeSlot& slot, ros::Time& value);

struct HeaderSlot {
  std::uint32_t seq;
  rosTimeSlot stamp;
  suture::BoundedText<16> frame_id;
};

bool store(const Header& value, HeaderSlot& slot);
void load(const HeaderSlot& slot, Header& value);
void reserve(const HeaderSlot*, Header& value);

struct PointSlot {
  double x;  // m
  double y;  // m
  double z;  // m
};

bool store(const Point& value, PointSlot& slot);
void load(const PointSlot& slot, Point& value);

struct QuaternionSlot {
  double x;
  double y;
  double z;
  double w;
};

bool store(const Quaternion& value, QuaternionSlot& slot);
void load(const QuaternionSlot& slot, Quaternion& value);

struct PoseSlot {
  PointSlot position;
  QuaternionSlot orientation;
};

bool store(const Pose& value, PoseSlot& slot);
void load(const PoseSlot& slot, Pose& value);

struct PoseStampedSlot {
  HeaderSlot header;
  PoseSlot pose;
};

bool store(const PoseStamped& value, PoseStampedSlot& slot);
void load(const PoseStampedSlot& slot, PoseStamped& value);
void reserve(const PoseStampedSlot*, PoseStamped& value);

struct JointStateSlot {
  HeaderSlot header;
  suture::BoundedList<suture::BoundedText<12>, 4> name;
  suture::BoundedList<double, 4> position;  // rad
  suture::BoundedList<double, 4> velocity;
  suture::BoundedList<double, 4> effort;
};

bool store(const JointState& value, JointStateSlot& slot);
void load(const JointStateSlot& slot, JointState& value);
void reserve(const JointStateSlot*, JointState& value);

bool isValid(const rosTimeSlot& slot, suture::FieldPath* path);
bool isValid(const HeaderSlot& slot, suture::FieldPath* path);
bool isValid(const PointSlot& slot, suture::FieldPath* path);
bool isValid(const QuaternionSlot& slot, suture::FieldPath* path);
bool isValid(const PoseSlot& slot, suture::FieldPath* path);
bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path);
bool isValid(const JointStateSlot& slot, suture::FieldPath* path);

}  // namespace foreign

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const ros::Time& value);
template <>
Result<> decode(std::span<const std::byte> bytes, ros::Time& value);

template <>
Result<std::vector<std::byte>> encode(const foreign::Header& value);
template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Header& value);

template <>
Result<std::vector<std::byte>> encode(const foreign::Point& value);
template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Point& value);

template <>
Result<std::vector<std::byte>> encode(const foreign::Quaternion& value);
template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Quaternion& value);

template <>
Result<std::vector<std::byte>> encode(const foreign::Pose& value);
template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Pose& value);

template <>
Result<std::vector<std::byte>> encode(const foreign::PoseStamped& value);
template <>
Result<> decode(std::span<const std::byte> bytes, foreign::PoseStamped& value);

template <>
Result<std::vector<std::byte>> encode(const foreign::JointState& value);
template <>
Result<> decode(std::span<const std::byte> bytes, foreign::JointState& value);

}  // namespace suture
