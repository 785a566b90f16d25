#pragma once
// Collectors put what they collect into a sink.

#include <suture/base/errors.h>
#include <suture/base/time.h>
#include <suture/component/contract/interface_info.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace suture {

/// A CollectedInterface is what a collector observes. It lives as long as the collector.
struct CollectedInterface {
  std::string collector;  ///< the collector's name
  const InterfaceInfo& contract;
};

/// A CollectedValue is one value of a row.
struct CollectedValue {
  std::uint16_t read;     ///< the number of the read command in its contract
  const std::byte* slot;  ///< nullptr: not produced in this row, too large, or invalid
};

/// A sink throws this if it had taken rows or events of a collector, and could not keep them. The
/// collector then counts them as missed, and tells the sink so if it is restarted.
class NotKept : public SetupError {
 public:
  /// `missed` were in lines that told of them.
  NotKept(const SetupError& why, std::uint64_t collected, std::uint64_t missed)
      : SetupError(why), collected_(collected), missed_(missed) {}

  std::uint64_t collected() const { return collected_; }
  std::uint64_t missed() const { return missed_; }

 private:
  const std::uint64_t collected_, missed_;
};

/// The thread of each collector that uses it calls it; one that serves several must expect calls at
/// the same time. It may be a file, a network or a test, and may be slow: what is lost because of
/// that is counted.
class Sink {
 public:
  virtual ~Sink() = default;

  /// The thread that configures a collector, before the collector's own begins: takes what this
  /// writes to. What it throws refuses the start; nothing that was there before may be lost until
  /// the first settle().
  virtual void begin() {}

  /// Takes a row of state. `number` counts the rows of its table, from 1. The slots live until this
  /// returns.
  virtual void row(const CollectedInterface& from, std::uint64_t number, Time stamp,
                   std::span<const CollectedValue> values) = 0;
  /// Takes an event. Its slot lives until this returns, and has no meaning if the event carries
  /// nothing.
  virtual void event(const CollectedInterface& from, std::uint16_t event, Time stamp,
                     const std::byte* slot) = 0;
  /// The collector tells by this that `count` rows or events have been lost at this place, because
  /// they came faster than they were taken.
  virtual void missed(const CollectedInterface& from, std::uint64_t count) = 0;
  /// The collector calls this when it starts, and then whenever it has nothing more at present, so
  /// what waits for more may be written or sent. Throws NotKept if something of it is lost.
  virtual void settle(const CollectedInterface& /*from*/) {}
};

}  // namespace suture
