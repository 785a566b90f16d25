// The hands of an operator feel slaves that they know with a delay.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "integration/operator/desk.h"
#include "support/stepped.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;
using suture::pass;

constexpr double kMostLacking = 1e-3;  // J
const Vector3d kPlace{0.01, -0.02, 0.02};

/// Stiffer than a hand and hardly damped: a hand does not calm it.
OperatorParameters feeling(bool passive) {
  return {.force_feedback = ForceFeedback::PositionPosition,
          .stiffness = 2000,
          .damping = 2,
          .passive = passive};
}

/// FeelingHands have a delay of 50 ms there and 50 ms back. A slave is exactly where its master
/// sends it, so the master's arm stands for both, and a metre of it is one of the slave's.
struct FeelingHands : testing::Test {
  void begin(OperatorParameters parameters) {
    parameters.target = kPlace;
    parameters.scale = 1;
    desk.seatOperator(parameters);
    connectSlave("Left");
    connectSlave("Right");
  }
  void connectSlave(const std::string& side) {
    desk.manager.connect("Operator/" + side + "Slave", side + "Master/Arm",
                         {.patience = 1s, .delay = {.answers = 100ms}});
  }
  double energy() const {
    return std::min(desk.surgeon->leftEnergy(), desk.surgeon->rightEnergy());
  }
  /// Returns the least energy in so much time, J.
  double leastEnergy(int milliseconds) {
    double least = energy();
    for (int i = 0; i < milliseconds; ++i) {
      pass(1ms);
      least = std::min(least, energy());
    }
    return least;
  }

  Desk desk;
};

TEST_F(FeelingHands, FeelNothingUnlessTheyAreToldTo) {
  begin({});
  EXPECT_EQ(leastEnergy(5000), 0);
  EXPECT_LT((desk.knot() - kPlace).norm(), 2e-3);
}

TEST_F(FeelingHands, GainEnergyWithoutTheController) {
  begin(feeling(false));
  EXPECT_LT(leastEnergy(5000), -100 * kMostLacking);
}

TEST_F(FeelingHands, PlaceTheKnotPassivelyWithTheController) {
  begin(feeling(true));
  const double least = leastEnergy(10'000);
  RecordProperty("least_mJ", std::to_string(1e3 * least));
  EXPECT_GT(least, -kMostLacking);
  EXPECT_LT((desk.knot() - kPlace).norm(), 2e-3);
}

TEST_F(FeelingHands, FeelNoUnknownSlave) {
  begin(feeling(true));
  pass(2s);
  desk.manager.disconnect("Operator/LeftSlave");
  desk.manager.disconnect("Operator/RightSlave");
  pass(100ms);
  const double before = energy();
  pass(1s);
  EXPECT_EQ(energy(), before);
  connectSlave("Left");
  connectSlave("Right");
  EXPECT_GT(leastEnergy(2000), -kMostLacking);
}

}  // namespace
}  // namespace robots::test
