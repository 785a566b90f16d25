#pragma once
// Recognises what a lane has lost, repeated or put out of order.

#include <suture/component/channel/counts/delivery_counters.h>

#include <cstdint>

namespace suture {

/// The receiving end of messages that are numbered from 1 on. One thread; its counters, any.
///
/// A number is accepted once at most, and never after a higher one: what is accepted is in order.
/// So what has been passed over will never be accepted, and may be settled as lost.
class SequenceCheck {
 public:
  explicit SequenceCheck(DeliveryCounters& counters) : counters_(counters) {}

  /// True if message `sequence` is to be taken; else it is dropped and counted.
  bool accepts(std::uint64_t sequence);
  /// Everything up to `sequence` has been sent long ago: what of it has not come is lost.
  void passOver(std::uint64_t sequence);
  /// The highest number that has been accepted or passed over.
  std::uint64_t reached() const { return reached_; }

 private:
  bool hasCome(std::uint64_t sequence) const;
  void advanceTo(std::uint64_t sequence, bool came);

  DeliveryCounters& counters_;
  std::uint64_t reached_ = 0;
  // Which of the last 64 up to reached_ (bit 0) have come: tells a duplicate from a straggler.
  std::uint64_t recent_ = 0;
};

}  // namespace suture
