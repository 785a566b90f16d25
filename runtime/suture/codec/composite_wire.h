#pragma once
// These convert between slots and Cap'n Proto for sets, maps, optionals, tuples, variants and
// matrices of any size. See wire.h, which includes this.

#include <suture/codec/wire.h>

namespace suture::codec {

// --- sets and maps: lists whose elements, or their keys, are all different

template <class List, class Element, std::uint32_t N, class Convert>
Errc fromWireDistinct(const List& in, BoundedList<Element, N>& slot, const Convert& convert) {
  if (const Errc error = fromWireList(in, slot, convert); error != Errc{}) return error;
  return arrange(slot, in.size()) ? Errc{} : Errc::Invalid;
}

// --- lists of fixed vectors: all coefficients in one flat list

template <Number S, std::size_t R, std::uint32_t N, class List>
void toWireFlat(const BoundedList<std::array<S, R>, N>& slot, List out) {
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < out.size() / R; ++i) {
    for (const S coefficient : slot.data[i]) out.set(next++, coefficient);
  }
}
template <class List, Number S, std::size_t R, std::uint32_t N>
Errc fromWireFlat(const List& in, BoundedList<std::array<S, R>, N>& slot) {
  if (in.size() % R != 0) return Errc::Invalid;
  if (!resize(slot, in.size() / R)) return Errc::TooLarge;
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < slot.size; ++i) {
    for (S& coefficient : slot.data[i]) coefficient = in[next++];
  }
  return Errc{};
}

// --- matrices of any size

template <Number S, std::uint32_t R, std::uint32_t C, class Builder>
void toWire(const BoundedMatrix<S, R, C>& slot, Builder out) {
  const auto [rows, columns] = extentOf(slot);
  out.setRows(rows);
  out.setColumns(columns);
  const std::uint32_t count = rows * columns;
  if constexpr (std::is_same_v<decltype(out.initData(0)), capnp::Data::Builder>) {  // bulk()
    auto data = out.initData(count * sizeof(S));
    std::copy_n(reinterpret_cast<const kj::byte*>(elements(slot)), data.size(), data.begin());
  } else {
    auto data = out.initData(count);
    for (std::uint32_t i = 0; i < count; ++i) data.set(i, elements(slot)[i]);
  }
}
template <class Reader, Number S, std::uint32_t R, std::uint32_t C>
Errc fromWire(Reader in, BoundedMatrix<S, R, C>& slot) {
  if (!withinBounds<R, C>(in.getRows(), in.getColumns())) return Errc::TooLarge;
  const auto data = in.getData();
  const std::uint64_t count = std::uint64_t{in.getRows()} * in.getColumns();
  constexpr bool bulk = std::is_same_v<decltype(in.getData()), capnp::Data::Reader>;
  if (data.size() != count * (bulk ? sizeof(S) : 1)) return Errc::Invalid;
  if (!resize(slot, in.getRows(), in.getColumns())) return Errc::TooLarge;
  if constexpr (bulk) {
    std::copy_n(data.begin(), data.size(), reinterpret_cast<kj::byte*>(elements(slot)));
  } else {
    for (std::uint32_t i = 0; i < data.size(); ++i) elements(slot)[i] = data[i];
  }
  return Errc{};
}

}  // namespace suture::codec
