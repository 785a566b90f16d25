// The code that is generated for every type of member carries it: C++ -> slot -> message -> slot ->
// C++.

#include <capnp/message.h>
#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/component/factory/json_reader.h>

#include <cmath>
#include <limits>
#include <memory>

#include "robots/arm.capnp.h"
#include "robots/arm.suture.h"
#include "robots/gripper.suture.h"
#include "robots/simulated_arm.suture.h"

namespace robots {

void toWire(const EverythingSlot& slot, wire::Everything::Builder out);
suture::Errc fromWire(wire::Everything::Reader in, EverythingSlot& slot, suture::Duration shift);
bool isValid(const EverythingSlot& slot, suture::FieldPath* path = nullptr);
wire::Mode wireMode(std::int8_t slot);

namespace {

using suture::Errc;

PoseStamped somePose() {
  PoseStamped pose;
  pose.pose = Eigen::Translation3d(1, -2, 3) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY());
  pose.stamp = suture::fromNanoseconds(12'345);
  pose.valid = true;
  return pose;
}

Everything something() {
  Everything value;
  value.on = true;
  value.tiny = -7;
  value.count = std::numeric_limits<std::uint64_t>::max();
  value.speed = 1.5;
  value.ratio = 0.125f;
  value.mode = Mode::HoldStill;
  value.label = "tool";
  value.bytes = {0, 255, 10};
  value.flags = {true, false, true};
  value.names = {"a", "", "shoulder"};
  value.pairs = {{1, 2}, {3, 4}};
  value.modes = {Mode::Disabled, Mode::Servo};
  value.goal = somePose();
  value.track = {somePose(), PoseStamped{}};
  value.point = {1, 2, 3};
  value.plane = {4, 5, 6};
  value.inertia << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  for (int i = 0; i < 42; ++i) value.jacobian(i % 6, i / 6) = 0.1 * i;
  value.attitude = Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5);
  value.period = std::chrono::milliseconds(20);
  value.when = suture::fromNanoseconds(99);
  return value;
}

void expectEqual(const PoseStamped& a, const PoseStamped& b) {
  EXPECT_EQ(a.pose.matrix(), b.pose.matrix());
  EXPECT_EQ(a.stamp, b.stamp);
  EXPECT_EQ(a.valid, b.valid);
}

void expectEqual(const Everything& a, const Everything& b) {
  EXPECT_EQ(a.on, b.on);
  EXPECT_EQ(a.tiny, b.tiny);
  EXPECT_EQ(a.count, b.count);
  EXPECT_EQ(a.speed, b.speed);
  EXPECT_EQ(a.ratio, b.ratio);
  EXPECT_EQ(a.mode, b.mode);
  EXPECT_EQ(a.label, b.label);
  EXPECT_EQ(a.bytes, b.bytes);
  EXPECT_EQ(a.flags, b.flags);
  EXPECT_EQ(a.names, b.names);
  EXPECT_EQ(a.pairs, b.pairs);
  EXPECT_EQ(a.modes, b.modes);
  expectEqual(a.goal, b.goal);
  ASSERT_EQ(a.track.size(), b.track.size());
  for (std::size_t i = 0; i < a.track.size(); ++i) expectEqual(a.track[i], b.track[i]);
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.plane, b.plane);
  EXPECT_EQ(a.inertia, b.inertia);
  EXPECT_EQ(a.jacobian, b.jacobian);
  EXPECT_EQ(a.attitude.coeffs(), b.attitude.coeffs());
  EXPECT_EQ(a.period, b.period);
  EXPECT_EQ(a.when, b.when);
}

struct RoundTrip : testing::Test {
  Errc back(EverythingSlot& slot, suture::Duration shift = {}) {
    return fromWire(message->getRoot<wire::Everything>().asReader(), slot, shift);
  }
  wire::Everything::Builder sent(const Everything& value) {
    EverythingSlot slot{};
    EXPECT_TRUE(store(value, slot));
    auto out = message->initRoot<wire::Everything>();
    toWire(slot, out);
    return out;
  }

  std::unique_ptr<capnp::MallocMessageBuilder> message =
      std::make_unique<capnp::MallocMessageBuilder>();  // its destructor may throw
};

TEST_F(RoundTrip, EveryMemberArrives) {
  sent(something());
  EverythingSlot slot{};
  ASSERT_EQ(back(slot), Errc{});
  EXPECT_TRUE(isValid(slot));
  Everything received;
  load(slot, received);
  expectEqual(received, something());
}

