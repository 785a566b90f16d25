#pragma once
// These are slots of Eigen vectors and matrices whose size is known only at run time. See slots.h,
// which includes this.

#include <suture/base/slots/slots.h>

#include <utility>

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
  if (!resize(slot, static_cast<std::size_t>(value.size()))) return false;
  std::copy_n(value.data(), value.size(), elements(slot));
  return true;
}
template <Number S, int Rows, int Columns, int O, int MaxRows, int MaxColumns, std::uint32_t N>
requires isOpenVector<Eigen::Matrix<S, Rows, Columns>>
void load(const BoundedList<S, N>& slot,
          Eigen::Matrix<S, Rows, Columns, O, MaxRows, MaxColumns>& value) {
  const std::uint32_t size = sizeOf(slot);
  value.resize(Eigen::Index{size});
  std::copy_n(elements(slot), size, value.data());
}

/// Stores a matrix with a fixed number of rows as a list of columns.
template <Number S, int Rows, int O, int MaxColumns, std::size_t R, std::uint32_t N>
bool store(const Eigen::Matrix<S, Rows, Eigen::Dynamic, O, Rows, MaxColumns>& value,
           BoundedList<std::array<S, R>, N>& slot) {
  static_assert(R == std::size_t{Rows});
  if (!resize(slot, static_cast<std::size_t>(value.cols()))) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(value.cols()); ++i) {
    std::copy_n(value.data() + R * i, R, slot.data[i].data());
  }
  return true;
}
template <Number S, int Rows, int O, int MaxColumns, std::size_t R, std::uint32_t N>
void load(const BoundedList<std::array<S, R>, N>& slot,
          Eigen::Matrix<S, Rows, Eigen::Dynamic, O, Rows, MaxColumns>& value) {
  static_assert(R == std::size_t{Rows});
  const std::uint32_t size = sizeOf(slot);
  value.resize(Rows, Eigen::Index{size});
  for (std::uint32_t i = 0; i < size; ++i) {
    std::copy_n(slot.data[i].data(), R, value.data() + R * i);
  }
}

template <std::uint32_t R, std::uint32_t C>
bool withinBounds(std::uint32_t rows, std::uint32_t columns) {
  return (R == kUnbounded || rows <= R) && (C == kUnbounded || columns <= C);
}

/// Makes room for that many coefficients, with unspecified values. Returns false if they are too
/// many.
template <class S, std::uint32_t R, std::uint32_t C>
bool resize(BoundedMatrix<S, R, C>& slot, std::uint32_t rows, std::uint32_t columns) {
  if (!withinBounds<R, C>(rows, columns)) return false;
  if constexpr (R == kUnbounded || C == kUnbounded) {
    if (!resize(slot.data, std::size_t{rows} * columns)) return false;
  }
  slot.rows = rows;
  slot.columns = columns;
  return true;
}

/// Returns rows and columns, at most the capacity, because the bytes of a slot may be wrong.
template <class S, std::uint32_t R, std::uint32_t C>
std::pair<std::uint32_t, std::uint32_t> extentOf(const BoundedMatrix<S, R, C>& slot) {
  if constexpr (R == kUnbounded || C == kUnbounded) {
    return {slot.rows, slot.columns};  // this kind is never copied as bytes, so its numbers are
                                       // right
  } else {
    return {std::min(slot.rows, R), std::min(slot.columns, C)};
  }
}

/// Returns where the coefficients begin.
template <class S, std::uint32_t R, std::uint32_t C>
S* elements(BoundedMatrix<S, R, C>& slot) {
  if constexpr (R == kUnbounded || C == kUnbounded) {
    return elements(slot.data);
  } else {
    return slot.data;
  }
}
template <class S, std::uint32_t R, std::uint32_t C>
const S* elements(const BoundedMatrix<S, R, C>& slot) {
  return elements(const_cast<BoundedMatrix<S, R, C>&>(slot));
}

template <Number S, int O, int MaxRows, int MaxColumns, std::uint32_t R, std::uint32_t C>
bool store(const Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, O, MaxRows, MaxColumns>& value,
           BoundedMatrix<S, R, C>& slot) {
  if (!resize(slot, static_cast<std::uint32_t>(value.rows()),
              static_cast<std::uint32_t>(value.cols()))) {
    return false;
  }
  std::copy_n(value.data(), value.size(), elements(slot));
  return true;
}
template <Number S, int O, int MaxRows, int MaxColumns, std::uint32_t R, std::uint32_t C>
void load(const BoundedMatrix<S, R, C>& slot,
          Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, O, MaxRows, MaxColumns>& value) {
  const auto [rows, columns] = extentOf(slot);
  value.resize(Eigen::Index{rows}, Eigen::Index{columns});
  std::copy_n(elements(slot), value.size(), value.data());
}

}  // namespace suture
