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
struct Image_ {
  using Type = Image_<ContainerAllocator>;

  explicit Image_(rosidl_runtime_cpp::MessageInitialization _init =
                      rosidl_runtime_cpp::MessageInitialization::ALL)
      : header(_init) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->height = 0ul;
      this->width = 0ul;
      this->encoding = "";
      this->is_bigendian = 0;
      this->step = 0ul;
    }
  }
  explicit Image_(const ContainerAllocator& _alloc,
                  rosidl_runtime_cpp::MessageInitialization _init =
                      rosidl_runtime_cpp::MessageInitialization::ALL)
      : header(_alloc, _init), encoding(_alloc) {
    using rosidl_runtime_cpp::MessageInitialization;
    if (MessageInitialization::ALL == _init || MessageInitialization::ZERO == _init) {
      this->height = 0ul;
      this->width = 0ul;
      this->encoding = "";
      this->is_bigendian = 0;
      this->step = 0ul;
    }
  }

  using _header_type = std_msgs::msg::Header_<ContainerAllocator>;
  _header_type header;
  using _height_type = uint32_t;
  _height_type height;
  using _width_type = uint32_t;
  _width_type width;
  using _encoding_type = std::basic_string<
      char, std::char_traits<char>,
      typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<char>>;
  _encoding_type encoding;
  using _is_bigendian_type = uint8_t;
  _is_bigendian_type is_bigendian;
  using _step_type = uint32_t;
  _step_type step;
  using _data_type = std::vector<
      uint8_t, typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<uint8_t>>;
  _data_type data;

  Type& set__header(const std_msgs::msg::Header_<ContainerAllocator>& _arg) {
    this->header = _arg;
    return *this;
  }
  Type& set__height(const uint32_t& _arg) {
    this->height = _arg;
    return *this;
  }
  Type& set__width(const uint32_t& _arg) {
    this->width = _arg;
    return *this;
  }
  Type& set__encoding(
      const std::basic_string<
          char, std::char_traits<char>,
          typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<char>>& _arg) {
    this->encoding = _arg;
    return *this;
  }
  Type& set__is_bigendian(const uint8_t& _arg) {
    this->is_bigendian = _arg;
    return *this;
  }
  Type& set__step(const uint32_t& _arg) {
    this->step = _arg;
    return *this;
  }
  Type& set__data(
      const std::vector<uint8_t, typename std::allocator_traits<
                                     ContainerAllocator>::template rebind_alloc<uint8_t>>& _arg) {
    this->data = _arg;
    return *this;
  }

  using RawPtr = sensor_msgs::msg::Image_<ContainerAllocator>*;
  using ConstRawPtr = const sensor_msgs::msg::Image_<ContainerAllocator>*;
  using SharedPtr = std::shared_ptr<sensor_msgs::msg::Image_<ContainerAllocator>>;
  template <typename Deleter = std::default_delete<sensor_msgs::msg::Image_<ContainerAllocator>>>
  using UniquePtrWithDeleter =
      std::unique_ptr<sensor_msgs::msg::Image_<ContainerAllocator>, Deleter>;
  using UniquePtr = UniquePtrWithDeleter<>;

  bool operator==(const Image_& other) const {
    if (this->header != other.header) return false;
    if (this->height != other.height) return false;
    if (this->width != other.width) return false;
    if (this->encoding != other.encoding) return false;
    if (this->is_bigendian != other.is_bigendian) return false;
    if (this->step != other.step) return false;
    if (this->data != other.data) return false;
    return true;
  }
  bool operator!=(const Image_& other) const { return !this->operator==(other); }
};

using Image = sensor_msgs::msg::Image_<std::allocator<void>>;

}  // namespace msg
}  // namespace sensor_msgs
