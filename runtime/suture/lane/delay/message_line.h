#pragma once
// These are the messages of one direction, numbered where they are sent and checked where they
// arrive.

#include <suture/lane/delay/delay_line.h>
#include <suture/lane/fault/fault_injector.h>
#include <suture/lane/fault/sequence_check.h>

#include <cstddef>
#include <cstdint>

namespace suture {

/// One thread. Messages that are put in meet the faults of the plan; they come out in order, each
/// once. Marks say how far the numbers had come some time ago, so that a loss is noticed even if
/// nothing follows it.
class MessageLine {
 public:
  /// `largest` is the size of a message or mark; `stream` separates this line's faults from those
  /// of others.
  MessageLine(std::size_t largest, std::size_t records, const FaultPlan& plan, std::uint64_t stream,
              DeliveryCounters& counters);

  // --- where they are sent

  /// Returns false if claim() has no memory to give.
  bool hasRoom() const { return line_.hasRoom(2); }  // a message, and its duplicate
  /// Returns memory for a message that is due at `due`, unless faults say otherwise, to be filled
  /// before commit().
  std::byte* claim(Time due, std::size_t size);
  void commit();
  /// Returns the number of the last message.
  std::uint64_t sent() const { return sent_; }
  /// Does the same for a mark: a message up to `sequence` that has not come before the mark is
  /// lost.
  std::byte* claimMark(Time due, std::size_t size, std::uint64_t sequence);

  // --- where they arrive

  /// Returns the next message or mark if it is due at `now`, else nullptr; release it with pop().
  const std::byte* due(Time now);
  bool isMark() const { return mark_; }
  std::size_t size() const;
  void pop() { line_.pop(); }
  /// Returns the highest number that has arrived or been given up: none up to it will arrive any
  /// more.
  std::uint64_t reached() const { return check_.reached(); }

  /// Returns when due() may have something.
  Time next() const;

 private:
  struct Header {
    std::uint64_t sequence;
    bool mark;
  };

  std::byte* claim(Time due, std::size_t size, const Header& header, const Fate& fate);
  void duplicate();

  DelayLine line_;
  FaultInjector faults_, markFaults_;
  Fate fate_;                     // what befalls the claimed message
  std::byte* claimed_ = nullptr;  // with its header
  std::size_t claimedSize_ = 0;
  std::uint64_t sent_ = 0;
  Time stalledUntil_{};
  SequenceCheck check_;
  bool mark_ = false;  // what due() returned
};

}  // namespace suture
