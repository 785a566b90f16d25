#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <builtin_interfaces/msg/time.hpp>
#include <rosidl_runtime_cpp/message_initialization.hpp>

namespace std_msgs {
namespace msg {

template <class ContainerAllocator>
struct Header_ {
  using Type = Header_<ContainerAllocator>;

  explicit Header_(rosidl_runtime_cpp::MessageInitialization _init =
                       rosidl_runtime_cpp::MessageInitialization::ALL)
      : stamp(_init) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->frame_id = "";
    }
  }
  explicit Header_(const ContainerAllocator& _alloc,
                   rosidl_runtime_cpp::MessageInitialization _init =
                       rosidl_runtime_cpp::MessageInitialization::ALL)
      : stamp(_alloc, _init), frame_id(_alloc) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->frame_id = "";
    }
  }

  using _stamp_type = builtin_interfaces::msg::Time_<ContainerAllocator>;
  _stamp_type stamp;
  using _frame_id_type = std::basic_string<
      char, std::char_traits<char>,
      typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<char>>;
  _frame_id_type frame_id;

  Type& set__stamp(const builtin_interfaces::msg::Time_<ContainerAllocator>& _arg) {
    this->stamp = _arg;
    return *this;
  }
  Type& set__frame_id(
      const std::basic_string<
          char, std::char_traits<char>,
          typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<char>>& _arg) {
    this->frame_id = _arg;
    return *this;
  }

  using RawPtr = std_msgs::msg::Header_<ContainerAllocator>*;
  using ConstRawPtr = const std_msgs::msg::Header_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<std_msgs::msg::Header_<ContainerAllocator>>;
  template <typename Deleter = std::default_delete<std_msgs::msg::Header_<ContainerAllocator>>>
  using UniquePtrWithDeleter = std::unique_ptr<std_msgs::msg::Header_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const Header_& other) const {
    if (this->stamp != other.stamp) return false;
    if (this->frame_id != other.frame_id) return false;
    return true;
  }
  bool operator!=(const Header_& other) const { return !this->operator==(other); }
};

using Header = std_msgs::msg::Header_<std::allocator<void>>;

}  // namespace msg
}  // namespace std_msgs
