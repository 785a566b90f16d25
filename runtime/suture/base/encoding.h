#pragma once
// These turn values of annotated types into bytes and back, for files and messages of one's own.
//
// Any thread; they allocate, so no control loop calls them. The bytes are a flat Cap'n Proto
// message with the struct of the type's lock as its root: `capnp decode` reads them with the lock,
// and what a compatible edit of the header allows on a connection it allows here, so that a file
// outlives the header that wrote it. Stamps of the steady clock stay as they are.

#include <suture/annotate.h>
#include <suture/base/errors.h>

#include <cstddef>
#include <span>
#include <vector>

namespace suture {

/// Returns the bytes, Errc::TooLarge if a list or text exceeds its capacity, or Errc::Invalid if a
/// number is outside what the header allows. suturec writes it for each SUTURE_TYPE.
template <class T>
Result<std::vector<std::byte>> encode([[maybe_unused]] const T& value) {
  return Generated<T>::template result<Result<std::vector<std::byte>>>();
}

/// Fills `value` and keeps the capacity of its lists. Returns an error, and leaves it as it was, if
/// the bytes are no such message (Errc::Invalid), or if they hold what the header does not allow:
/// as encode() does. Bytes of a hostile writer do no harm.
template <class T>
Result<> decode([[maybe_unused]] std::span<const std::byte> bytes, [[maybe_unused]] T& value) {
  return Generated<T>::template result<Result<>>();
}

}  // namespace suture
