#include "bench/stop/stop_process.h"

#include <suture/manager/manager.h>

#include <memory>
#include <span>

#include "bench/network/lanes.h"
#include "bench/placement.h"
#include "bench/table2/child_process.h"

namespace bench {
namespace {

constexpr const char* kStopSubcommand = "stop-process";

/// Makes a connection over `lane`, or within this process if `process` is "".
void connect(suture::Manager& manager, const std::string& required, const std::string& process,
             const std::string& provided, suture::Lane lane) {
  if (process.empty()) return manager.connect(required, provided);
  connectBy(lane, manager, required, process + ":" + provided);
}

struct Arguments {
  std::string process, address, lane;

  bool isLeft() const { return process == "left"; }
};

/// Parties are there before the manager, which stops them before they go.
void serveDesk(const Arguments& given) {
  StopDesk desk;
  suture::Manager manager(given.process, given.address);
  manager.scheduleService(urgent(70));
  desk.addTo(manager);
  manager.start();
  connectDesk(manager, "left", "right", suture::laneNamed(given.lane));
  awaitEndOfInput();
}

void servePair(const Arguments& given) {
  ArmPair pair(given.isLeft() ? 0 : 2,
               given.isLeft() ? robots::MtmSide::Left : robots::MtmSide::Right);
  suture::Manager manager(given.process, given.address);
  manager.scheduleService(urgent(70));
  pair.addTo(manager);
  manager.start();
  connectPair(manager, pair, "desk", suture::laneNamed(given.lane));
  awaitEndOfInput();
  const std::uint64_t images = pair.viewer.images();
  writeResult(std::span(&images, 1));
}

}  // namespace

void connectPair(suture::Manager& manager, const ArmPair& pair, const std::string& desk,
                 suture::Lane lane) {
  const std::string viewer = std::string("Viewer") + kArms[pair.first].name;
  connect(manager, viewer + "/Images", desk, "Endoscope/Images", lane);
  for (std::size_t arm : {pair.first, pair.first + 1}) {
    connect(manager, std::string(kArms[arm].name) + "Drives/Stop", desk, "Coordinator/Stop", lane);
  }
}

void connectDesk(suture::Manager& manager, const std::string& left, const std::string& right,
                 suture::Lane lane) {
  connect(manager, "Strand/Left", left, "PSM2/Arm", lane);
  connect(manager, "Strand/Right", right, "PSM1/Arm", lane);
}

void addStopProcess(CLI::App& program) {
  auto given = std::make_shared<Arguments>();
  CLI::App* process = program.add_subcommand(kStopSubcommand, "a process with a stop");
  process->group("");  // hidden
  process->add_option("--process", given->process)->required();
  process->add_option("--manager", given->address)->required();
  process->add_option("--lane", given->lane)->required();
  process->callback([given] { given->process == "desk" ? serveDesk(*given) : servePair(*given); });
}

std::vector<std::string> stopProcessArguments(const std::string& process,
                                              const std::string& managerAddress,
                                              suture::Lane lane) {
  return {kStopSubcommand, "--process", process,       "--manager",
          managerAddress,  "--lane",    toString(lane)};
}

}  // namespace bench
