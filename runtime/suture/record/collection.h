#pragma once
// This is what both kinds of collector have in common.

#include <suture/base/time.h>
#include <suture/component/contract/interface_info.h>
#include <suture/record/sink.h>
#include <suture/standard/collecting.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace suture {

/// Switches collecting on and off, chooses what is kept, and counts.
class Collection {
 public:
  /// Throws SetupError if the interval is not possible.
  Collection(const CollectingInterval& interval, bool on);

  // --- any thread

  void switchTo(bool on) { wanted_.store(on, std::memory_order_release); }
  bool wanted() const { return wanted_.load(std::memory_order_acquire); }
  /// Returns true between the first and the last thing that may be collected.
  bool active() const { return active_.load(std::memory_order_acquire); }
  CollectedCounts counts() const;

  // --- the collector's thread

  const CollectingInterval& interval() const { return interval_; }
  /// Returns false, and changes nothing, if the interval is not possible.
  bool setInterval(const CollectingInterval& interval);
  /// Begins collecting, with all counts at zero, or ends it.
  void setActive(bool active);
  /// Returns true if what has this stamp is to be kept. Counts it as collected or passed over.
  bool keep(Time stamp);
  void countMissed(std::uint64_t count);
  /// Settles what `sink` has taken. What the sink could not keep counts as missed and no longer as
  /// collected, and is added to `unreported`. Throws what the sink throws.
  void settle(Sink& sink, const CollectedInterface& from, std::uint64_t& unreported);

 private:
  void countNotKept(std::uint64_t count);

  CollectingInterval interval_;
  std::atomic<bool> wanted_, active_{false};
  std::atomic<std::uint64_t> collected_{0}, passedOver_{0}, missed_{0};
  unsigned untilNext_ = 0;
  Time last_{};
};

/// Returns the numbers of the reads of `contract` with these names, or of all if there are no
/// names. Throws SetupError for a name that it does not have.
std::vector<std::uint16_t> readsOf(const InterfaceInfo& contract,
                                   const std::vector<std::string>& names);
/// Does the same for its events.
std::vector<std::uint16_t> eventsOf(const InterfaceInfo& contract,
                                    const std::vector<std::string>& names);

}  // namespace suture
