#include <suture/component/task/event_task.h>

#include <atomic>
#include <chrono>
#include <future>
#include <vector>

#include "bench/figures/table.h"
#include "bench/image_viewer.h"
#include "bench/local/sample_server.h"
#include "bench/network/lanes.h"
#include "bench/network/names.h"
#include "bench/network/processes/image_process.h"
#include "bench/network/rows.h"
#include "bench/placement.h"
#include "bench/table2/processes/child_process.h"

namespace bench {
namespace {

using Ages = std::vector<std::int64_t>;
using namespace std::chrono_literals;

/// Notes how old the goals are that it executes, while a measurement asks for it.
class AgedServer final : public suture::EventTask, public SampleServer {
 public:
  AgedServer() : EventTask({.scheduling = urgent(70)}) {}
  ~AgedServer() override { stop(); }

  void put(const robots::PoseSample& value) override {
    if (!measuring_.load(std::memory_order_acquire)) return;
    ages_.push_back((suture::now() - value.stamp).count());
    if (ages_.size() < ages_.capacity()) return;
    measuring_.store(false, std::memory_order_relaxed);
    full_.set_value();
  }
  void bounce(const robots::PoseSample&) override {}
  robots::PoseSample value() const override { return {}; }
  void run() override {}

  /// The thread of the measurement calls this. Returns the ages of the next `count` goals, ns.
  /// Throws SetupError.
  Ages measure(std::size_t count) {
    ages_.clear();
    ages_.reserve(count);
    full_ = {};
    auto full = full_.get_future();
    measuring_.store(true, std::memory_order_release);
    if (full.wait_for(count * 10ms + 30s) != std::future_status::ready) {
      throw suture::SetupError(std::to_string(count) + " goals, one each millisecond",
                               "fewer arrived in ten times that time", "Run it again");
    }
    return ages_;
  }

 private:
  suture::Provided<SampleServer> provided_{*this, "Samples", *this};
  std::atomic<bool> measuring_{false};
  Ages ages_;
  std::promise<void> full_;
};

struct AloneAndBeside {
  Statistics alone, beside;
  std::uint64_t images = 0;
  std::size_t lost = 0;
};

AloneAndBeside measureLane(const suture::Lane& lane, std::size_t count) {
  const Names names(Transport::Unix);
  AgedServer arm;
  ImageViewer viewer;
  suture::Manager manager("arm", names.address());
  manager.scheduleService(urgent(kLanePriority));
  manager.add("Arm", arm);
  manager.add("Viewer", viewer);
  manager.start();
  ChildProcess guide(imageProcessArguments(names.address(), lane));
  AloneAndBeside result;
  arm.measure(count / 10);  // until it runs evenly
  result.alone = statisticsOf(inUnits(arm.measure(count), kMicrosecond));
  connectBy(lane, manager, "Viewer/Images", "guide:Camera/Images", {.silence = 100ms});
  arm.measure(count / 10);
  const std::uint64_t before = viewer.images();
  result.beside = statisticsOf(inUnits(arm.measure(count), kMicrosecond));
  result.images = viewer.images() - before;
  result.lost = manager.whyLost().size();
  manager.stop();
  guide.finish();
  return result;
}

}  // namespace

std::string imageRows(const NetworkOptions& options, Report& report) {
  Table table(2);
  table.row(joined({"us, age of a goal at 1 kHz", "lane"}, statisticsTitles()));
  table.line();
  for (const suture::Lane& lane : kLanes) {
    const std::string figure = "images." + toString(lane);
    const AloneAndBeside result = measureLane(lane, options.goals());
    report.add(figure + ".alone", "us", result.alone);
    report.add(figure + ".beside", "us", result.beside);
    report.add(figure + ".growth.p50", "us", result.beside.p50 - result.alone.p50);
    report.add(figure + ".growth.p99", "us", result.beside.p99 - result.alone.p99);
    report.add(figure + ".seen", "images", static_cast<double>(result.images));
    report.add(figure + ".lost", "connections", static_cast<double>(result.lost));
    table.row(joined({"alone", toString(lane)}, cellsOf(result.alone, 1)));
    table.row(joined({"beside pairs of images, 15 a second", ""}, cellsOf(result.beside, 1)));
  }
  return table.toString();
}

}  // namespace bench
