#pragma once
// These convert between slots and Cap'n Proto what every contract is made of. Generated converters
// are built on these overloads; any thread may use them.
//
//   toWire(slot, builder)     slot -> message; the builder has the slot's size already
//   fromWire(reader, slot)    message -> slot; Errc::TooLarge or Errc::Invalid if it is not what
//                             the header says
//
// What an older sender does not know reads as nothing: as zero, as empty, as the identity of a
// rotation, as a struct of which no member was sent. Where the header says otherwise, generated
// code calls fromDefault().

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/blob.h>
#include <suture/base/errors.h>
#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/base/time.h>
#include <suture/codec/eigen_wire.h>
#include <suture/codec/stamps.h>
#include <suture/rpc.capnp.h>
#include <suture/rt/queue/mailbox.h>

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>

namespace suture::codec {

/// Returns the first that is an error; 0 if none is.
inline Errc firstError(std::initializer_list<Errc> errors) {
  for (const Errc error : errors) {
    if (error != Errc{}) return error;
  }
  return Errc{};
}

/// Stores a member that was not sent: `value` is what its struct's constructor gives it.
template <class Value, class Slot>
Errc fromDefault(const Value& value, Slot& slot) {
  return store(value, slot) ? Errc{} : Errc::TooLarge;
}

/// Fills in what travels with every command.
inline void fill(wire::Sent::Builder sent, const rt::CommandRecord& record) {
  sent.setStamp(toNanoseconds(record.stamp));
  sent.setAnswer(record.call != 0);
}

// --- text

template <std::uint32_t N>
void toWire(const BoundedText<N>& slot, capnp::Text::Builder out) {
  std::copy_n(elements(slot), out.size(), out.begin());
}
template <std::uint32_t N>
Errc fromWire(capnp::Text::Reader in, BoundedText<N>& slot) {
  if (!resize(slot, in.size())) return Errc::TooLarge;
  std::copy_n(in.begin(), in.size(), elements(slot));
  return Errc{};
}

// --- lists: of numbers, of text, and of anything else with a converter for an element

template <class Element, std::uint32_t N, class List, class Convert>
void toWireList(const BoundedList<Element, N>& slot, List out, const Convert& convert) {
  for (std::uint32_t i = 0; i < out.size(); ++i) convert(slot.data[i], out, i);
}
template <class List, class Element, std::uint32_t N, class Convert>
Errc fromWireList(const List& in, BoundedList<Element, N>& slot, const Convert& convert) {
  if (!resize(slot, in.size())) return Errc::TooLarge;
  for (std::uint32_t i = 0; i < slot.size; ++i) {
    if (const Errc error = convert(in[i], slot.data[i]); error != Errc{}) return error;
  }
  return Errc{};
}

template <Number Element, std::uint32_t N, class List>
void toWire(const BoundedList<Element, N>& slot, List out) {
  for (std::uint32_t i = 0; i < out.size(); ++i) out.set(i, slot.data[i]);
}
template <class List, Number Element, std::uint32_t N>
Errc fromWire(const List& in, BoundedList<Element, N>& slot) {
  if (!resize(slot, in.size())) return Errc::TooLarge;
  for (std::uint32_t i = 0; i < slot.size; ++i) slot.data[i] = in[i];
  return Errc{};
}

// Bytes are Data, and so is what a header calls bulk(): its numbers, little-endian.
static_assert(std::endian::native == std::endian::little);

template <Number Element, std::uint32_t N>
void toWire(const BoundedList<Element, N>& slot, capnp::Data::Builder out) {
  std::copy_n(reinterpret_cast<const kj::byte*>(elements(slot)), out.size(), out.begin());
}
template <Number Element, std::uint32_t N>
Errc fromWire(capnp::Data::Reader in, BoundedList<Element, N>& slot) {
  if (in.size() % sizeof(Element) != 0) return Errc::Invalid;
  if (!resize(slot, in.size() / sizeof(Element))) return Errc::TooLarge;
  std::copy_n(in.begin(), in.size(), reinterpret_cast<kj::byte*>(elements(slot)));
  return Errc{};
}

template <std::uint32_t M, std::uint32_t N, class List>
void toWire(const BoundedList<BoundedText<M>, N>& slot, List out) {
  for (std::uint32_t i = 0; i < out.size(); ++i)
    toWire(slot.data[i], out.init(i, sizeOf(slot.data[i])));
}
template <class List, std::uint32_t M, std::uint32_t N>
Errc fromWire(const List& in, BoundedList<BoundedText<M>, N>& slot) {
  return fromWireList(in, slot, [](capnp::Text::Reader element, BoundedText<M>& text) {
    return fromWire(element, text);
  });
}

// --- arrays: lists of exactly their length, or empty ones where they were not sent. Eigen matrices
// without a named form are such arrays, column-major.

template <Number Element, std::size_t N, class List>
void toWire(const std::array<Element, N>& slot, List out) {
  for (std::uint32_t i = 0; i < N; ++i) out.set(i, slot[i]);
}
template <class List, Number Element, std::size_t N>
Errc fromWire(const List& in, std::array<Element, N>& slot) {
  if (in.size() == 0) return slot.fill(Element{}), Errc{};
  if (in.size() != N) return Errc::Invalid;
  for (std::uint32_t i = 0; i < N; ++i) slot[i] = in[i];
  return Errc{};
}

template <Number Element, std::size_t N>
void toWire(const std::array<Element, N>& slot, capnp::Data::Builder out) {
  std::memcpy(out.begin(), slot.data(), out.size());
}
template <Number Element, std::size_t N>
Errc fromWire(capnp::Data::Reader in, std::array<Element, N>& slot) {
  if (in.size() == 0) return slot.fill(Element{}), Errc{};
  if (in.size() != sizeof(slot)) return Errc::Invalid;
  std::memcpy(slot.data(), in.begin(), in.size());
  return Errc{};
}

template <class Element, std::size_t N, class List, class Convert>
void toWireList(const std::array<Element, N>& slot, List out, const Convert& convert) {
  for (std::uint32_t i = 0; i < N; ++i) convert(slot[i], out, i);
}
template <class List, class Element, std::size_t N, class Convert>
Errc fromWireList(const List& in, std::array<Element, N>& slot, const Convert& convert) {
  const bool sent = in.size() != 0;
  if (sent && in.size() != N) return Errc::Invalid;
  for (std::uint32_t i = 0; i < N; ++i) {
    const auto item = sent ? in[i] : decltype(in[i])();
    if (const Errc error = convert(item, slot[i]); error != Errc{}) return error;
  }
  return Errc{};
}

}  // namespace suture::codec

#include <suture/codec/composite_wire.h>
