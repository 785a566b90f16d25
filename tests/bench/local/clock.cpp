#include <suture/base/time.h>

#include <chrono>
#include <vector>

#include "bench/figures/table.h"
#include "bench/local/rows.h"
#include "bench/timed_loops.h"

namespace bench {

std::string clockRows(const LocalOptions& options, Report& report) {
  constexpr std::size_t kCalls = 20'000;
  std::vector<double> seam, kernel, extra;
  for (std::size_t turn = 0; turn < options.count(200); ++turn) {
    seam.push_back(timedLoops(1, kCalls, [] {
                     const suture::Time time = suture::now();
                     keep(time);
                   }).p50);
    kernel.push_back(timedLoops(1, kCalls, [] {
                       const suture::Time time = suture::Clock::now();
                       keep(time);
                     }).p50);
    extra.push_back(seam.back() - kernel.back());
  }
  const Statistics ofSeam = statisticsOf(seam), ofKernel = statisticsOf(kernel),
                   ofExtra = statisticsOf(extra);
  report.add("now", "ns", ofSeam);
  report.add("now.extra", "ns", ofExtra);
  Table table(1);
  table.row(joined({"ns, by turns"}, statisticsTitles()));
  table.line();
  table.row(joined({"now(), which a test can step"}, cellsOf(ofSeam, 1)));
  table.row(joined({"the kernel's steady clock"}, cellsOf(ofKernel, 1)));
  table.row(joined({"  what the seam adds"}, cellsOf(ofExtra, 1)));
  return table.toString();
}

}  // namespace bench
