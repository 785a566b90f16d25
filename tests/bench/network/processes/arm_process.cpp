#include "bench/network/processes/arm_process.h"

#include <suture/manager/manager.h>

#include <memory>
#include <span>

#include "bench/table2/processes/child_process.h"
#include "rt/task_thread/arm_tasks.h"

namespace bench {
namespace {

constexpr const char* kArmSubcommand = "network-arm";

void serve(const std::string& managerAddress) {
  AllocationCount count;
  proof::ArmTask<suture::PeriodicTask> arm(kCycle);
  arm.also = [&] { count.cycle(!arm.arm.channels().empty()); };
  suture::Manager manager{"arm", managerAddress};
  manager.add("Arm", arm);
  manager.start();
  awaitEndOfInput();
  const ArmResult result{.cycles = count.cycles(),
                         .allocations = count.found(),
                         .laneAllocations = count.foundInLane(),
                         .laneThreads = laneThreads()};
  manager.stop();
  writeResult(std::span(&result, 1));
}

}  // namespace

void addArmProcess(CLI::App& program) {
  auto address = std::make_shared<std::string>();
  CLI::App* process = program.add_subcommand(kArmSubcommand, "the arm of a measurement");
  process->group("");  // hidden
  process->add_option("--manager", *address)->required();
  process->callback([address] { serve(*address); });
}

std::vector<std::string> armProcessArguments(const std::string& managerAddress) {
  return {kArmSubcommand, "--manager", managerAddress};
}

}  // namespace bench
