#pragma once
// Decides what befalls each message of one direction.

#include <suture/lane/fault/fault_plan.h>

#include <cstdint>
#include <random>

namespace suture {

/// What befalls one message.
struct Fate {
  bool lost = false;
  bool overtakable = false;  ///< `later` holds for it alone, not for what follows
  bool duplicated = false;
  Duration later{0};           ///< it takes so much longer
  Duration duplicateLater{0};  ///< its duplicate, than itself
  Duration stall{0};           ///< from now on nothing arrives for so long
};

/// One thread. The n-th call of next() depends on the plan's seed, `stream` and n only.
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
