#include <thread>

#include "bench/figures/table.h"
#include "bench/network/lanes.h"
#include "bench/network/names.h"
#include "bench/network/processes/arm_process.h"
#include "bench/network/rows.h"
#include "bench/table2/processes/child_process.h"
#include "rt/task_thread/arm_tasks.h"

namespace bench {
namespace {

using suture::SetupError;

struct Counts {
  std::uint64_t client, arm;
  std::uint64_t lane, laneThreads;  // sums over both processes
};

void awaitCycles(const AllocationCount& count, std::uint64_t cycles) {
  const suture::Time deadline = suture::now() + std::chrono::minutes(1);
  while (count.cycles() < cycles) {
    if (suture::now() > deadline) {
      throw SetupError(std::to_string(cycles) + " cycles of the client",
                       std::to_string(count.cycles()) + " after a minute", "Run it again");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

// Throws if the contract was not used, since then nothing shows that it allocates nothing.
void requireUse(const proof::ArmUser& user, const std::vector<ArmResult>& arm) {
  if (user.reads > 0 && user.events > 0 && user.answers > 0 && arm.size() == 1 && arm[0].cycles > 0)
    return;
  throw SetupError("an arm in use",
                   std::to_string(user.reads) + " reads, " + std::to_string(user.events) +
                       " events, " + std::to_string(user.answers) + " answers",
                   "Run it again");
}

Counts countOver(const suture::Lane& lane, std::uint64_t cycles) {
  AllocationCount count;
  proof::UserTask<suture::PeriodicTask> client(kCycle);
  client.also = [&] { count.cycle(client.arm.connected()); };
  const Names names(Transport::Unix);
  ChildProcess arm(armProcessArguments(names.address()));
  suture::Manager manager("client", names.address());
  manager.add("Client", client);
  manager.start();
  connectBy(lane, manager, "Client/Arm", "arm:Arm/Arm");
  awaitCycles(count, cycles);
  // Count before the ending, which allocates.
  Counts counts{
      .client = count.found(), .arm = 0, .lane = count.foundInLane(), .laneThreads = laneThreads()};
  const auto written = resultIn<ArmResult>(arm.finish());
  manager.stop();
  requireUse(client.user, written);
  counts.arm = written[0].allocations;
  counts.lane += written[0].laneAllocations;
  counts.laneThreads += written[0].laneThreads;
  return counts;
}

// Leaves the figures of the lane's own threads. On shm and rpc there is no such thread: tasks do it
// themselves, or the control threads do. That there is none is the figure of shm.
void addLane(const suture::Lane& lane, const std::string& figure, const Counts& counts,
             Report& report) {
  if (lane == suture::Lane::Rpc) return;
  report.add(figure + ".lane_threads", "threads", static_cast<double>(counts.laneThreads));
  if (lane == suture::Lane::Shm) return;
  if (counts.laneThreads != 2) {
    throw SetupError("a lane thread at both ends", std::to_string(counts.laneThreads) + " threads",
                     std::string("Look for another name than ") + kLaneThread);
  }
  report.add(figure + ".lane", "allocations", static_cast<double>(counts.lane));
}

}  // namespace

std::string allocationRows(const NetworkOptions& options, Report& report) {
  Table table(1);
  table.row({"allocations in steady state, CRTK arm at 1 kHz", "client's task", "arm's task",
             "lane threads"});
  table.line();
  for (const suture::Lane& lane : kLanes) {
    const std::string figure = "allocations." + toString(lane);
    if (!suture::countsAllocations()) {
      for (const char* end : {".client", ".arm", ".lane", ".lane_threads"}) {
        report.addUnavailable(figure + end, "a sanitizer has the heap for itself");
      }
      continue;
    }
    const Counts counts = countOver(lane, options.steadyCycles());
    report.add(figure + ".client", "allocations", static_cast<double>(counts.client));
    report.add(figure + ".arm", "allocations", static_cast<double>(counts.arm));
    addLane(lane, figure, counts, report);
    table.row({toString(lane), std::to_string(counts.client), std::to_string(counts.arm),
               counts.laneThreads == 0 ? "there is none" : std::to_string(counts.lane)});
  }
  return table.toString();
}

}  // namespace bench
