// Components refuse times and bounds that make no sense, and name the parameter.

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "arm_control/mtm.h"
#include "arm_control/psm.h"
#include "assistant/assistant.h"
#include "console/system_console.h"
#include "drives/mtm_drives.h"
#include "drives/psm_drives.h"
#include "guidance/knot_guide.h"
#include "pedals/scripted_pedals.h"
#include "person/gamepad.h"
#include "person/keyboard.h"
#include "support/refusal.h"
#include "surgeon/operator.h"
#include "teleop/teleop.h"
#include "unit/person/pseudo_terminal.h"
#include "vision/knot_tracker.h"
#include "vision/synthetic_endoscope.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;

/// `make` makes a component whose parameter `name` has the time that it is given.
template <class Make>
void expectRefused(const std::string& name, const std::vector<suture::Duration>& times,
                   const Make& make) {
  for (const suture::Duration time : times) {
    const std::string why = suture::refusal([&] { make(time); });
    EXPECT_NE(why.find('"' + name + '"'), std::string::npos)
        << name << " of " << time.count() << " ns: '" << why << "'";
  }
}

template <class Make>
void expectAccepted(const std::vector<suture::Duration>& times, const Make& make) {
  for (const suture::Duration time : times) {
    EXPECT_EQ(suture::refusal([&] { make(time); }), "") << time.count() << " ns";
  }
}

/// The parameter is a time, and without one the component would not wait at all.
template <class Make>
void expectTime(const std::string& name, const Make& make) {
  expectRefused(name, {-1s, 0s, 500us, std::chrono::hours(25)}, make);
  expectAccepted({1ms, 1s}, make);
}

/// The parameter is a time, and 0 means something else.
template <class Make>
void expectTimeOrZero(const std::string& name, const Make& make) {
  expectRefused(name, {-1s, 500us, std::chrono::hours(25)}, make);
  expectAccepted({0s, 1ms, 1s}, make);
}

template <class Make>
void expectAge(const std::string& name, const Make& make) {
  expectRefused(name, {-1s, 0s, 61s}, make);
  expectAccepted({20ms, 1s}, make);
}

TEST(Parameters, AssistantRefusesImpossibleTimes) {
  expectTime("patience", [](auto time) { Assistant({.patience = time}); });
  expectTime("release_after", [](auto time) { Assistant({.release_after = time}); });
  expectTimeOrZero("press_after", [](auto time) { Assistant({.press_after = time}); });
}

TEST(Parameters, ConsoleRefusesImpossibleTimes) {
  expectTime("patience", [](auto time) { SystemConsole({.system = {}, .patience = time}); });
}

TEST(Parameters, TeleopAndGuideRefuseImpossibleTimes) {
  expectTimeOrZero("preparation_limit", [](auto time) { Teleop({.preparation_limit = time}); });
  expectTimeOrZero("preparation_limit", [](auto time) { KnotGuide({.preparation_limit = time}); });
}

TEST(Parameters, TrackerRefusesImpossibleAges) {
  expectAge("max_age", [](auto time) { KnotTracker({.max_age = time}); });
}

TEST(Parameters, EndoscopeBoundsItsLatency) {
  const auto endoscope = [](auto time) { SyntheticEndoscope({.latency = time}); };
  expectRefused("latency", {-1ms, 501ms, 30s}, endoscope);
  expectAccepted({0s, 100us, 500ms}, endoscope);
}

TEST(Parameters, OperatorRefusesImpossibleAges) {
  expectAge("picture_age", [](auto time) { Operator({.picture_age = time}); });
  expectAge("slave_age", [](auto time) { Operator({.slave_age = time}); });
}

TEST(Parameters, KeyboardAndGamepadRefuseImpossibleTimes) {
  const PseudoTerminal pty;
  const auto keyboard = [&](auto time) { Keyboard({.terminal = pty.path(), .hold = time}); };
  expectRefused("hold", {-1s, 0s, 3s}, keyboard);
  expectAccepted({1ms, 2s}, keyboard);
  expectTime("retry", [](auto time) { Gamepad({.retry = time}); });
}

TEST(Parameters, ScriptedPedalsRefuseImpossibleTimes) {
  expectTime("clutch_for", [](auto time) { ScriptedPedals({.clutch_for = time}); });
  expectTime("leave_for", [](auto time) { ScriptedPedals({.leave_for = time}); });
  expectTimeOrZero("clutch_after", [](auto time) { ScriptedPedals({.clutch_after = time}); });
  expectTimeOrZero("leave_after", [](auto time) { ScriptedPedals({.leave_after = time}); });
}

TEST(Parameters, DrivesBoundTheirPermit) {
  const auto psm = [](auto time) { PsmDrives({.permit = time}); };
  const auto mtm = [](auto time) { MtmDrives({.permit = time}); };
  expectRefused("permit", {-1s, 500us, 1001ms}, psm);
  expectRefused("permit", {-1s, 500us, 1001ms}, mtm);
  expectAccepted({0s, 1ms, 30ms, 1s}, psm);
  EXPECT_EQ(suture::refusal([&] { psm(2s); }),
            "a time \"permit\" of 2 s: it may be from 0.001 s to 1 s long. Set it to so many "
            "seconds, e.g. 0.25");
}

/// One goal that the horizon lets through must not put the arm in FAULT.
TEST(Parameters, ArmsLeaveRoomForAServoGoal) {
  const auto psm = [](const PsmParameters& parameters) {
    return suture::refusal([&] { Psm{parameters}; });
  };
  const auto mtm = [](const MtmParameters& parameters) {
    return suture::refusal([&] { Mtm{parameters}; });
  };
  EXPECT_EQ(psm({}) + mtm({}), "");
  EXPECT_EQ(psm({.angular_rate = 10}),
            "an arm whose joint \"yaw\" moves as far as it can in a \"servo_horizon\" of 0.100000 "
            "s: that is 1.000000, and the arm is in FAULT if the joint trails by 0.800000. Lower "
            "\"servo_horizon\" or the joint's rate, or raise its following error");
  EXPECT_NE(psm({.servo_horizon = 0.3}), "");
  EXPECT_NE(psm({.insertion_rate = 1}).find("\"insertion\""), std::string::npos);
  EXPECT_NE(mtm({.angular_rate = 8}), "") << "it trails by more than it is sent ahead";
  EXPECT_EQ(psm({.angular_rate = 10, .following_error = 1.2}), "");
  EXPECT_EQ(mtm({.angular_rate = 10, .servo_horizon = 0.05}), "");
}

}  // namespace
}  // namespace robots::test
