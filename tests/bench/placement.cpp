#include "bench/placement.h"

#include <suture/rt/scheduling.h>

namespace bench {
namespace {

std::optional<int> lastAllowed(int except) {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  sched_getaffinity(0, sizeof(allowed), &allowed);
  std::optional<int> last;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (cpu != except && CPU_ISSET(cpu, &allowed)) last = cpu;
  }
  return last;
}

}  // namespace

Pinned::Pinned(std::optional<int> cpu) {
  sched_getaffinity(0, sizeof(before_), &before_);
  if (cpu) suture::rt::configureThisThread("suture-bench", {.processor = cpu});
}

Pinned::~Pinned() { sched_setaffinity(0, sizeof(before_), &before_); }

Unpreempted::Unpreempted() : policy_(sched_getscheduler(0)) {
  sched_getparam(0, &parameters_);
  const sched_param none{};
  sched_setscheduler(0, SCHED_BATCH, &none);
}

Unpreempted::~Unpreempted() { sched_setscheduler(0, policy_, &parameters_); }

int preferredCpu() { return lastAllowed(-1).value_or(0); }

int cpuBeside(int cpu) { return lastAllowed(cpu).value_or(cpu); }

std::string whyNotFifo(int priority) {
  const auto refusals =
      suture::rt::grantedOf("the bench", {suture::rt::Policy::Fifo, priority}).refusals;
  return refusals.empty() ? "" : refusals.front();
}

suture::rt::Scheduling urgent(int priority, std::optional<int> processor) {
  if (!whyNotFifo(priority).empty()) return {.processor = processor};
  return {suture::rt::Policy::Fifo, priority, processor};
}

}  // namespace bench
