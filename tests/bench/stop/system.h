#pragma once
// This is a whole system with an emergency stop, which is pressed and cut off again and again.

#include <suture/manager/manager.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/network/names.h"
#include "bench/stop/parties.h"
#include "bench/table2/processes/child_process.h"

namespace bench {

/// Desk, pairs and endoscope are processes of their own, or, on Lane::Auto, all in this one. Arms
/// have power at the beginning of each press and cut.
class StopSystem {
 public:
  /// Throws SetupError.
  explicit StopSystem(const suture::Lane& lane);
  ~StopSystem();
  StopSystem(const StopSystem&) = delete;
  StopSystem& operator=(const StopSystem&) = delete;

  /// Returns the time from the call to the cycle in which the last drives stopped, ns.
  std::int64_t press();
  /// Returns that time from when the desk's process is stopped (SIGSTOP); it must be another one.
  std::int64_t cutOff();
  /// Returns that time from when the desk's process is killed (SIGKILL), after which nothing has
  /// power any more.
  std::int64_t killDesk();
  /// Ends it, and returns how many images both pairs have seen.
  std::uint64_t end();

 private:
  void addHere();
  void startElsewhere(const suture::Lane& lane);
  void connectWatchers(const suture::Lane& lane);
  void enableAll();
  std::int64_t untilStopped(suture::Time from);
  std::int64_t signalDesk(int signal);
  void release();
  template <class Condition>
  void await(const char* what, const Condition& condition) const;

  const bool isOneProcess_;
  std::optional<Names> names_;
  std::optional<StopDesk> desk_;
  std::optional<ArmPair> left_, right_;
  std::optional<StopVision> vision_;
  std::vector<std::unique_ptr<ChildProcess>> processes_;  // the desk's is the first
  bool deskIsKilled_ = false;
  StopPanel panel_;
  StopWatch watch_;
  std::optional<suture::Manager> manager_;
};

}  // namespace bench
