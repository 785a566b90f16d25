#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <rosidl_runtime_cpp/bounded_vector.hpp>
#include <rosidl_runtime_cpp/message_initialization.hpp>

namespace shape_msgs {
namespace msg {

template <class ContainerAllocator>
struct SolidPrimitive_ {
  using Type = SolidPrimitive_<ContainerAllocator>;

  explicit SolidPrimitive_(rosidl_runtime_cpp::MessageInitialization _init =
                               rosidl_runtime_cpp::MessageInitialization::ALL) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->type = 0;
    }
  }
  explicit SolidPrimitive_(const ContainerAllocator& _alloc,
                           rosidl_runtime_cpp::MessageInitialization _init =
                               rosidl_runtime_cpp::MessageInitialization::ALL) {
    (void)_alloc;
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->type = 0;
    }
  }

  using _type_type = uint8_t;
  _type_type type;
  using _dimensions_type = rosidl_runtime_cpp::BoundedVector<
      double, 3, typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<double>>;
  _dimensions_type dimensions;

  Type& set__type(const uint8_t& _arg) {
    this->type = _arg;
    return *this;
  }
  Type& set__dimensions(
      const rosidl_runtime_cpp::BoundedVector<
          double, 3,
          typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<double>>&
          _arg) {
    this->dimensions = _arg;
    return *this;
  }

  static constexpr uint8_t BOX = 1;
  static constexpr uint8_t SPHERE = 2;
  static constexpr uint8_t BOX_X = 0;

  using RawPtr = shape_msgs::msg::SolidPrimitive_<ContainerAllocator>*;
  using ConstRawPtr = const shape_msgs::msg::SolidPrimitive_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<shape_msgs::msg::SolidPrimitive_<ContainerAllocator>>;
  template <typename Deleter =
                std::default_delete<shape_msgs::msg::SolidPrimitive_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<shape_msgs::msg::SolidPrimitive_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const SolidPrimitive_& other) const {
    if (this->type != other.type) return false;
    if (this->dimensions != other.dimensions) return false;
    return true;
  }
  bool operator!=(const SolidPrimitive_& other) const { return !this->operator==(other); }
};

using SolidPrimitive = shape_msgs::msg::SolidPrimitive_<std::allocator<void>>;

}  // namespace msg
}  // namespace shape_msgs
