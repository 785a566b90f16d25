#pragma once
// This recognises what a lane has lost, repeated or put out of order.

#include <suture/component/channel/counts/delivery_counters.h>

#include <cstdint>

namespace suture {

/// Receives messages that are numbered from 1 on. One thread uses it; any may read its counters.
///
/// Each number is accepted at most once, and never after a higher one, so what is accepted is in
/// order. What has been passed over will never be accepted, and may be settled as lost.
class SequenceCheck {
 public:
  explicit SequenceCheck(DeliveryCounters& counters) : counters_(counters) {}

  /// Returns true if message `sequence` must be taken; else it is dropped and counted.
  bool accepts(std::uint64_t sequence);
  /// Counts each message up to `sequence` that has not come as lost, because all were sent long
  /// ago.
  void passOver(std::uint64_t sequence);
  /// Returns the highest number that has been accepted or passed over.
  std::uint64_t reached() const { return reached_; }

 private:
  bool hasCome(std::uint64_t sequence) const;
  void advanceTo(std::uint64_t sequence, bool came);

  DeliveryCounters& counters_;
  std::uint64_t reached_ = 0;
  // Says which of the last 64 up to reached_ (bit 0) have come; tells a duplicate from a straggler.
  std::uint64_t recent_ = 0;
};

}  // namespace suture
