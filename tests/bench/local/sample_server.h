#pragma once
// This is the provider in the measurements of `suture-bench local`.

#include <suture/component/task/event_task.h>

#include <atomic>

#include "bench/sample_loop.suture.h"

namespace bench {

/// Returns a pose in which no element is zero.
robots::PoseSample poseSample();

/// Sleeps until a command arrives.
class SampleTask final : public suture::EventTask, public SampleServer {
 public:
  explicit SampleTask(int cpu) : EventTask({.scheduling = {.processor = cpu}}) {}
  ~SampleTask() override { stop(); }

  void put(const robots::PoseSample& value) override;
  void bounce(const robots::PoseSample& value) override { provided_.emit().echo(value); }
  robots::PoseSample value() const override { return value_; }
  void run() override {}

  suture::ProvidedBase& provided() { return provided_; }
  /// Any thread: how many put() have been executed.
  std::uint64_t executed() const { return executed_.load(std::memory_order_acquire); }
  /// Any thread: returns how many of them came out of their order.
  std::uint64_t outOfOrder() const { return outOfOrder_.load(std::memory_order_relaxed); }

 private:
  suture::Provided<SampleServer> provided_{*this, "Samples", *this};
  robots::PoseSample value_ = poseSample();
  std::uint64_t last_ = 0;
  std::atomic<std::uint64_t> executed_{0}, outOfOrder_{0};
};

}  // namespace bench
