#include "rt/stress/two_cores.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <suture/base/time.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace stress {
namespace {

std::vector<int> processors() {
  cpu_set_t set;
  sched_getaffinity(0, sizeof(set), &set);
  std::vector<int> result;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(cpu, &set)) result.push_back(cpu);
  }
  return result;
}

void pinTo(int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(cpu, &set);
  sched_setaffinity(0, sizeof(set), &set);
}

}  // namespace

Span::Span() {
  const char* seconds = std::getenv("SUTURE_STRESS_SECONDS");
  const double length = seconds == nullptr ? 0.1 : std::atof(seconds);
  end_ = suture::toNanoseconds(suture::now()) + static_cast<std::int64_t>(length * 1e9);
}

bool Span::over(std::uint64_t done) const {
  return done > 0 && suture::toNanoseconds(suture::now()) >= end_;
}

void runAcrossProcessors(const std::vector<std::function<void()>>& bodies) {
  const std::vector<int> places = processors();
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    threads.emplace_back([&, i] {
      pinTo(places[i % places.size()]);
      bodies[i]();
    });
  }
  for (std::thread& thread : threads) thread.join();
}

std::vector<std::function<void()>> producers(
    const Span& span, std::vector<std::uint64_t>& sent, std::atomic<std::uint64_t>& ended,
    const std::function<bool(std::uint64_t, std::uint64_t)>& send) {
  std::vector<std::function<void()>> bodies;
  for (std::uint64_t producer = 0; producer < kProducers; ++producer) {
    bodies.emplace_back([&, send, producer] {
      std::uint64_t serial = 0;
      while (!span.over(serial)) {
        if (send(producer, serial + 1)) {
          ++serial;
        } else {
          std::this_thread::yield();
        }
      }
      sent[producer] = serial;
      ++ended;
    });
  }
  return bodies;
}

std::uint64_t Faults::take(std::uint64_t serial) {
  ++seen;
  torn += serial == 0 ? 1 : 0;
  backwards += serial != 0 && serial <= last_ ? 1 : 0;
  if (serial != 0) last_ = serial;
  return serial;
}

void expectNone(const Faults& faults, const std::string& what) {
  EXPECT_GT(faults.seen, 0u) << what;
  EXPECT_EQ(faults.torn, 0u) << what << ", of " << faults.seen;
  EXPECT_EQ(faults.backwards, 0u) << what << ", of " << faults.seen;
}

}  // namespace stress
