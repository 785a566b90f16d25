#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <rosidl_runtime_cpp/message_initialization.hpp>

namespace geometry_msgs {
namespace msg {

template <class ContainerAllocator>
struct Quaternion_ {
  using Type = Quaternion_<ContainerAllocator>;

  explicit Quaternion_(rosidl_runtime_cpp::MessageInitialization _init =
                           rosidl_runtime_cpp::MessageInitialization::ALL) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->x = 0.0;
      this->y = 0.0;
      this->z = 0.0;
      this->w = 0.0;
    }
  }
  explicit Quaternion_(const ContainerAllocator& _alloc,
                       rosidl_runtime_cpp::MessageInitialization _init =
                           rosidl_runtime_cpp::MessageInitialization::ALL) {
    (void)_alloc;
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->x = 0.0;
      this->y = 0.0;
      this->z = 0.0;
      this->w = 0.0;
    }
  }

  using _x_type = double;
  _x_type x;
  using _y_type = double;
  _y_type y;
  using _z_type = double;
  _z_type z;
  using _w_type = double;
  _w_type w;

  Type& set__x(const double& _arg) {
    this->x = _arg;
    return *this;
  }
  Type& set__y(const double& _arg) {
    this->y = _arg;
    return *this;
  }
  Type& set__z(const double& _arg) {
    this->z = _arg;
    return *this;
  }
  Type& set__w(const double& _arg) {
    this->w = _arg;
    return *this;
  }

  using RawPtr = geometry_msgs::msg::Quaternion_<ContainerAllocator>*;
  using ConstRawPtr = const geometry_msgs::msg::Quaternion_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<geometry_msgs::msg::Quaternion_<ContainerAllocator>>;
  template <typename Deleter =
                std::default_delete<geometry_msgs::msg::Quaternion_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<geometry_msgs::msg::Quaternion_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const Quaternion_& other) const {
    if (this->x != other.x) return false;
    if (this->y != other.y) return false;
    if (this->z != other.z) return false;
    if (this->w != other.w) return false;
    return true;
  }
  bool operator!=(const Quaternion_& other) const { return !this->operator==(other); }
};

using Quaternion = geometry_msgs::msg::Quaternion_<std::allocator<void>>;

}  // namespace msg
}  // namespace geometry_msgs
