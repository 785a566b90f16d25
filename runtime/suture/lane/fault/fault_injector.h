#pragma once
// This decides which faults each message of one direction meets.

#include <suture/lane/fault/fault_plan.h>

#include <cstdint>
#include <random>

namespace suture {

/// Says which faults one message meets.
struct Fate {
  bool lost = false;
  bool overtakable = false;  ///< later messages do not wait while this one is late
  bool duplicated = false;
  Duration later{0};           ///< it takes this much longer
  Duration duplicateLater{0};  ///< the duplicate arrives so much later than the message
  Duration stall{0};           ///< nothing arrives for this long from now on
};

/// One thread. The n-th call of next() depends only on the plan's seed, `stream` and n.
class FaultInjector {
 public:
  FaultInjector(const FaultPlan& plan, std::uint64_t stream);

  Fate next();

 private:
  double draw();
  bool strikes(double chance) { return draw() < chance; }
  bool isLost();
  int times(double draw) const;
  void count(std::atomic<std::uint64_t> FaultCounts::*which);

  const FaultPlan plan_;
  std::mt19937_64 random_;
  unsigned burstLeft_ = 0;
};

}  // namespace suture
