// A deployment names a lane that its program brings, as it names any other.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/deploy/check.h>
#include <suture/deploy/host.h>
#include <suture/loop/control_thread.h>
#include <suture/names/global_manager.h>

#include <array>
#include <fstream>
#include <string>

#include "conformance/pipe/pipe_lane.h"
#include "support/contains.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"
#include "unit/deploy/host_scene.h"

namespace conformance {
namespace {

using namespace suture;

class PipeDeployment : public testing::Test {
 protected:
  /// Returns a file whose connection requires that lane.
  std::string fileWith(const std::string& lane) {
    const std::string file = folder_.file("d.json");
    std::ofstream(file) << R"({"manager": ")" << names_.address() << R"(", "processes": [
{"name": "near", "components": [{"name": "C", "class": "Client"}]},
{"name": "far", "components": [{"name": "PSM", "class": "SimulatedArm"}]}],
"connections": [
{"from": "near:C/Arm", "to": "far:PSM/Arm", "lane_required": true, "lane": ")"
                        << lane << "\"}]}";
    return file;
  }

  const TemporaryDirectory folder_;
  loop::ControlThread control_;
  GlobalManager names_{control_, "unix:" + folder_.file("manager.sock")};
};

TEST_F(PipeDeployment, TravelsByTheLaneThatItNames) {
  const Deployment deployment(JsonDocument::read(fileWith("pipe")));
  Host far(deployment, "far", test::kClasses), near(deployment, "near", test::kClasses);
  for (Host* host : {&far, &near}) host->addLane(std::make_unique<PipeLane>());
  far.start();
  near.start();
  ASSERT_EQ(near.manager().channels().size(), 1u);
  EXPECT_EQ(near.manager().channels().front()->lane, "pipe");
  near.stop();
}

TEST_F(PipeDeployment, AWrongNamesLineIsTold) {
  const Deployment deployment(JsonDocument::read(fileWith("pip")));
  Host near(deployment, "near", test::kClasses);
  near.addLane(std::make_unique<PipeLane>());
  EXPECT_EQ(refusal([&] { near.start(); }),
            folder_.file("d.json") +
                ":5: error: connecting near:C/Arm -> far:PSM/Arm: this process has no lane 'pip'; "
                "it has 'shm', 'frame', 'rpc' and 'pipe'. Ask for one of these, or add it with "
                "addLane() first");
}

TEST_F(PipeDeployment, IsJudgedWithItsProgramsLanes) {
  const std::string file = fileWith("pipe");
  const auto problems = [&](const AddedLanes& added) {
    return checkDeployment(file, "", test::kClasses, added).problems;
  };
  const std::vector<std::string> without = problems({});
  ASSERT_EQ(without.size(), 1u);
  EXPECT_TRUE(contains(without[0], "this process has no lane 'pipe'")) << without[0];
  EXPECT_EQ(problems([] {
              std::vector<std::unique_ptr<LaneKind>> lanes;
              lanes.push_back(std::make_unique<PipeLane>());
              return lanes;
            }),
            std::vector<std::string>{});
}

}  // namespace
}  // namespace conformance
