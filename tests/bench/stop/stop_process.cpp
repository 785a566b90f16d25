#include "bench/stop/stop_process.h"

#include <suture/manager/manager.h>

#include <memory>
#include <span>

#include "bench/network/lanes.h"
#include "bench/placement.h"
#include "bench/table2/processes/child_process.h"

namespace bench {
namespace {

constexpr const char* kStopSubcommand = "stop-process";

/// Makes a connection over `lane`, or within this process if `process` is "".
void connect(suture::Manager& manager, const std::string& required, const std::string& process,
             const std::string& provided, const suture::Lane& lane) {
  if (process.empty()) return manager.connect(required, provided);
  connectBy(lane, manager, required, process + ":" + provided);
}

struct Arguments {
  std::string process, address, lane;

  bool isLeft() const { return process == "left"; }
};

const Places kElsewhere{.desk = "desk", .left = "left", .right = "right", .vision = "vision"};

/// Runs `party` until it is told to end. It is there before the manager, which stops it before it
/// goes.
template <class Party, class Connect>
void serve(const Arguments& given, Party& party, const Connect& connectParty) {
  suture::Manager manager(given.process, given.address);
  manager.scheduleService(urgent(70));
  party.addTo(manager);
  manager.start();
  connectParty(manager, {given.lane});
  awaitEndOfInput();
}

void serveDesk(const Arguments& given) {
  StopDesk desk;
  serve(given, desk, [](suture::Manager&, suture::Lane) {});
}

void serveVision(const Arguments& given) {
  StopVision vision;
  serve(given, vision, [](suture::Manager& manager, const suture::Lane& lane) {
    connectVision(manager, kElsewhere, lane);
  });
}

void servePair(const Arguments& given) {
  ArmPair pair(given.isLeft() ? 0 : 2, given.isLeft() ? robots::Side::Left : robots::Side::Right);
  serve(given, pair, [&](suture::Manager& manager, const suture::Lane& lane) {
    connectPair(manager, pair, kElsewhere, lane);
  });
  const std::uint64_t images = pair.viewer.images();
  writeResult(std::span(&images, 1));
}

void serveProcess(const Arguments& given) {
  if (given.process == "desk") return serveDesk(given);
  if (given.process == "vision") return serveVision(given);
  servePair(given);
}

}  // namespace

void connectPair(suture::Manager& manager, const ArmPair& pair, const Places& places,
                 const suture::Lane& lane) {
  const std::string viewer = std::string("Viewer") + kArms[pair.first].name;
  connect(manager, viewer + "/Images", places.vision, "Endoscope/Images", lane);
  for (std::size_t arm : {pair.first, pair.first + 1}) {
    connect(manager, std::string(kArms[arm].name) + "Drives/Stop", places.desk, "Coordinator/Stop",
            lane);
  }
}

void connectVision(suture::Manager& manager, const Places& places, const suture::Lane& lane) {
  connect(manager, "Strand/Left", places.left, "PSM2/Arm", lane);
  connect(manager, "Strand/Right", places.right, "PSM1/Arm", lane);
}

void addStopProcess(CLI::App& program) {
  auto given = std::make_shared<Arguments>();
  CLI::App* process = program.add_subcommand(kStopSubcommand, "a process with a stop");
  process->group("");  // hidden
  process->add_option("--process", given->process)->required();
  process->add_option("--manager", given->address)->required();
  process->add_option("--lane", given->lane)->required();
  process->callback([given] { serveProcess(*given); });
}

std::vector<std::string> stopProcessArguments(const std::string& process,
                                              const std::string& managerAddress,
                                              const suture::Lane& lane) {
  return {kStopSubcommand, "--process", process,       "--manager",
          managerAddress,  "--lane",    toString(lane)};
}

}  // namespace bench
