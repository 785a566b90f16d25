#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <builtin_interfaces/msg/duration.hpp>
#include <rosidl_runtime_cpp/message_initialization.hpp>

namespace trajectory_msgs {
namespace msg {

template <class ContainerAllocator>
struct JointTrajectoryPoint_ {
  using Type = JointTrajectoryPoint_<ContainerAllocator>;

  explicit JointTrajectoryPoint_(rosidl_runtime_cpp::MessageInitialization _init =
                                     rosidl_runtime_cpp::MessageInitialization::ALL)
      : time_from_start(_init) {
    (void)_init;
  }
  explicit JointTrajectoryPoint_(const ContainerAllocator& _alloc,
                                 rosidl_runtime_cpp::MessageInitialization _init =
                                     rosidl_runtime_cpp::MessageInitialization::ALL)
      : time_from_start(_alloc, _init) {
    (void)_init;
  }

  using _positions_type = std::vector<
      double, typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<double>>;
  _positions_type positions;
  using _velocities_type = std::vector<
      double, typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<double>>;
  _velocities_type velocities;
  using _accelerations_type = std::vector<
      double, typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<double>>;
  _accelerations_type accelerations;
  using _effort_type = std::vector<
      double, typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<double>>;
  _effort_type effort;
  using _time_from_start_type = builtin_interfaces::msg::Duration_<ContainerAllocator>;
  _time_from_start_type time_from_start;

  Type& set__positions(
      const std::vector<double, typename std::allocator_traits<
                                    ContainerAllocator>::template rebind_alloc<double>>& _arg) {
    this->positions = _arg;
    return *this;
  }
  Type& set__velocities(
      const std::vector<double, typename std::allocator_traits<
                                    ContainerAllocator>::template rebind_alloc<double>>& _arg) {
    this->velocities = _arg;
    return *this;
  }
  Type& set__accelerations(
      const std::vector<double, typename std::allocator_traits<
                                    ContainerAllocator>::template rebind_alloc<double>>& _arg) {
    this->accelerations = _arg;
    return *this;
  }
  Type& set__effort(
      const std::vector<double, typename std::allocator_traits<
                                    ContainerAllocator>::template rebind_alloc<double>>& _arg) {
    this->effort = _arg;
    return *this;
  }
  Type& set__time_from_start(const builtin_interfaces::msg::Duration_<ContainerAllocator>& _arg) {
    this->time_from_start = _arg;
    return *this;
  }

  using RawPtr = trajectory_msgs::msg::JointTrajectoryPoint_<ContainerAllocator>*;
  using ConstRawPtr = const trajectory_msgs::msg::JointTrajectoryPoint_<ContainerAllocator>*;
  using SharedPtr =
      std::shared_ptr<trajectory_msgs::msg::JointTrajectoryPoint_<ContainerAllocator>>;
  template <typename Deleter = std::default_delete<
                trajectory_msgs::msg::JointTrajectoryPoint_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<trajectory_msgs::msg::JointTrajectoryPoint_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const JointTrajectoryPoint_& other) const {
    if (this->positions != other.positions) return false;
    if (this->velocities != other.velocities) return false;
    if (this->accelerations != other.accelerations) return false;
    if (this->effort != other.effort) return false;
    if (this->time_from_start != other.time_from_start) return false;
    return true;
  }
  bool operator!=(const JointTrajectoryPoint_& other) const { return !this->operator==(other); }
};

using JointTrajectoryPoint = trajectory_msgs::msg::JointTrajectoryPoint_<std::allocator<void>>;

}  // namespace msg
}  // namespace trajectory_msgs
