#pragma once
// What both kinds of collector have in common.

#include <suture/base/time.h>
#include <suture/component/interface_info.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace suture {

/// What became of the rows or events of a time of collecting. Once the collector has caught up with
/// its provider, the three add up to what was produced.
struct CollectedCounts {
  std::uint64_t collected = 0;   ///< handed to the sink
  std::uint64_t passedOver = 0;  ///< left out on purpose: between two that the interval asks for
  std::uint64_t missed = 0;      ///< lost: overwritten or dropped before the collector came to them

  std::uint64_t produced() const { return collected + passedOver + missed; }
};

/// How much is collected.
struct CollectingInterval {
  unsigned every = 1;   ///< every n-th row or event
  Duration atLeast{0};  ///< between the stamps of two
};

/// Switches collecting on and off, chooses what is kept and counts.
class Collection {
 public:
  Collection(const CollectingInterval& interval, bool on);

  // --- any thread

  void switchTo(bool on) { wanted_.store(on, std::memory_order_release); }
  bool wanted() const { return wanted_.load(std::memory_order_acquire); }
  /// True between the first and the last thing that may be collected.
  bool active() const { return active_.load(std::memory_order_acquire); }
  CollectedCounts counts() const;

  // --- the collector's

  /// Begins, with all counts at zero, or ends.
  void setActive(bool active);
  /// True if what is stamped `stamp` is to be kept. Counts it.
  bool keep(Time stamp);
  void countMissed(std::uint64_t count);

 private:
  const CollectingInterval interval_;
  std::atomic<bool> wanted_, active_{false};
  std::atomic<std::uint64_t> collected_{0}, passedOver_{0}, missed_{0};
  unsigned untilNext_ = 0;
  Time last_{};
};

/// The numbers of the reads of `contract` that are called `names`, of all if there are no names.
/// Throws SetupError for a name that is not there.
std::vector<std::uint16_t> readsOf(const InterfaceInfo& contract,
                                   const std::vector<std::string>& names);
/// The same of its events.
std::vector<std::uint16_t> eventsOf(const InterfaceInfo& contract,
                                    const std::vector<std::string>& names);

}  // namespace suture
