// An operator who sees the synthetic endoscope's pictures, however late, places a knot with two da
// Vinci arms behind the virtual fixtures, where a script stood before.

#include <gtest/gtest.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <string>

#include "guidance/knot_guide.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "integration/teleoperation/scene/knot_scene.h"
#include "registration/registration_table.h"
#include "strand/strand_simulation.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "surgeon/operator.h"
#include "vision/knot_tracker.h"
#include "vision/synthetic_endoscope.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;

/// Holds all of the system, in one process.
struct Theatre {
  explicit Theatre(suture::Duration delay) {
    leftMaster.addTo(manager, "MTML");
    rightMaster.addTo(manager, "MTMR");
    leftSlave.addTo(manager, "PSM2");
    rightSlave.addTo(manager, "PSM1");
    manager.add("Surgeon", surgeon);
    manager.add("Guide", guide);
    manager.add("Registration", registration);
    manager.add("Strand", strand);
    manager.add("Endoscope", endoscope);
    manager.add("Tracker", tracker);
    connectGuide();
    connectCameras();
    manager.connect("Surgeon/Left", "MTML/Arm");
    manager.connect("Surgeon/Right", "MTMR/Arm");
    manager.connect("Surgeon/Guidance", "Guide/Guidance");
    manager.connect("Surgeon/Registration", "Registration/Registration");
    manager.connect("Surgeon/Vision", "Tracker/Vision",
                    {.patience = 1s, .delay = {.answers = delay}});
    manager.start();
  }
  ~Theatre() { manager.stop(); }

  void connectGuide() {
    manager.connect("Guide/LeftMaster", "MTML/Arm");
    manager.connect("Guide/LeftSlave", "PSM2/Arm");
    manager.connect("Guide/RightMaster", "MTMR/Arm");
    manager.connect("Guide/RightSlave", "PSM1/Arm");
    manager.connect("Guide/Vision", "Tracker/Vision");
    manager.connect("Guide/Registration", "Registration/Registration");
  }
  void connectCameras() {
    manager.connect("Strand/Left", "PSM2/Arm");
    manager.connect("Strand/Right", "PSM1/Arm");
    manager.connect("Strand/Registration", "Registration/Registration");
    manager.connect("Endoscope/Strand", "Strand/Strand");
    manager.connect("Endoscope/Registration", "Registration/Registration");
    manager.connect("Tracker/Images", "Endoscope/Images");
  }
  /// Returns how far the knot is from its target, m.
  double error() const { return (strand.strand().nodes.col(Strand::kKnot) - kKnotTarget).norm(); }

  DrivenMtm leftMaster{Side::Left}, rightMaster{Side::Right};
  DrivenPsm leftSlave, rightSlave;
  Operator surgeon{{.target = kKnotTarget}};
  KnotGuide guide{{.target = kKnotTarget}};
  RegistrationTable registration{knotScene()};
  StrandSimulation strand{StrandParameters{}};
  SyntheticEndoscope endoscope{EndoscopeParameters{}};
  KnotTracker tracker{TrackerParameters{}};
  suture::Manager manager{"theatre"};
};

/// Runs with each lateness of the picture.
class PlacingAKnot : public testing::TestWithParam<std::chrono::milliseconds> {};
INSTANTIATE_TEST_SUITE_P(Delays, PlacingAKnot, testing::Values(0ms, 150ms),
                         [](const auto& one) { return std::to_string(one.param.count()) + "ms"; });

TEST_P(PlacingAKnot, SucceedsWithAnOperatorWhoLooks) {
  Theatre theatre(GetParam());
  ASSERT_TRUE(suture::clockOfTest().until(
      [&] { return theatre.guide.guidance_state() == GuidanceState::Guiding; }));
  EXPECT_GT(theatre.error(), 0.01);
  EXPECT_TRUE(suture::clockOfTest().until([&] { return theatre.error() < 1e-3; }));
  suture::pass(3s);
  EXPECT_LT(theatre.error(), 1e-3);
  RecordProperty("error_um", std::to_string(1e6 * theatre.error()));
}

}  // namespace
}  // namespace robots::test
