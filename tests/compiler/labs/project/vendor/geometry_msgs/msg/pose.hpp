#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <geometry_msgs/msg/point.hpp>
#include <geometry_msgs/msg/quaternion.hpp>
#include <rosidl_runtime_cpp/message_initialization.hpp>

namespace geometry_msgs {
namespace msg {

template <class ContainerAllocator>
struct Pose_ {
  using Type = Pose_<ContainerAllocator>;

  explicit Pose_(rosidl_runtime_cpp::MessageInitialization _init =
                     rosidl_runtime_cpp::MessageInitialization::ALL)
      : position(_init), orientation(_init) {
    (void)_init;
  }
  explicit Pose_(const ContainerAllocator& _alloc,
                 rosidl_runtime_cpp::MessageInitialization _init =
                     rosidl_runtime_cpp::MessageInitialization::ALL)
      : position(_alloc, _init), orientation(_alloc, _init) {
    (void)_init;
  }

  using _position_type = geometry_msgs::msg::Point_<ContainerAllocator>;
  _position_type position;
  using _orientation_type = geometry_msgs::msg::Quaternion_<ContainerAllocator>;
  _orientation_type orientation;

  Type& set__position(const geometry_msgs::msg::Point_<ContainerAllocator>& _arg) {
    this->position = _arg;
    return *this;
  }
  Type& set__orientation(const geometry_msgs::msg::Quaternion_<ContainerAllocator>& _arg) {
    this->orientation = _arg;
    return *this;
  }

  using RawPtr = geometry_msgs::msg::Pose_<ContainerAllocator>*;
  using ConstRawPtr = const geometry_msgs::msg::Pose_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<geometry_msgs::msg::Pose_<ContainerAllocator>>;
  template <typename Deleter = std::default_delete<geometry_msgs::msg::Pose_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<geometry_msgs::msg::Pose_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const Pose_& other) const {
    if (this->position != other.position) return false;
    if (this->orientation != other.orientation) return false;
    return true;
  }
  bool operator!=(const Pose_& other) const { return !this->operator==(other); }
};

using Pose = geometry_msgs::msg::Pose_<std::allocator<void>>;

}  // namespace msg
}  // namespace geometry_msgs
