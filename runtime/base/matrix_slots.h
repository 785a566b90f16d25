#pragma once
// Slots of Eigen vectors and matrices whose size is known at run time only. See slots.h, which
// includes this.

#include <suture/base/slots.h>

namespace suture {

template <class Matrix>
inline constexpr bool isOpenVector = (Matrix::RowsAtCompileTime == Eigen::Dynamic &&
                                      Matrix::ColsAtCompileTime == 1) ||
                                     (Matrix::RowsAtCompileTime == 1 &&
                                      Matrix::ColsAtCompileTime == Eigen::Dynamic);

template <Number S, int Rows, int Columns, int O, int MaxRows, int MaxColumns, std::uint32_t N>
requires isOpenVector<Eigen::Matrix<S, Rows, Columns>>
bool store(const Eigen::Matrix<S, Rows, Columns, O, MaxRows, MaxColumns>& value,
           BoundedList<S, N>& slot) {
  if (value.size() > Eigen::Index{N}) return false;
  slot.size = static_cast<std::uint32_t>(value.size());
  std::copy_n(value.data(), slot.size, slot.data);
  return true;
}
template <Number S, int Rows, int Columns, int O, int MaxRows, int MaxColumns, std::uint32_t N>
requires isOpenVector<Eigen::Matrix<S, Rows, Columns>>
void load(const BoundedList<S, N>& slot,
          Eigen::Matrix<S, Rows, Columns, O, MaxRows, MaxColumns>& value) {
  const std::uint32_t size = std::min(slot.size, N);
  value.resize(Eigen::Index{size});
  std::copy_n(slot.data, size, value.data());
}

/// Of so many rows: a list of columns.
template <Number S, int Rows, int O, int MaxColumns, std::size_t R, std::uint32_t N>
bool store(const Eigen::Matrix<S, Rows, Eigen::Dynamic, O, Rows, MaxColumns>& value,
           BoundedList<std::array<S, R>, N>& slot) {
  static_assert(R == std::size_t{Rows});
  if (value.cols() > Eigen::Index{N}) return false;
  slot.size = static_cast<std::uint32_t>(value.cols());
  for (std::uint32_t i = 0; i < slot.size; ++i) {
    std::copy_n(value.data() + R * i, R, slot.data[i].data());
  }
  return true;
}
template <Number S, int Rows, int O, int MaxColumns, std::size_t R, std::uint32_t N>
void load(const BoundedList<std::array<S, R>, N>& slot,
          Eigen::Matrix<S, Rows, Eigen::Dynamic, O, Rows, MaxColumns>& value) {
  static_assert(R == std::size_t{Rows});
  const std::uint32_t size = std::min(slot.size, N);
  value.resize(Rows, Eigen::Index{size});
  for (std::uint32_t i = 0; i < size; ++i) {
    std::copy_n(slot.data[i].data(), R, value.data() + R * i);
  }
}

template <Number S, int O, int MaxRows, int MaxColumns, std::uint32_t R, std::uint32_t C>
bool store(const Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, O, MaxRows, MaxColumns>& value,
           BoundedMatrix<S, R, C>& slot) {
  if (value.rows() > Eigen::Index{R} || value.cols() > Eigen::Index{C}) return false;
  slot.rows = static_cast<std::uint32_t>(value.rows());
  slot.columns = static_cast<std::uint32_t>(value.cols());
  std::copy_n(value.data(), value.size(), slot.data);
  return true;
}
template <Number S, int O, int MaxRows, int MaxColumns, std::uint32_t R, std::uint32_t C>
void load(const BoundedMatrix<S, R, C>& slot,
          Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, O, MaxRows, MaxColumns>& value) {
  value.resize(Eigen::Index{std::min(slot.rows, R)}, Eigen::Index{std::min(slot.columns, C)});
  std::copy_n(slot.data, value.size(), value.data());
}

}  // namespace suture
