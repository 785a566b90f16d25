// The shape of ROS 2's BoundedVector: it hides the vector that it is.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace rosidl_runtime_cpp {

template <typename Tp, std::size_t UpperBound, typename Alloc = std::allocator<Tp>>
class BoundedVector : protected std::vector<Tp, Alloc> {
  using Base = std::vector<Tp, Alloc>;

 public:
  using typename Base::const_iterator;
  using typename Base::iterator;
  using typename Base::size_type;
  using typename Base::value_type;

  BoundedVector() noexcept(std::is_nothrow_default_constructible<Alloc>::value) : Base() {}
  explicit BoundedVector(const Alloc& a) noexcept : Base(a) {}
  template <typename InputIterator>
  BoundedVector(InputIterator first, InputIterator last, const Alloc& a = Alloc())
      : Base(first, last, a) {
    if (size() > UpperBound) throw std::length_error("Exceeded upper bound");
  }

  using Base::begin;
  using Base::empty;
  using Base::end;
  using Base::operator[];
  using Base::size;

  size_type max_size() const noexcept { return UpperBound; }
  void push_back(const value_type& x) {
    if (size() >= UpperBound) throw std::length_error("Exceeded upper bound");
    Base::push_back(x);
  }

  bool operator==(const BoundedVector& other) const {
    return static_cast<const Base&>(*this) == static_cast<const Base&>(other);
  }
  bool operator!=(const BoundedVector& other) const { return !(*this == other); }
};

}  // namespace rosidl_runtime_cpp
