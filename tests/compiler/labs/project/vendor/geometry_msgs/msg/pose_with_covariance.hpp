#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <geometry_msgs/msg/pose.hpp>
#include <rosidl_runtime_cpp/message_initialization.hpp>

namespace geometry_msgs {
namespace msg {

template <class ContainerAllocator>
struct PoseWithCovariance_ {
  using Type = PoseWithCovariance_<ContainerAllocator>;

  explicit PoseWithCovariance_(rosidl_runtime_cpp::MessageInitialization _init =
                                   rosidl_runtime_cpp::MessageInitialization::ALL)
      : pose(_init) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      std::fill<typename std::array<double, 36>::iterator, double>(
          this->covariance.begin(), this->covariance.end(), double{});
    }
  }
  explicit PoseWithCovariance_(const ContainerAllocator& _alloc,
                               rosidl_runtime_cpp::MessageInitialization _init =
                                   rosidl_runtime_cpp::MessageInitialization::ALL)
      : pose(_alloc, _init) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      std::fill<typename std::array<double, 36>::iterator, double>(
          this->covariance.begin(), this->covariance.end(), double{});
    }
  }

  using _pose_type = geometry_msgs::msg::Pose_<ContainerAllocator>;
  _pose_type pose;
  using _covariance_type = std::array<double, 36>;
  _covariance_type covariance;

  Type& set__pose(const geometry_msgs::msg::Pose_<ContainerAllocator>& _arg) {
    this->pose = _arg;
    return *this;
  }
  Type& set__covariance(const std::array<double, 36>& _arg) {
    this->covariance = _arg;
    return *this;
  }

  using RawPtr = geometry_msgs::msg::PoseWithCovariance_<ContainerAllocator>*;
  using ConstRawPtr = const geometry_msgs::msg::PoseWithCovariance_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<geometry_msgs::msg::PoseWithCovariance_<ContainerAllocator>>;
  template <typename Deleter =
                std::default_delete<geometry_msgs::msg::PoseWithCovariance_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<geometry_msgs::msg::PoseWithCovariance_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const PoseWithCovariance_& other) const {
    if (this->pose != other.pose) return false;
    if (this->covariance != other.covariance) return false;
    return true;
  }
  bool operator!=(const PoseWithCovariance_& other) const { return !this->operator==(other); }
};

using PoseWithCovariance = geometry_msgs::msg::PoseWithCovariance_<std::allocator<void>>;

}  // namespace msg
}  // namespace geometry_msgs
