#include "bench/stop/stop_process.h"

#include <suture/manager/manager.h>

#include <memory>

#include "bench/table2/child_process.h"

namespace bench {
namespace {

constexpr const char* kStopSubcommand = "stop-process";

/// `name` of a process, or of this one if that is "".
std::string in(const std::string& process, const std::string& name) {
  return process.empty() ? name : process + ":" + name;
}

void connect(suture::Manager& manager, const std::string& required, const std::string& provided,
             suture::Lane lane) {
  manager.connect(required, provided, lane);
}

void serveDesk(suture::Manager& manager, suture::Lane lane) {
  StopDesk desk;
  desk.addTo(manager);
  manager.start();
  connectDesk(manager, "left", "right", lane);
  awaitEndOfInput();
  manager.stop();
}

void serveWorkstation(suture::Manager& manager, bool isLeft, suture::Lane lane) {
  StopWorkstation workstation(isLeft ? 0 : 2,
                              isLeft ? robots::MtmSide::Left : robots::MtmSide::Right);
  workstation.addTo(manager);
  manager.start();
  connectWorkstation(manager, workstation, "desk", lane);
  awaitEndOfInput();
  manager.stop();
}

void serve(const std::string& process, const std::string& address, const std::string& lane) {
  suture::Manager manager(process, address);
  manager.scheduleService(urgent(70));
  if (process == "desk") {
    serveDesk(manager, suture::laneNamed(lane));
  } else {
    serveWorkstation(manager, process == "left", suture::laneNamed(lane));
  }
}

}  // namespace

void connectWorkstation(suture::Manager& manager, const StopWorkstation& workstation,
                        const std::string& desk, suture::Lane lane) {
  for (std::size_t arm : {workstation.first, workstation.first + 1}) {
    connect(manager, std::string(kArms[arm].name) + "Drives/Stop", in(desk, "Coordinator/Stop"),
            lane);
  }
}

void connectDesk(suture::Manager& manager, const std::string& left, const std::string& right,
                 suture::Lane lane) {
  connect(manager, "Strand/Left", in(left, "PSM2/Arm"), lane);
  connect(manager, "Strand/Right", in(right, "PSM1/Arm"), lane);
}

void addStopProcess(CLI::App& program) {
  struct Arguments {
    std::string process, address, lane;
  };
  auto given = std::make_shared<Arguments>();
  CLI::App* process = program.add_subcommand(kStopSubcommand, "a process with a stop");
  process->group("");  // hidden
  process->add_option("--process", given->process)->required();
  process->add_option("--manager", given->address)->required();
  process->add_option("--lane", given->lane)->required();
  process->callback([given] { serve(given->process, given->address, given->lane); });
}

std::vector<std::string> stopProcessArguments(const std::string& process,
                                              const std::string& managerAddress,
                                              suture::Lane lane) {
  return {kStopSubcommand, "--process", process,       "--manager",
          managerAddress,  "--lane",    toString(lane)};
}

}  // namespace bench
