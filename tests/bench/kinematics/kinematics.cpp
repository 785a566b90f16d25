// suture-bench kinematics: what a call of inverse kinematics costs.

#include <suture/base/time.h>

#include <algorithm>
#include <cmath>

#include "bench/kinematics/options.h"
#include "bench/kinematics/queries.h"
#include "bench/parts.h"
#include "bench/table.h"
#include "bench/timed_loops.h"
#include "kinematics/davinci.h"
#include "kinematics/davinci_links.h"
#include "kinematics/mtm_inverse.h"
#include "kinematics/psm_inverse.h"

namespace bench {
namespace {

using namespace robots::kinematics;

// The wrist in the remote centre, or its yaw axis through that.
void makePsmSingular(Chain<6>::Joints& q, int which) {
  q[4] *= 0.6;  // beyond that the yaw axis leads through it beyond the limits only
  q[2] = kPsmCarriage - kPsmShaft - (which == 0 ? 0 : kPsmWrist / std::cos(q[4]));
}

// The axes of platform and roll in line.
void makeMtmSingular(Chain<7>::Joints& q, int which) {
  q[4] = which == 0 ? kHalfPi : -kHalfPi;
  q[5] = 0;
}

// One pose, and the shortest of its calls.
template <int N>
struct TimedPose {
  Query<N> query;
  Postures postures;
  suture::Duration shortest = suture::Duration::max();
  bool found = false;

  void measure(const Chain<N>& chain, InverseFunction<N> solve) {
    const suture::Time begin = suture::now();
    InverseSolution<N> solution = solve(chain, query.goal, query.start, postures);
    keep(solution);
    shortest = std::min(shortest, suture::now() - begin);
    found = solution.found;
  }
  bool isMissed() const { return query.admissible && postures == Postures::All && !found; }
};

struct Calls {
  Statistics cost;  // us
  std::size_t missed = 0;
};

// The repeats of a pose are some milliseconds apart: what interrupts one does not last that long.
template <int N>
Calls measure(const Chain<N>& chain, InverseFunction<N> solve, Queries<N> queries,
              std::size_t count) {
  constexpr std::size_t kBatch = 1000;
  constexpr int kRepeats = 5;
  Calls calls;
  std::vector<double> costs;
  costs.reserve(count);
  while (costs.size() < count) {
    std::vector<TimedPose<N>> batch;
    for (std::size_t i = 0; i < std::min(kBatch, count - costs.size()); ++i) {
      // Every other round of kinds as a stream asks.
      batch.push_back({queries.next(), i / 8 % 2 == 0 ? Postures::All : Postures::Near});
    }
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
      for (TimedPose<N>& pose : batch) pose.measure(chain, solve);
    }
    for (const TimedPose<N>& pose : batch) {
      costs.push_back(static_cast<double>(pose.shortest.count()) / kMicrosecond);
      calls.missed += pose.isMissed() ? 1 : 0;
    }
  }
  calls.cost = statisticsOf(std::move(costs));
  return calls;
}

template <int N>
std::string armRows(const char* arm, const Chain<N>& chain, InverseFunction<N> solve,
                    typename Queries<N>::MakeSingular makeSingular,
                    const KinematicsOptions& options, Report& report) {
  const Pinned pinned(options.cpu);
  const Queries<N> queries(chain, makeSingular);
  const std::size_t count = options.count();
  const Calls closed = measure<N>(chain, solve, queries, count);
  const Calls general = measure<N>(chain, searched<N>, queries, (count + 999) / 1000);
  const std::string name = arm;
  report.add(name, "us", closed.cost);
  report.add(name + ".missed", "poses", static_cast<double>(closed.missed));
  report.add(name + ".poses", "poses", static_cast<double>(closed.cost.count));
  report.add(name + ".search", "us", general.cost);
  Table table(1);
  table.row(joined({name + ", us a call"}, statisticsTitles()));
  table.line();
  table.row(joined({"closed form"}, cellsOf(closed.cost, 2)));
  table.row(joined({"general search"}, cellsOf(general.cost, 2)));
  table.row({"missed, of all poses", std::to_string(closed.missed), std::to_string(count)});
  return table.toString();
}

std::string psmRows(const KinematicsOptions& options, Report& report) {
  return armRows<6>("psm", psm(), psmInverse, makePsmSingular, options, report);
}

std::string mtmRows(const KinematicsOptions& options, Report& report) {
  return armRows<7>("mtm", mtmLeft(), mtmInverse, makeMtmSingular, options, report);
}

constexpr Part<KinematicsOptions> kKinematicsParts[] = {{"PSM", psmRows}, {"MTM", mtmRows}};

}  // namespace

std::unique_ptr<Benchmark> makeKinematics() {
  return std::make_unique<PartsBenchmark<KinematicsOptions>>(
      "kinematics", "a call of inverse kinematics in closed form, over a million poses of each arm",
      kKinematicsParts);
}

}  // namespace bench
