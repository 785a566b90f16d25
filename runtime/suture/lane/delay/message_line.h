#pragma once
// The messages of one direction, numbered where they are sent and checked where they arrive.

#include <suture/lane/delay/delay_line.h>
#include <suture/lane/fault/fault_injector.h>
#include <suture/lane/fault/sequence_check.h>

#include <cstddef>
#include <cstdint>

namespace suture {

/// What is put in meets what the plan says; what comes out is in order, each once. Beside messages
/// there are marks, which say how far the numbers had come some time ago, so that a loss is noticed
/// though nothing follows it. One thread.
class MessageLine {
 public:
  /// `largest`: of a message or mark. `stream`: tells this line's faults from those of others.
  MessageLine(std::size_t largest, std::size_t records, const FaultPlan& plan, std::uint64_t stream,
              DeliveryCounters& counters);

  // --- where they are sent

  /// False if claim() has no memory to give.
  bool hasRoom() const { return line_.hasRoom(2); }  // a message, and its duplicate
  /// Memory for a message that is due at `due`, unless faults say otherwise, to be filled before
  /// commit().
  std::byte* claim(Time due, std::size_t size);
  void commit();
  /// The number of the last message.
  std::uint64_t sent() const { return sent_; }
  /// The same for a mark: what has a number up to `sequence` and has not come before it is lost.
  std::byte* claimMark(Time due, std::size_t size, std::uint64_t sequence);

  // --- where they arrive

  /// The next message or mark if it is due at `now`, else nullptr; to be let go of by pop().
  const std::byte* due(Time now);
  bool isMark() const { return mark_; }
  std::size_t size() const;
  void pop() { line_.pop(); }
  /// The highest number that has arrived or been given up: none up to it will arrive any more.
  std::uint64_t reached() const { return check_.reached(); }

  /// When due() may have something.
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
  Fate fate_;                     // of what has been claimed
  std::byte* claimed_ = nullptr;  // with its header
  std::size_t claimedSize_ = 0;
  std::uint64_t sent_ = 0;
  Time stalledUntil_{};
  SequenceCheck check_;
  bool mark_ = false;  // what due() returned
};

}  // namespace suture
