#pragma once
// The processes of a measurement talk through this page. Nothing that a peer carries goes through
// it.

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <string>

namespace peers {

inline constexpr int kMostServers = 16;
inline constexpr int kMostPublished = 4096;

/// It counts what a server has received one way.
struct alignas(64) Received {
  std::atomic<std::uint64_t> count, disorder;
  std::atomic<std::int64_t> last;     ///< when the last one came, in ns
  std::atomic<double> lastTimestamp;  ///< the last message's own; `count` has it by then
};

struct ControlBlock {
  std::atomic<std::uint32_t> ready[kMostServers];
  std::atomic<pid_t> process[kMostServers];
  std::atomic<std::uint32_t> stop;
  /// Poses are stamped with when they were published: servers fill in `latency`.
  std::atomic<bool> stamped;
  Received received[kMostServers];
  std::int64_t latency[kMostServers][kMostPublished];  ///< ns, by the number of the pose

  /// Maps the block in `file`; the process that comes first makes it, with all bytes 0.
  static ControlBlock& open(const std::string& file);

  /// Returns once `servers` of them can be reached; else the process fails.
  void awaitReady(int servers);
  void tellToStop();
  void awaitStop();
  /// Servers end so whose threads do the work without this one.
  [[noreturn]] void exitWhenTold();
  /// Does the same in a thread of its own, for servers whose loops do not return.
  void exitWhenToldBeside();
};

}  // namespace peers
