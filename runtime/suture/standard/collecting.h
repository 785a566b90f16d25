#pragma once
// This tells collectors what to record, and says what they have recorded.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <cstdint>

namespace suture {

/// Says what became of the rows or events of a time of collecting. Once the collector has caught up
/// with its provider, the three add up to what was produced.
struct SUTURE_TYPE() CollectedCounts {
  std::uint64_t collected = 0;   ///< passed to the sink, and kept
  std::uint64_t passedOver = 0;  ///< left out on purpose, between two that the interval asks for
  std::uint64_t missed = 0;      ///< lost: overwritten before the collector came, or not kept

  std::uint64_t produced() const { return collected + passedOver + missed; }
};

/// Says how much is collected.
struct SUTURE_TYPE() CollectingInterval {
  SUTURE_FIELD(range(1, 4294967295)) std::uint32_t every = 1;  ///< every n-th row or event
  suture::Duration atLeast{0};                                 ///< between the stamps of two
};

/// Collecting is the provided interface of that name of every collector (record/state_collector.h,
/// record/event_collector.h). Its commands run in the collector's own thread; the task that is
/// observed has no part in them.
class SUTURE_INTERFACE() Collecting {
 public:
  virtual ~Collecting() = default;

  /// Begins to record what is produced from now on. Counts begin anew, unless it is collecting
  /// already.
  SUTURE_COMMAND() virtual void start_collecting() = 0;
  /// Stops recording: what is produced from now on is discarded without being counted.
  SUTURE_COMMAND() virtual void stop_collecting() = 0;
  /// Sets the interval from the next row or event on. Returns false, and changes nothing, for every
  /// 0th one or a negative time.
  SUTURE_COMMAND() virtual bool set_interval(const CollectingInterval& interval) = 0;
  SUTURE_COMMAND() virtual CollectingInterval interval() const = 0;
  SUTURE_COMMAND() virtual bool collecting() const = 0;
  /// Counts what the present time of collecting has written, or the last one.
  SUTURE_COMMAND() virtual CollectedCounts counts() const = 0;
};

}  // namespace suture
