// A deployment says the coordinate frames of interfaces.

#include <gtest/gtest.h>
#include <suture/component/required.h>
#include <suture/deploy/host.h>

#include <array>
#include <memory>

#include "reference/simulated_arm.suture.h"
#include "unit/deploy/document_problems.h"

namespace suture {
namespace {

/// Declares one frame itself.
class Guide final : public PeriodicTask {
 public:
  Guide() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {
    arm_.declareFrames({"", "PSM2_tip"});
  }

 private:
  void run() override {}

  Required<reference::ArmLike> arm_{*this, "Slave"};
};

const std::array kFramedClasses{componentClass<reference::SimulatedArm>(),
                                ComponentClass{"Guide", [](const JsonReader& in) {
                                                 in.finish();
                                                 return std::unique_ptr<Component>(new Guide());
                                               }}};

/// `arm` stands on line 2, `guide` on line 3, the connection on line 5.
Deployment framedDeployment(const std::string& arm, const std::string& guide) {
  return Deployment(JsonDocument::parse(
      "{\"processes\": [{\"name\": \"all\", \"components\": [\n"
      R"({"name": "PSM1", "class": "SimulatedArm", "frames": {)" +
          arm + "}},\n" + R"({"name": "Guide", "class": "Guide", "frames": {)" + guide +
          "}}]}],\n\"connections\": [\n"
          R"({"from": "all:Guide/Slave", "to": "all:PSM1/Arm"}]})",
      "d.json"));
}

Texts start(const std::string& arm, const std::string& guide) {
  const Deployment deployment = framedDeployment(arm, guide);
  return problemsOf([&] { Host(deployment, "all", kFramedClasses).start(); });
}

constexpr char kFirstArm[] = R"("Arm": {"reference": "PSM1_base", "moving": "PSM1_tip"})";

TEST(InterfaceFrames, AreComparedWhenTheDeploymentConnects) {
  EXPECT_EQ(start(R"("Arm": {"reference": "PSM2_base", "moving": "PSM2_tip"})",
                  R"("Slave": {"reference": "PSM2_base"})"),
            Texts{});
  const Texts refused = start(kFirstArm, R"("Slave": {"reference": "PSM2_base"})");
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_TRUE(refused[0].starts_with(
      "d.json:5: error: connecting all:Guide/Slave -> all:PSM1/Arm: it expects reference frame "
      "'PSM2_base' and is offered 'PSM1_base', and moving frame 'PSM2_tip' and is offered "
      "'PSM1_tip'. "))
      << refused[0];
}

TEST(InterfaceFrames, AnUnknownInterfaceIsAnError) {
  EXPECT_EQ(start(R"("Amr": {"reference": "PSM1_base"})", ""),
            Texts{"d.json:2: error: component 'PSM1': declaring the frames of interface 'Amr': its "
                  "component has interfaces 'Arm'. Did you mean 'Arm'?"});
}

TEST(InterfaceFrames, ConflictingFramesAreAnError) {
  EXPECT_EQ(start("", R"("Slave": {"moving": "PSM1_tip"})"),
            Texts{"d.json:3: error: component 'Guide': declaring 'PSM1_tip' as the moving frame of "
                  "'Slave': that is 'PSM2_tip' already. Declare each frame once"});
}

TEST(InterfaceFrames, InvalidFramesAreAnError) {
  const auto problemWith = [](const std::string& frames) {
    const Texts problems = problemsOf([&] { (void)framedDeployment("\"Arm\": " + frames, ""); });
    return problems.size() == 1 ? problems[0] : std::to_string(problems.size()) + " problems";
  };
  for (const char* frames : {"{}", R"({"base": "PSM1_base"})", R"({"reference": ""})",
                             R"({"reference": "two words"})", R"("PSM1_base")"}) {
    EXPECT_TRUE(problemWith(frames).starts_with("d.json:2: error: ")) << problemWith(frames);
  }
}

}  // namespace
}  // namespace suture
