// These are the sentences by which models refuse their parameters.

#include "parameters/parameter_check.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace robots::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns why `judge` refuses, or nothing.
template <class Judge>
std::string whyNot(const Judge& judge) {
  try {
    judge(ParameterCheck("a hand"));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ParameterCheck, NamesTheParameterAndWhatWasFound) {
  const auto judge = [](const ParameterCheck& hand) {
    hand.isPositive("mass in kg", 0.9).isNotNegative("damping in N.s/m", -2.5);
  };
  EXPECT_EQ(whyNot(judge), "a hand: its damping in N.s/m is -2.5, and must be zero or more");
}

TEST(ParameterCheck, RefusesZeroWhereItMustBePositive) {
  EXPECT_EQ(whyNot([](const ParameterCheck& hand) { hand.isPositive("mass", 0); }),
            "a hand: its mass is 0, and must be positive");
  EXPECT_EQ(whyNot([](const ParameterCheck& hand) { hand.isNotNegative("mass", 0); }), "");
}

TEST(ParameterCheck, RefusesWhatIsNotANumber) {
  EXPECT_NE(whyNot([](const ParameterCheck& hand) { hand.isPositive("mass", kNan); }), "");
  EXPECT_NE(whyNot([](const ParameterCheck& hand) { hand.isNotNegative("mass", kNan); }), "");
  EXPECT_NE(whyNot([](const ParameterCheck& hand) { hand.isFinite("mass", kNan); }), "");
}

TEST(ParameterCheck, RefusesInfinityWhereItMustBeFinite) {
  EXPECT_EQ(whyNot([](const ParameterCheck& hand) { hand.isPositive("mass", kInfinity); }), "");
  EXPECT_EQ(whyNot([](const ParameterCheck& hand) { hand.isFinite("mass", kInfinity); }),
            "a hand: its mass is inf, and must be finite");
}

TEST(ParameterCheck, JudgesTheValueOfEachJoint) {
  const Eigen::Vector3d rates(1, -0.5, 0);
  EXPECT_EQ(whyNot([&](const ParameterCheck& hand) { hand.arePositive("rate", rates); }),
            "a hand: its rate is -0.5, and must be positive");
  EXPECT_EQ(whyNot([&](const ParameterCheck& hand) { hand.areNotNegative("rate", rates); }),
            "a hand: its rate is -0.5, and must be zero or more");
}

}  // namespace
}  // namespace robots::test
