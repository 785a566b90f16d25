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
struct BatteryState_ {
  using Type = BatteryState_<ContainerAllocator>;

  explicit BatteryState_(rosidl_runtime_cpp::MessageInitialization _init =
                             rosidl_runtime_cpp::MessageInitialization::ALL)
      : header(_init) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->voltage = 0.0f;
      this->power_supply_status = 0;
      this->present = false;
      this->location = "";
    }
  }
  explicit BatteryState_(const ContainerAllocator& _alloc,
                         rosidl_runtime_cpp::MessageInitialization _init =
                             rosidl_runtime_cpp::MessageInitialization::ALL)
      : header(_alloc, _init), location(_alloc) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->voltage = 0.0f;
      this->power_supply_status = 0;
      this->present = false;
      this->location = "";
    }
  }

  using _header_type = std_msgs::msg::Header_<ContainerAllocator>;
  _header_type header;
  using _voltage_type = float;
  _voltage_type voltage;
  using _power_supply_status_type = uint8_t;
  _power_supply_status_type power_supply_status;
  using _present_type = bool;
  _present_type present;
  using _cell_voltage_type =
      std::vector<float,
                  typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<float>>;
  _cell_voltage_type cell_voltage;
  using _location_type = std::basic_string<
      char, std::char_traits<char>,
      typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<char>>;
  _location_type location;

  Type& set__header(const std_msgs::msg::Header_<ContainerAllocator>& _arg) {
    this->header = _arg;
    return *this;
  }
  Type& set__voltage(const float& _arg) {
    this->voltage = _arg;
    return *this;
  }
  Type& set__power_supply_status(const uint8_t& _arg) {
    this->power_supply_status = _arg;
    return *this;
  }
  Type& set__present(const bool& _arg) {
    this->present = _arg;
    return *this;
  }
  Type& set__cell_voltage(
      const std::vector<
          float, typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<float>>&
          _arg) {
    this->cell_voltage = _arg;
    return *this;
  }
  Type& set__location(
      const std::basic_string<
          char, std::char_traits<char>,
          typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<char>>& _arg) {
    this->location = _arg;
    return *this;
  }

  static constexpr uint8_t POWER_SUPPLY_STATUS_UNKNOWN = 0u;
  static constexpr uint8_t POWER_SUPPLY_STATUS_CHARGING = 1u;

  using RawPtr = sensor_msgs::msg::BatteryState_<ContainerAllocator>*;
  using ConstRawPtr = const sensor_msgs::msg::BatteryState_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<sensor_msgs::msg::BatteryState_<ContainerAllocator>>;
  template <typename Deleter =
                std::default_delete<sensor_msgs::msg::BatteryState_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<sensor_msgs::msg::BatteryState_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const BatteryState_& other) const {
    if (this->header != other.header) return false;
    if (this->voltage != other.voltage) return false;
    if (this->power_supply_status != other.power_supply_status) return false;
    if (this->present != other.present) return false;
    if (this->cell_voltage != other.cell_voltage) return false;
    if (this->location != other.location) return false;
    return true;
  }
  bool operator!=(const BatteryState_& other) const { return !this->operator==(other); }
};

using BatteryState = sensor_msgs::msg::BatteryState_<std::allocator<void>>;

}  // namespace msg
}  // namespace sensor_msgs
