#pragma once
// This is the contract that a provider and its clients share.

#include <suture/annotate.h>

#include <cstdint>

namespace counting {

class SUTURE_INTERFACE() Counter {
 public:
  virtual ~Counter() = default;

  /// Adds to the count, in the provider's thread.
  SUTURE_COMMAND(queue(8)) virtual void add(std::int32_t amount) = 0;
  /// Returns the newest count; never waits for anyone.
  SUTURE_COMMAND() virtual std::int64_t value() const = 0;
  /// Reports that the count has passed a multiple of ten.
  SUTURE_EVENT() suture::EventOf<std::int64_t> ten_more;
};

}  // namespace counting
