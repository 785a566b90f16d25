#include <suture/component/channel/channel.h>
#include <suture/component/task/periodic_task.h>
#include <unistd.h>

#include <deque>
#include <thread>

#include "bench/figures/table.h"
#include "bench/local/sample_server.h"
#include "bench/network/bare_fan_out.h"
#include "bench/network/lanes.h"
#include "bench/network/message_bytes.h"
#include "bench/network/names.h"
#include "bench/network/processes/subscriber_process.h"
#include "bench/network/processor_time.h"
#include "bench/network/rows.h"
#include "bench/table2/processes/child_process.h"

namespace bench {
namespace {

using suture::SetupError;
using namespace std::chrono_literals;

constexpr std::size_t kInterfaces = 64, kProcesses = 16;

/// Emits a value in each millisecond.
class Sender final : public suture::PeriodicTask, public SampleServer {
 public:
  Sender() : PeriodicTask({.period = 1ms}) {}
  ~Sender() override { stop(); }

  void put(const robots::PoseSample&) override {}
  void bounce(const robots::PoseSample&) override {}
  robots::PoseSample value() const override { return {}; }
  void run() override {
    pose_.flags = measured.load(std::memory_order_relaxed) ? kMeasured : 0;
    pose_.stamp = suture::now();
    provided_.emit().echo(pose_);
  }

  std::atomic<bool> measured{false};

 private:
  suture::Provided<SampleServer> provided_{*this, "Samples", *this};
  robots::PoseSample pose_ = poseSample();
};

struct Shape {
  std::size_t processes, interfaces;  ///< each process has so many interfaces
};

void awaitConnections(const suture::Manager& manager, std::size_t wanted) {
  const suture::Time deadline = suture::now() + 1min;
  while (manager.channels().size() < wanted) {
    if (suture::now() > deadline) {
      throw SetupError(std::to_string(wanted) + " connections",
                       std::to_string(manager.channels().size()) + " after a minute",
                       "Run it again");
    }
    std::this_thread::sleep_for(10ms);
  }
  std::this_thread::sleep_for(200ms);  // the last one has been made known to the sender by then
}

double used(const std::deque<ChildProcess>& others) {
  double sum = processorTime(getpid());
  for (const ChildProcess& one : others) sum += processorTime(one.pid());
  return sum;
}

FanOut fanOut(const suture::Lane& lane, const Shape& shape, std::size_t rounds) {
  const Names names(Transport::Unix);
  Sender sender;
  suture::Manager manager("sender", names.address());
  manager.add("Sender", sender);
  manager.start();
  std::deque<ChildProcess> others;
  for (std::size_t i = 0; i < shape.processes; ++i) {
    others.emplace_back(subscriberProcessArguments({.process = "subscriber" + std::to_string(i),
                                                    .manager = names.address(),
                                                    .lane = lane,
                                                    .interfaces = shape.interfaces,
                                                    .samples = 2 * rounds * shape.interfaces}));
  }
  awaitConnections(manager, shape.processes * shape.interfaces);

  FanOut out;
  const suture::Time begin = suture::now();
  const double before = used(others);
  sender.measured = true;
  std::this_thread::sleep_until(begin + rounds * 1ms);
  sender.measured = false;
  const double seconds = std::chrono::duration<double>(suture::now() - begin).count();
  out.load = 100 * (used(others) - before) / seconds;
  std::this_thread::sleep_for(50ms);  // what is on its way still counts
  for (ChildProcess& one : others) {
    const auto ages = resultIn<std::int64_t>(one.finish());
    out.ages.insert(out.ages.end(), ages.begin(), ages.end());
  }
  manager.stop();
  return out;
}

/// Returns the 99th percentile, us.
double addRow(const char* title, const std::string& figure, const FanOut& result,
              std::size_t expected, Table& table, Report& report) {
  const Statistics ages = statisticsOf(inUnits(result.ages, kMicrosecond));
  report.add(figure, "us", ages);
  report.add(figure + ".load", "%", result.load);
  report.add(figure + ".arrived", "%",
             100 * static_cast<double>(ages.count) / static_cast<double>(expected));
  table.row(joined(joined({title, figure}, cellsOf(ages, 1)), {number(result.load, 1)}));
  return ages.p99;
}

}  // namespace

std::string networkFanOutRows(const NetworkOptions& options, Report& report) {
  const std::size_t rounds = options.fanOutRounds();
  const std::size_t expected = kInterfaces * rounds;
  Table table(2);
  table.row(joined(joined({"us, an event at 1 kHz to", "figure"}, statisticsTitles()), {"load %"}));
  table.line();
  const double floor =
      addRow("64 bare Unix sockets", "fan_out.raw", bareFanOut(kMessageBytes, kInterfaces, rounds),
             expected, table, report);
  for (const suture::Lane& lane : kLanes) {
    const std::string figure = "fan_out." + toString(lane);
    const double p99 = addRow("64 interfaces of a task", figure,
                              fanOut(lane, {1, kInterfaces}, rounds), expected, table, report);
    report.add(figure + ".ratio", "x", p99 / floor);
    addRow("16 processes", figure + ".processes", fanOut(lane, {kProcesses, 1}, rounds),
           kProcesses * rounds, table, report);
  }
  return table.toString();
}

}  // namespace bench
