#pragma once
// This is how the answer of a call lies in its ring.

#include <suture/base/errors.h>
#include <suture/base/time.h>

#include <cstddef>
#include <cstdint>

namespace suture {

/// Precedes the result of every answered call.
struct ReplyRecord {
  Time stamp;             ///< when the result was produced, on this process's clock
  std::uint32_t call;     ///< the number of the call
  Errc error;             ///< 0: success, and the result follows
  bool shared;            ///< the result is a counted pointer, see base/slots/shared_slot.h
  std::uint16_t command;  ///< the command of the result, unless there is an error

  std::byte* result() { return reinterpret_cast<std::byte*>(this + 1); }
  const std::byte* result() const { return reinterpret_cast<const std::byte*>(this + 1); }
};

/// Tells in which form the result of a call lies in its record.
struct ResultForm {
  std::uint32_t size = 0;
  bool shared = false;
  std::uint16_t command = 0;
};

}  // namespace suture