TEST_F(RoundTrip, SteadyStampsAreShiftedUnlessUnset) {
  Everything value = something();
  value.goal.stamp = {};
  sent(value);
  EverythingSlot slot{};
  ASSERT_EQ(back(slot, suture::Duration(1000)), Errc{});
  EXPECT_EQ(slot.when, 1099);
  EXPECT_EQ(slot.track.data[0].stamp, 13'345);
  EXPECT_EQ(slot.goal.stamp, 0);
}

TEST_F(RoundTrip, ATooLargeTypeHasNoSlot) {
  Everything value = something();
  value.label = "longer than sixteen bytes";
  EverythingSlot slot{};
  EXPECT_FALSE(store(value, slot));
}

TEST_F(RoundTrip, ATooLargeMessageIsRefused) {
  sent(something()).setLabel("longer than sixteen bytes");
  EverythingSlot slot{};
  EXPECT_EQ(back(slot), Errc::TooLarge);
}

// A sender that is older than the member sends such a message.
TEST_F(RoundTrip, AMissingStructHasItsDefaults) {
  sent(something()).disownGoal();
  EverythingSlot slot{};
  EXPECT_EQ(back(slot), Errc{});
  Everything received = something();
  load(slot, received);
  EXPECT_TRUE(received.goal.pose.isApprox(PoseStamped().pose));
  EXPECT_EQ(received.goal.valid, PoseStamped().valid);
}

TEST_F(RoundTrip, AListOfWrongLengthIsRefused) {
  sent(something()).initJacobian(41);
  EverythingSlot slot{};
  EXPECT_EQ(back(slot), Errc::Invalid);
}

TEST_F(RoundTrip, AnUnknownEnumeratorIsRefused) {
  sent(something()).setMode(static_cast<wire::Mode>(17));
  EverythingSlot slot{};
  EXPECT_EQ(back(slot), Errc::Invalid);
}

TEST_F(RoundTrip, InvalidNumbersAreToldByTheirPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [this](auto change) {
    Everything value = something();
    change(value);
    sent(value);
    EverythingSlot slot{};
    EXPECT_EQ(back(slot), Errc{});
    suture::FieldPath path;
    const bool valid = isValid(slot, &path);
    EXPECT_EQ(valid, path.empty());
    return std::string(path.text());
  };
  EXPECT_EQ(refused([](Everything&) {}), "");
  EXPECT_EQ(refused([](Everything& value) { value.speed = 2.5; }), "speed") << "outside its range";
  EXPECT_EQ(refused([&](Everything& value) { value.speed = nan; }), "speed");
  EXPECT_EQ(refused([&](Everything& value) { value.pairs[1][0] = nan; }), "pairs[1][0]");
  EXPECT_EQ(refused([&](Everything& value) { value.track[0].pose(0, 3) = nan; }), "track[0].pose");
  EXPECT_EQ(refused([&](Everything& value) { value.plane.x() = static_cast<float>(nan); }),
            "plane[0]");
}

TEST_F(RoundTrip, EnumsTravelByOrdinalNotByValue) {
  EXPECT_EQ(wireMode(-1), wire::Mode::DISABLED);
  EXPECT_EQ(wireMode(4), wire::Mode::HOLD_STILL);
  EXPECT_EQ(static_cast<int>(wireMode(2)), 2);
}

TEST(Parameters, AreReadAndChecked) {
  const auto read = [](const char* text, ArmParameters& parameters) {
    std::vector<suture::JsonProblem> problems;
    fromJson(suture::JsonReader(nlohmann::json::parse(text), "", problems), parameters);
    return problems;
  };
  ArmParameters parameters;
  EXPECT_TRUE(read(R"({"rate": 500, "start": "Servo"})", parameters).empty());
  EXPECT_EQ(parameters.rate, 500);
  EXPECT_EQ(parameters.start, Mode::Servo);
  EXPECT_EQ(parameters.name, "") << "what is not mentioned keeps its default";

  EXPECT_EQ(read(R"({"rate": 0})", parameters).at(0).pointer, "/rate");
  EXPECT_EQ(read(R"({"start": "Serov"})", parameters).at(0).pointer, "/start");
  EXPECT_EQ(read(R"({"naem": "x"})", parameters).size(), 1u);
}

TEST(Contract, ValuesKeepTheirPlacesInASlot) {
  ArmMovedPayload payload;
  ASSERT_TRUE(store(somePose(), 0.5, Mode::Servo, payload));
  PoseStamped pose;
  double speed = 0;
  Mode mode{};
  load(payload, pose, speed, mode);
  expectEqual(pose, somePose());
  EXPECT_EQ(speed, 0.5);
  EXPECT_EQ(mode, Mode::Servo);
  ArmGraspArguments arguments;
  ASSERT_TRUE(store(0.02, Mode::Disabled, arguments));
  EXPECT_EQ(arguments.width, 0.02);
  EXPECT_EQ(arguments.mode, -1);
}

TEST(Contract, ADerivedOneBeginsWithItsBase) {
  const suture::InterfaceInfo& base = suture::interfaceInfo<Arm>();
  const suture::InterfaceInfo& derived = suture::interfaceInfo<Gripper>();
  ASSERT_NE(derived.base, nullptr);
  EXPECT_EQ(&derived.base(), &base);
  ASSERT_GT(derived.commands.size(), base.commands.size());
  for (std::size_t i = 0; i < base.commands.size(); ++i) {
    EXPECT_STREQ(derived.commands[i].name, base.commands[i].name);
    EXPECT_EQ(derived.commands[i].column, base.commands[i].column);
  }
  for (std::size_t i = 0; i < base.events.size(); ++i) {
    EXPECT_STREQ(derived.events[i].name, base.events[i].name);
  }
  EXPECT_EQ(base.commands[7].deadline, std::chrono::milliseconds(50));
  EXPECT_EQ(base.commands[6].deadline, suture::kDefaultDeadline);
}

TEST(Parameters, ComponentsAreCreatedByClass) {
  std::vector<suture::JsonProblem> problems;
  const nlohmann::json json = {{"rate", 500}};
  const suture::ComponentClass type = suture::componentClass<SimulatedArm>();
  EXPECT_STREQ(type.name, "SimulatedArm");
  const auto component = type.create(suture::JsonReader(json, "", problems));
  ASSERT_NE(component, nullptr);
  EXPECT_EQ(component->provided().at(0)->name(), "Arm");
  EXPECT_EQ(component->provided().at(0)->info().commands.size(), 11u);
}

}  // namespace
}  // namespace robots
