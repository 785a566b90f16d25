#pragma once
// This wakes a sleeping thread: it costs one word and one system call, and no call if it is awake.

#include <suture/base/memory_block.h>
#include <suture/base/time.h>
#include <suture/base/virtual_time.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace suture::rt {

/// Says what a doorbell is rung for.
enum class RungFor : std::uint32_t {
  Nothing = 0,
  /// The answer to a call, or an event. The thread that rings has put it where the sleeper finds
  /// it, so the sleeper may have taken it before the ring comes.
  Arrival = 1,
  /// Anything else, or both.
  Work = 2,
};

/// Belongs to one sleeper, its owner; any thread may ring it. A ring of this process is never lost:
/// if it comes before the sleeper goes to sleep, the next wait returns at once. Lock-free; never
/// allocates.
class Doorbell {
 public:
  /// `eventDescriptor` is an eventfd to write instead of waking a futex, for a sleeper that waits
  /// in epoll.
  explicit Doorbell(int eventDescriptor = -1);
  enum class Sleeper : std::uint8_t { Here, Elsewhere };
  /// Makes a doorbell in memory that other processes map. With Sleeper::Here the sleeper is in this
  /// process, and share() returns what others need to ring it; with Sleeper::Elsewhere it is in
  /// another process, and this one only rings it. Other processes may write anything there: that
  /// can wake the sleeper for nothing, or make it sleep for kLookAgain, but no more.
  Doorbell(std::shared_ptr<MemoryBlock> memory, Sleeper sleeper);
  Doorbell(const Doorbell&) = delete;
  Doorbell& operator=(const Doorbell&) = delete;

  /// Any thread. Makes at most one system call, and none while the owner is awake.
  void ring(RungFor what = RungFor::Work);

  /// Any thread, before it rings at the end of its cycle: a stepped clock has to know that it will.
  void tellDue() const {
    if (VirtualTime* const time = virtualTime(); time != nullptr) time->owe(sleeper().place);
  }

  /// Limits the sleep of the owner while another process may ring, because such a ring can be lost.
  static constexpr Duration kLookAgain = std::chrono::seconds(1);

  /// The owner only. Sleeps until it is rung, until `deadline`, or until it must look again
  /// (kLookAgain). Returns what it has been rung for since it last asked.
  RungFor waitUntil(Time deadline);
  /// The owner only. Sleeps until it is rung, for a ring that is certain to come.
  void wait();

  /// The owner only, before it sleeps in epoll. Returns true if it may go to sleep: the next ring
  /// then writes the eventfd. Returns false if there is a ring to take.
  bool prepareToSleep();
  /// The owner only, after it has slept in epoll. From here on a ring costs no system call.
  void endSleep();
  /// The owner only, in place of epoll while time is virtual. Sleeps until it is rung, until
  /// `sockets` have something, or until `deadline`.
  void sleepAt(VirtualTime::Sockets& sockets, Time deadline);
  /// The owner only, if it sleeps in epoll. Returns what it has been rung for since it last asked.
  RungFor takeRing();

  /// Any thread. Returns the memory that another process needs to ring it; call this before that
  /// process does. Until then the kernel is told that no other process waits or rings there, which
  /// costs half as much.
  const std::shared_ptr<MemoryBlock>& share();

 private:
  static constexpr std::uint32_t kAwake = 0, kAsleep = 4;  // beside the bits of RungFor

  using Word = std::atomic<std::uint32_t>;

  void wake(int flavour);
  void writeEvent();
  int flavour() const;
  VirtualTime::Sleeper sleeper() const;

  const std::shared_ptr<MemoryBlock> memory_;
  std::atomic<bool> shared_{false};
  Word own_{kAwake};
  Word& word_;
  int eventDescriptor_ = -1;
};

}  // namespace suture::rt
