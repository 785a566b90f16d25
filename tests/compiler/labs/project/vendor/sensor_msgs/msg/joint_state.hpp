#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <rosidl_runtime_cpp/message_initialization.hpp>
#include <std_msgs/msg/header.hpp>

namespace sensor_msgs {
namespace msg {

template <class ContainerAllocator>
struct JointState_ {
  using Type = JointState_<ContainerAllocator>;

  explicit JointState_(rosidl_runtime_cpp::MessageInitialization _init =
                           rosidl_runtime_cpp::MessageInitialization::ALL)
      : header(_init) {
    (void)_init;
  }
  explicit JointState_(const ContainerAllocator& _alloc,
                       rosidl_runtime_cpp::MessageInitialization _init =
                           rosidl_runtime_cpp::MessageInitialization::ALL)
      : header(_alloc, _init) {
    (void)_init;
  }

  using _header_type = std_msgs::msg::Header_<ContainerAllocator>;
  _header_type header;
  using _name_type = std::vector<
      std::basic_string<
          char, std::char_traits<char>,
          typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<char>>,
      typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<std::basic_string<
          char, std::char_traits<char>,
          typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<char>>>>;
  _name_type name;
  using _position_type = std::vector<
      double, typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<double>>;
  _position_type position;
  using _velocity_type = std::vector<
      double, typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<double>>;
  _velocity_type velocity;
  using _effort_type = std::vector<
      double, typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<double>>;
  _effort_type effort;

  Type& set__header(const std_msgs::msg::Header_<ContainerAllocator>& _arg) {
    this->header = _arg;
    return *this;
  }
  Type& set__name(
      const std::vector<std::basic_string<char, std::char_traits<char>,
                                          typename std::allocator_traits<
                                              ContainerAllocator>::template rebind_alloc<char>>,
                        typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<
                            std::basic_string<char, std::char_traits<char>,
                                              typename std::allocator_traits<ContainerAllocator>::
                                                  template rebind_alloc<char>>>>& _arg) {
    this->name = _arg;
    return *this;
  }
  Type& set__position(
      const std::vector<double, typename std::allocator_traits<
                                    ContainerAllocator>::template rebind_alloc<double>>& _arg) {
    this->position = _arg;
    return *this;
  }
  Type& set__velocity(
      const std::vector<double, typename std::allocator_traits<
                                    ContainerAllocator>::template rebind_alloc<double>>& _arg) {
    this->velocity = _arg;
    return *this;
  }
  Type& set__effort(
      const std::vector<double, typename std::allocator_traits<
                                    ContainerAllocator>::template rebind_alloc<double>>& _arg) {
    this->effort = _arg;
    return *this;
  }

  using RawPtr = sensor_msgs::msg::JointState_<ContainerAllocator>*;
  using ConstRawPtr = const sensor_msgs::msg::JointState_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<sensor_msgs::msg::JointState_<ContainerAllocator>>;
  template <typename Deleter =
                std::default_delete<sensor_msgs::msg::JointState_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<sensor_msgs::msg::JointState_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const JointState_& other) const {
    if (this->header != other.header) return false;
    if (this->name != other.name) return false;
    if (this->position != other.position) return false;
    if (this->velocity != other.velocity) return false;
    if (this->effort != other.effort) return false;
    return true;
  }
  bool operator!=(const JointState_& other) const { return !this->operator==(other); }
};

using JointState = sensor_msgs::msg::JointState_<std::allocator<void>>;

}  // namespace msg
}  // namespace sensor_msgs
