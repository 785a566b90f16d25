// Written by suturec from robot_types/kinematics_query.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "robot_types/kinematics_query.h"

namespace robots {

struct ForwardKinematicsRequestSlot {
  suture::BoundedList<double, 8> jp;  // rad
};

bool store(const ForwardKinematicsRequest& value, ForwardKinematicsRequestSlot& slot);
void load(const ForwardKinematicsRequestSlot& slot, ForwardKinematicsRequest& value);
void reserve(const ForwardKinematicsRequestSlot*, ForwardKinematicsRequest& value);

struct ForwardKinematicsResponseSlot {
  std::array<double, 12> cp;  // Eigen::Isometry3d, m
  std::uint8_t result;        // bool
  suture::BoundedText<63> message;
};

bool store(const ForwardKinematicsResponse& value, ForwardKinematicsResponseSlot& slot);
void load(const ForwardKinematicsResponseSlot& slot, ForwardKinematicsResponse& value);
void reserve(const ForwardKinematicsResponseSlot*, ForwardKinematicsResponse& value);

struct InverseKinematicsRequestSlot {
  std::array<double, 12> cp;          // Eigen::Isometry3d, m
  suture::BoundedList<double, 8> jp;  // rad
};

bool store(const InverseKinematicsRequest& value, InverseKinematicsRequestSlot& slot);
void load(const InverseKinematicsRequestSlot& slot, InverseKinematicsRequest& value);
void reserve(const InverseKinematicsRequestSlot*, InverseKinematicsRequest& value);

struct InverseKinematicsResponseSlot {
  suture::BoundedList<double, 8> jp;  // rad
  std::uint8_t result;                // bool
  suture::BoundedText<63> message;
};

bool store(const InverseKinematicsResponse& value, InverseKinematicsResponseSlot& slot);
void load(const InverseKinematicsResponseSlot& slot, InverseKinematicsResponse& value);
void reserve(const InverseKinematicsResponseSlot*, InverseKinematicsResponse& value);

bool isValid(const ForwardKinematicsRequestSlot& slot, suture::FieldPath* path);
bool isValid(const ForwardKinematicsResponseSlot& slot, suture::FieldPath* path);
bool isValid(const InverseKinematicsRequestSlot& slot, suture::FieldPath* path);
bool isValid(const InverseKinematicsResponseSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::ForwardKinematicsRequest& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ForwardKinematicsRequest& value);

template <>
Result<std::vector<std::byte>> encode(const robots::ForwardKinematicsResponse& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ForwardKinematicsResponse& value);

template <>
Result<std::vector<std::byte>> encode(const robots::InverseKinematicsRequest& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::InverseKinematicsRequest& value);

template <>
Result<std::vector<std::byte>> encode(const robots::InverseKinematicsResponse& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::InverseKinematicsResponse& value);

}  // namespace suture
