// Written by suturec from foreign/kdl.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "foreign/kdl.h"

namespace foreign {

struct KDLVectorSlot {
  std::array<double, 3> data;  // m
};

bool store(const KDL::Vector& value, KDLVectorSlot& slot);
void load(const KDLVectorSlot& slot, KDL::Vector& value);

struct KDLRotationSlot {
  std::array<double, 9> data;
};

bool store(const KDL::Rotation& value, KDLRotationSlot& slot);
void load(const KDLRotationSlot& slot, KDL::Rotation& value);

struct KDLFrameSlot {
  KDLVectorSlot p;
  KDLRotationSlot M;
};

bool store(const KDL::Frame& value, KDLFrameSlot& slot);
void load(const KDLFrameSlot& slot, KDL::Frame& value);

struct KDLTwistSlot {
  KDLVectorSlot vel;
  KDLVectorSlot rot;
};

bool store(const KDL::Twist& value, KDLTwistSlot& slot);
void load(const KDLTwistSlot& slot, KDL::Twist& value);

struct KDLWrenchSlot {
  KDLVectorSlot force;
  KDLVectorSlot torque;
};

bool store(const KDL::Wrench& value, KDLWrenchSlot& slot);
void load(const KDLWrenchSlot& slot, KDL::Wrench& value);

struct KDLJntArraySlot {
  suture::BoundedList<double, 7> data;
};

bool store(const KDL::JntArray& value, KDLJntArraySlot& slot);
void load(const KDLJntArraySlot& slot, KDL::JntArray& value);

/// All of them in a struct of ours.
struct MotionSlot {
  KDLFrameSlot frame;
  KDLTwistSlot twist;
  KDLWrenchSlot wrench;
  KDLJntArraySlot joints;
};

bool store(const Motion& value, MotionSlot& slot);
void load(const MotionSlot& slot, Motion& value);

bool isValid(const KDLVectorSlot& slot, suture::FieldPath* path);
bool isValid(const KDLRotationSlot& slot, suture::FieldPath* path);
bool isValid(const KDLFrameSlot& slot, suture::FieldPath* path);
bool isValid(const KDLTwistSlot& slot, suture::FieldPath* path);
bool isValid(const KDLWrenchSlot& slot, suture::FieldPath* path);
bool isValid(const KDLJntArraySlot& slot, suture::FieldPath* path);
bool isValid(const MotionSlot& slot, suture::FieldPath* path);

}  // namespace foreign

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const KDL::Vector& value);
template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Vector& value);

template <>
Result<std::vector<std::byte>> encode(const KDL::Rotation& value);
template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Rotation& value);

template <>
Result<std::vector<std::byte>> encode(const KDL::Frame& value);
template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Frame& value);

template <>
Result<std::vector<std::byte>> encode(const KDL::Twist& value);
template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Twist& value);

template <>
Result<std::vector<std::byte>> encode(const KDL::Wrench& value);
template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Wrench& value);

template <>
Result<std::vector<std::byte>> encode(const KDL::JntArray& value);
template <>
Result<> decode(std::span<const std::byte> bytes, KDL::JntArray& value);

template <>
Result<std::vector<std::byte>> encode(const foreign::Motion& value);
template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Motion& value);

}  // namespace suture
