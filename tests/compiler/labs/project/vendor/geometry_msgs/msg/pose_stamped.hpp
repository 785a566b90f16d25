#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <geometry_msgs/msg/pose.hpp>
#include <rosidl_runtime_cpp/message_initialization.hpp>
#include <std_msgs/msg/header.hpp>

namespace geometry_msgs {
namespace msg {

template <class ContainerAllocator>
struct PoseStamped_ {
  using Type = PoseStamped_<ContainerAllocator>;

  explicit PoseStamped_(rosidl_runtime_cpp::MessageInitialization _init =
                            rosidl_runtime_cpp::MessageInitialization::ALL)
      : header(_init), pose(_init) {
    (void)_init;
  }
  explicit PoseStamped_(const ContainerAllocator& _alloc,
                        rosidl_runtime_cpp::MessageInitialization _init =
                            rosidl_runtime_cpp::MessageInitialization::ALL)
      : header(_alloc, _init), pose(_alloc, _init) {
    (void)_init;
  }

  using _header_type = std_msgs::msg::Header_<ContainerAllocator>;
  _header_type header;
  using _pose_type = geometry_msgs::msg::Pose_<ContainerAllocator>;
  _pose_type pose;

  Type& set__header(const std_msgs::msg::Header_<ContainerAllocator>& _arg) {
    this->header = _arg;
    return *this;
  }
  Type& set__pose(const geometry_msgs::msg::Pose_<ContainerAllocator>& _arg) {
    this->pose = _arg;
    return *this;
  }

  using RawPtr = geometry_msgs::msg::PoseStamped_<ContainerAllocator>*;
  using ConstRawPtr = const geometry_msgs::msg::PoseStamped_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<geometry_msgs::msg::PoseStamped_<ContainerAllocator>>;
  template <typename Deleter =
                std::default_delete<geometry_msgs::msg::PoseStamped_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<geometry_msgs::msg::PoseStamped_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const PoseStamped_& other) const {
    if (this->header != other.header) return false;
    if (this->pose != other.pose) return false;
    return true;
  }
  bool operator!=(const PoseStamped_& other) const { return !this->operator==(other); }
};

using PoseStamped = geometry_msgs::msg::PoseStamped_<std::allocator<void>>;

}  // namespace msg
}  // namespace geometry_msgs
