#pragma once
// A trace keeps what threads did under a stepped clock, in their order.

#include <suture/base/time.h>
#include <suture/base/virtual_time.h>

#include <cstdint>
#include <string>
#include <vector>

namespace suture {

/// A TraceEntry is one thing that one thread did. It holds nothing that differs from one run to the
/// next: no addresses, no process ids.
struct TraceEntry {
  Duration time{};  ///< since the clock was made
  std::string thread;
  VirtualTime::Kind kind{};
  std::string what;  ///< "Slave.servo_cp": the interface as its owner calls it, and its member
  std::uint64_t number = 0;  ///< the sequence number of a command, the value of a status

  bool operator==(const TraceEntry&) const = default;
};

using Trace = std::vector<TraceEntry>;

/// Returns a line for each entry, for people and for comparison.
std::string toString(const Trace& trace);

}  // namespace suture
