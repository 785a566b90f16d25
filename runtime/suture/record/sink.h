#pragma once
// Where collectors put what they collect.

#include <suture/base/time.h>
#include <suture/component/contract/interface_info.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace suture {

/// The interface that a collector observes. Lives as long as the collector.
struct CollectedInterface {
  std::string collector;  ///< the collector's name
  const InterfaceInfo& contract;
};

/// One value of a row.
struct CollectedValue {
  std::uint16_t read;     ///< the number of the read command in its contract
  const std::byte* slot;  ///< nullptr: not produced in this row, too large, or invalid
};

/// A file, a network, a test. May be slow: what is lost by that is counted. Called by the thread of
/// each collector that uses it; one that serves several must expect calls at the same time.
class Sink {
 public:
  virtual ~Sink() = default;

  /// A row of state. `number`: counts the rows of its table, from 1. The slots live until this
  /// returns.
  virtual void row(const CollectedInterface& from, std::uint64_t number, Time stamp,
                   std::span<const CollectedValue> values) = 0;
  /// An event; its slot lives until this returns, and is of no use if the event carries nothing.
  virtual void event(const CollectedInterface& from, std::uint16_t event, Time stamp,
                     const std::byte* slot) = 0;
  /// So many rows or events have been lost here, since they came faster than they were taken.
  virtual void missed(const CollectedInterface& from, std::uint64_t count) = 0;
  /// The collector has nothing more at present: what waits for more may go on its way.
  virtual void settle() {}
};

}  // namespace suture
