#pragma once
// How a sleeping thread is woken: one word, one system call, and none if it is awake.

#include <suture/base/memory_block.h>
#include <suture/base/time.h>
#include <suture/base/virtual_time.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace suture::rt {

/// What a doorbell is rung for.
enum class RungFor : std::uint32_t {
  Nothing = 0,
  /// The answer to a call, or an event. Whoever rings has put it where the sleeper finds it; the
  /// ring may come when it has been taken.
  Arrival = 1,
  /// Anything else, or both.
  Work = 2,
};

/// A doorbell belongs to one sleeper; any thread may ring. A ring of this process is never lost:
/// ringing before the sleeper goes to sleep makes its next wait return at once. Lock-free, no
/// allocation.
class Doorbell {
 public:
  /// `eventDescriptor`: an eventfd to write instead of waking a futex, for a sleeper that sits in
  /// epoll.
  explicit Doorbell(int eventDescriptor = -1);
  enum class Sleeper : std::uint8_t { Here, Elsewhere };
  /// Lies in memory that other processes map: its sleeper's own, which share() hands to them, or
  /// that of one of theirs, in order to ring it. What they write there can wake it for nothing, or
  /// make it sleep for kLookAgain.
  Doorbell(std::shared_ptr<MemoryBlock> memory, Sleeper sleeper);
  Doorbell(const Doorbell&) = delete;
  Doorbell& operator=(const Doorbell&) = delete;

  /// Any thread. At most one system call, none while the owner is awake.
  void ring(RungFor what = RungFor::Work);

  /// How long the owner sleeps at most while another process may ring, which could lose a ring.
  static constexpr Duration kLookAgain = std::chrono::seconds(1);

  /// The owner only: sleeps until rung or until `deadline`, or until it is to look again. Returns
  /// what it was rung for since it last asked.
  RungFor waitUntil(Time deadline);
  /// The owner only: sleeps until rung, which whoever rings must be certain to do.
  void wait();

  /// For an owner that sleeps in epoll: true if it may go to sleep, false if there is a ring to
  /// take. After true, the next ring writes the eventfd.
  bool prepareToSleep();
  /// For an owner that sleeps in epoll, when it is back: a ring costs no system call from here on.
  void endSleep();
  /// For an owner that sleeps in epoll, instead of that while time is virtual: sleeps until rung,
  /// until `sockets` have something or until `deadline`.
  void sleepAt(VirtualTime::Sockets& sockets, Time deadline);
  /// For an owner that sleeps in epoll: what it has been rung for since it last asked.
  RungFor takeRing();

  /// Any thread: returns what another process needs to ring it, before that does. Until then the
  /// kernel is told that no other process waits there or rings, which costs half as much.
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
