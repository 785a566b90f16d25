#pragma once
// This is one direction of a link: the packets that are under way.

#include <suture/base/time.h>
#include <suture/lane/fault/fault_injector.h>

#include <atomic>
#include <cstdint>
#include <deque>
#include <vector>

namespace experiment {

/// Says what packets meet on a link, in each of its directions.
struct PacketFate {
  suture::Duration way{0};     ///< how long each of them takes
  suture::Duration jitter{0};  ///< any of them may take so much longer; later ones wait behind it
  double loss = 0;             ///< chance of each to be lost, of 0 to 1
  std::uint64_t seed = 1;
};

/// Any thread may read. Counts how many packets have come, and how many of those were lost.
struct PacketCounts {
  std::atomic<std::uint64_t> taken{0}, lost{0}, delivered{0};
};

/// Belongs to one thread, but for its counts.
class PacketLine {
 public:
  /// `from` and `to` are where packets are read and written. Equal seeds and streams lose the same
  /// packets, counted from the first.
  PacketLine(int from, int to, const PacketFate& fate, std::uint32_t stream);

  int from() const { return from_; }
  /// Reads what has come.
  void take();
  /// Writes what is due.
  void deliver(suture::Time now);
  /// Returns when the next packet is due; suture::Time::max() if there is none.
  suture::Time next() const;
  const PacketCounts& counts() const { return counts_; }

 private:
  struct Packet {
    suture::Time due;
    std::vector<std::uint8_t> bytes;
  };

  const int from_, to_;
  const suture::Duration way_;
  suture::FaultInjector faults_;
  std::deque<Packet> underWay_;
  suture::Time lastDue_{};
  PacketCounts counts_;
};

}  // namespace experiment
