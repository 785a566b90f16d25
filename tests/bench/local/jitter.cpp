#include <suture/component/task/periodic_task.h>
#include <suture/rt/histogram.h>
#include <suture/rt/scheduling.h>

#include <semaphore>
#include <thread>

#include "bench/figures/table.h"
#include "bench/local/rows.h"
#include "bench/sleep_until.h"

namespace bench {
namespace {

using namespace std::chrono_literals;
using suture::now;
using suture::Time;
using suture::rt::Histogram;

constexpr suture::Duration kPeriod = 1ms;

/// Does nothing, on time, and says when it has done so `cycles` times.
class IdleTask final : public suture::PeriodicTask {
 public:
  IdleTask(int cpu, std::size_t cycles)
      : PeriodicTask({.period = kPeriod, .scheduling = {.processor = cpu}}), cycles_(cycles) {}
  ~IdleTask() override { stop(); }

  void turn() {
    left_ = cycles_;
    start();
    finished_.acquire();
    stop();
  }
  void run() override {
    if (left_ == 0) return;
    --left_;
    if (left_ == 0) finished_.release();
  }

 private:
  std::size_t cycles_, left_ = 0;
  std::binary_semaphore finished_{0};
};

void bareTurn(int cpu, std::size_t cycles, Histogram& lateness) {
  std::thread([=, &lateness] {
    suture::rt::configureThisThread("bare-loop", {.processor = cpu});
    Time due = now();
    for (std::size_t i = 0; i < cycles; ++i) {
      while ((due += kPeriod) <= now()) {
      }
      sleepUntil(due);
      lateness.record(now() - due);
    }
  }).join();
}

double micros(suture::Duration duration) { return static_cast<double>(duration.count()) / 1e3; }

void addFigures(const std::string& name, const Histogram& lateness, Report& report) {
  report.add(name + ".p50", "us", micros(lateness.quantile(0.5)));
  report.add(name + ".p99", "us", micros(lateness.quantile(0.99)));
  report.add(name + ".max", "us", micros(lateness.max()));
}

std::string share(const Histogram& lateness, suture::Duration limit) {
  return number(100 * lateness.shareUpTo(limit), 2);
}

}  // namespace

std::string jitterRows(const LocalOptions& options, Report& report) {
  constexpr int kTurns = 20;
  const std::size_t cycles = options.quick ? 5 : 250;
  IdleTask task(options.cpu, cycles);
  Histogram bare;
  for (int turn = 0; turn < kTurns; ++turn) {
    task.turn();
    bareTurn(options.cpu, cycles, bare);
  }
  const Histogram& lateness = task.statistics().lateness;
  addFigures("jitter.task", lateness, report);
  addFigures("jitter.bare", bare, report);
  report.add("jitter.task.skipped", "periods", static_cast<double>(task.statistics().skipped));

  Table table(1);
  table.row({"1 kHz: cycles, %, at most so late", "periodic task", "clock_nanosleep"});
  table.line();
  for (const auto limit :
       {2us, 5us, 10us, 20us, 50us, 60us, 70us, 100us, 200us, 500us, 1000us, 5000us}) {
    table.row({std::to_string(limit.count()) + " us", share(lateness, limit), share(bare, limit)});
  }
  table.row({"worst, us", number(micros(lateness.max()), 1), number(micros(bare.max()), 1)});
  return table.toString();
}

}  // namespace bench
