#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <rosidl_runtime_cpp/message_initialization.hpp>

namespace builtin_interfaces {
namespace msg {

template <class ContainerAllocator>
struct Duration_ {
  using Type = Duration_<ContainerAllocator>;

  explicit Duration_(rosidl_runtime_cpp::MessageInitialization _init =
                         rosidl_runtime_cpp::MessageInitialization::ALL) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->sec = 0l;
      this->nanosec = 0ul;
    }
  }
  explicit Duration_(const ContainerAllocator& _alloc,
                     rosidl_runtime_cpp::MessageInitialization _init =
                         rosidl_runtime_cpp::MessageInitialization::ALL) {
    (void)_alloc;
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->sec = 0l;
      this->nanosec = 0ul;
    }
  }

  using _sec_type = int32_t;
  _sec_type sec;
  using _nanosec_type = uint32_t;
  _nanosec_type nanosec;

  Type& set__sec(const int32_t& _arg) {
    this->sec = _arg;
    return *this;
  }
  Type& set__nanosec(const uint32_t& _arg) {
    this->nanosec = _arg;
    return *this;
  }

  using RawPtr = builtin_interfaces::msg::Duration_<ContainerAllocator>*;
  using ConstRawPtr = const builtin_interfaces::msg::Duration_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<builtin_interfaces::msg::Duration_<ContainerAllocator>>;
  template <typename Deleter =
                std::default_delete<builtin_interfaces::msg::Duration_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<builtin_interfaces::msg::Duration_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const Duration_& other) const {
    if (this->sec != other.sec) return false;
    if (this->nanosec != other.nanosec) return false;
    return true;
  }
  bool operator!=(const Duration_& other) const { return !this->operator==(other); }
};

using Duration = builtin_interfaces::msg::Duration_<std::allocator<void>>;

}  // namespace msg
}  // namespace builtin_interfaces
