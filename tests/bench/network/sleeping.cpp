#include <suture/manager/manager.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include "bench/figures/table.h"
#include "bench/network/names.h"
#include "bench/network/process_usage.h"
#include "bench/network/rows.h"
#include "bench/network/sleeper.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

std::set<fs::path> threads() {
  std::set<fs::path> all;
  for (const auto& thread : fs::directory_iterator("/proc/self/task")) all.insert(thread.path());
  return all;
}

double wakeUpsOf(const std::set<fs::path>& threads) {
  double sum = 0;
  for (const fs::path& thread : threads) sum += bench::wakeUpsOf(thread);
  return sum;
}

/// Sleeping components take so much.
struct Sleeping {
  double wakeUps;      ///< all their threads' in the whole window
  double descriptors;  ///< how many each component takes
};

Sleeping sleeping(std::size_t components, const NetworkOptions& options) {
  const Names names(Transport::Unix);
  suture::Manager manager("sleepers", names.address());
  const double before = descriptorsOf(getpid());
  const std::set<fs::path> others = threads();
  std::vector<std::unique_ptr<Sleeper>> sleepers;
  for (std::size_t i = 0; i < components; ++i) {
    sleepers.push_back(std::make_unique<Sleeper>());
    manager.add("Sleeper" + std::to_string(i), *sleepers.back());
  }
  manager.start();
  const double descriptors = descriptorsOf(getpid()) - before;
  std::set<fs::path> own = threads();
  for (const fs::path& other : others) own.erase(other);

  std::this_thread::sleep_for(options.idleWindow() / 4);  // work that starting them began has ended
  const double begin = wakeUpsOf(own);
  std::this_thread::sleep_for(options.idleWindow());
  const double wakeUps = wakeUpsOf(own) - begin;
  manager.stop();
  return {.wakeUps = wakeUps, .descriptors = descriptors / static_cast<double>(components)};
}

constexpr std::array<std::size_t, 3> kComponents = {10, 100, 1000};

}  // namespace

std::string sleepingRows(const NetworkOptions& options, Report& report) {
  Table table(1);
  table.row({"sleeping components of a process", "wake-ups", "descriptors each"});
  table.line();
  for (const std::size_t components : kComponents) {
    const Sleeping now = sleeping(components, options);
    const std::string count = std::to_string(components);
    table.row({count, number(now.wakeUps, 0), number(now.descriptors, 2)});
    report.add("sleeping." + count + ".wake_ups", "wake-ups", now.wakeUps);
    report.add("sleeping." + count + ".descriptors", "each", now.descriptors);
  }
  return table.toString();
}

}  // namespace bench
