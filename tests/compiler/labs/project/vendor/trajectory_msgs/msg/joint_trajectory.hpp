#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <rosidl_runtime_cpp/message_initialization.hpp>
#include <std_msgs/msg/header.hpp>
#include <trajectory_msgs/msg/joint_trajectory_point.hpp>

namespace trajectory_msgs {
namespace msg {

template <class ContainerAllocator>
struct JointTrajectory_ {
  using Type = JointTrajectory_<ContainerAllocator>;

  explicit JointTrajectory_(rosidl_runtime_cpp::MessageInitialization _init =
                                rosidl_runtime_cpp::MessageInitialization::ALL)
      : header(_init) {
    (void)_init;
  }
  explicit JointTrajectory_(const ContainerAllocator& _alloc,
                            rosidl_runtime_cpp::MessageInitialization _init =
                                rosidl_runtime_cpp::MessageInitialization::ALL)
      : header(_alloc, _init) {
    (void)_init;
  }

  using _header_type = std_msgs::msg::Header_<ContainerAllocator>;
  _header_type header;
  using _joint_names_type = std::vector<
      std::basic_string<
          char, std::char_traits<char>,
          typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<char>>,
      typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<std::basic_string<
          char, std::char_traits<char>,
          typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<char>>>>;
  _joint_names_type joint_names;
  using _points_type =
      std::vector<trajectory_msgs::msg::JointTrajectoryPoint_<ContainerAllocator>,
                  typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<
                      trajectory_msgs::msg::JointTrajectoryPoint_<ContainerAllocator>>>;
  _points_type points;

  Type& set__header(const std_msgs::msg::Header_<ContainerAllocator>& _arg) {
    this->header = _arg;
    return *this;
  }
  Type& set__joint_names(
      const std::vector<std::basic_string<char, std::char_traits<char>,
                                          typename std::allocator_traits<
                                              ContainerAllocator>::template rebind_alloc<char>>,
                        typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<
                            std::basic_string<char, std::char_traits<char>,
                                              typename std::allocator_traits<ContainerAllocator>::
                                                  template rebind_alloc<char>>>>& _arg) {
    this->joint_names = _arg;
    return *this;
  }
  Type& set__points(
      const std::vector<trajectory_msgs::msg::JointTrajectoryPoint_<ContainerAllocator>,
                        typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<
                            trajectory_msgs::msg::JointTrajectoryPoint_<ContainerAllocator>>>&
          _arg) {
    this->points = _arg;
    return *this;
  }

  using RawPtr = trajectory_msgs::msg::JointTrajectory_<ContainerAllocator>*;
  using ConstRawPtr = const trajectory_msgs::msg::JointTrajectory_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<trajectory_msgs::msg::JointTrajectory_<ContainerAllocator>>;
  template <typename Deleter =
                std::default_delete<trajectory_msgs::msg::JointTrajectory_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<trajectory_msgs::msg::JointTrajectory_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const JointTrajectory_& other) const {
    if (this->header != other.header) return false;
    if (this->joint_names != other.joint_names) return false;
    if (this->points != other.points) return false;
    return true;
  }
  bool operator!=(const JointTrajectory_& other) const { return !this->operator==(other); }
};

using JointTrajectory = trajectory_msgs::msg::JointTrajectory_<std::allocator<void>>;

}  // namespace msg
}  // namespace trajectory_msgs
