// This is suture-bench kinematics: what a call of inverse kinematics costs.

#include <cmath>

#include "bench/counted_options.h"
#include "bench/figures/table.h"
#include "bench/kinematics/queries.h"
#include "bench/parts.h"
#include "bench/shortest_calls.h"
#include "bench/timed_loops.h"
#include "kinematics/davinci.h"
#include "kinematics/davinci_links.h"
#include "kinematics/mtm_inverse.h"
#include "kinematics/psm_inverse.h"

namespace bench {
namespace {

using namespace robots::kinematics;

// Puts the wrist in the remote centre, or its yaw axis through that.
void makePsmSingular(Chain<6>::Joints& q, int which) {
  q[4] *= 0.6;  // beyond that only joints outside the limits are singular
  q[2] = kPsmCarriage - kPsmShaft - (which == 0 ? 0 : kPsmWrist / std::cos(q[4]));
}

// Puts the axes of platform and roll in line.
void makeMtmSingular(Chain<7>::Joints& q, int which) {
  q[4] = which == 0 ? kHalfPi : -kHalfPi;
  q[5] = 0;
}

template <int N>
struct Pose {
  Query<N> query;
  Postures postures;
  bool found = false;

  bool isMissed() const { return query.admissible && postures == Postures::All && !found; }
};

struct Calls {
  Statistics cost, every;  // us: of each case the shortest call, and every call
  std::size_t missed = 0;
};

template <int N>
Calls measure(const Chain<N>& chain, InverseFunction<N> solve, Queries<N> queries,
              std::size_t count) {
  Calls calls;
  std::size_t asked = 0;
  const auto next = [&] {
    // Queries have eight kinds. Each kind is asked in turn as a move asks, and as a stream does.
    return Pose<N>{queries.next(), asked++ / 8 % 2 == 0 ? Postures::All : Postures::Near};
  };
  const auto call = [&](Pose<N>& pose) {
    InverseSolution<N> solution = solve(chain, pose.query.goal, pose.query.start, pose.postures);
    keep(solution);
    pose.found = solution.found;
  };
  const auto done = [&](const Pose<N>& pose) { calls.missed += pose.isMissed() ? 1 : 0; };
  const CallCosts costs = shortestCalls(count, next, call, done);
  calls.cost = statisticsOf(costs.shortest);
  calls.every = statisticsOf(costs.every);
  return calls;
}

template <int N>
std::string armRows(const char* arm, const Chain<N>& chain, InverseFunction<N> solve,
                    typename Queries<N>::MakeSingular makeSingular, const CountedOptions& options,
                    Report& report) {
  const Pinned pinned(options.cpu);
  const Queries<N> queries(chain, makeSingular);
  const std::size_t count = options.count();
  const Calls closed = measure<N>(chain, solve, queries, count);
  const Calls general = measure<N>(chain, searched<N>, queries, (count + 999) / 1000);
  const std::string name = arm;
  report.add(name, "us", closed.cost);
  report.add(name + ".every", "us", closed.every);
  report.add(name + ".missed", "poses", static_cast<double>(closed.missed));
  report.add(name + ".poses", "poses", static_cast<double>(closed.cost.count));
  report.add(name + ".search", "us", general.cost);
  Table table(1);
  table.row(joined({name + ", us a call"}, statisticsTitles()));
  table.line();
  table.row(joined({"closed form"}, cellsOf(closed.cost, 2)));
  table.row(joined({"  every call, interrupted or not"}, cellsOf(closed.every, 2)));
  table.row(joined({"general search"}, cellsOf(general.cost, 2)));
  table.row({"missed, of all poses", std::to_string(closed.missed), std::to_string(count)});
  return table.toString();
}

std::string psmRows(const CountedOptions& options, Report& report) {
  return armRows<6>("psm", psm(), psmInverse, makePsmSingular, options, report);
}

std::string mtmRows(const CountedOptions& options, Report& report) {
  return armRows<7>("mtm", mtmLeft(), mtmInverse, makeMtmSingular, options, report);
}

constexpr Part<CountedOptions> kKinematicsParts[] = {{"PSM", psmRows}, {"MTM", mtmRows}};

}  // namespace

std::unique_ptr<Benchmark> makeKinematics() {
  return std::make_unique<PartsBenchmark<CountedOptions>>(
      "kinematics", "a call of inverse kinematics in closed form, over a million poses of each arm",
      kKinematicsParts);
}

}  // namespace bench
