#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/wiring/compatibility.h>
#include <suture/wiring/connect.h>
#include <suture/wiring/differences.h>
#include <suture/wiring/directory.h>
#include <suture/wiring/optional_commands.h>

#include <algorithm>

#include "reference/gripper_arm.suture.h"
#include "reference/simulated_arm.h"
#include "support/refusal.h"

namespace suture {
namespace {

TEST(Endpoint, ReadsBothForms) {
  const Endpoint far = Endpoint::parse("left:PSM1/Arm"), near = Endpoint::parse("PSM1/Arm");
  EXPECT_EQ(far.process, "left");
  EXPECT_EQ(far.component, "PSM1");
  EXPECT_EQ(far.interface, "Arm");
  EXPECT_EQ(near.process, "");
  EXPECT_EQ(far.toString(), "left:PSM1/Arm");
  EXPECT_EQ(near.toString(), "PSM1/Arm");
}

TEST(Endpoint, RefusesOtherForms) {
  for (const char* text : {"", "PSM1", "/Arm", "PSM1/", "left:", ":PSM1/Arm", "left:/Arm"}) {
    EXPECT_NE(refusal([&] { Endpoint::parse(text); }).find("not of the form"), std::string::npos)
        << text;
  }
}

class Wired : public testing::Test {
 protected:
  Wired() {
    directory_.add("PSM1", arm_, [] {});
    directory_.add("Console", client_, [] {});
  }

  struct Client final : Device {
    Required<reference::ArmLike> slave{*this, "Slave"};
  };
  reference::SimulatedArm arm_{{}};
  Client client_;
  Directory directory_{"left"};
};

TEST_F(Wired, AMissingComponentsNearestIsNamed) {
  EXPECT_EQ(refusal([&] { directory_.provided(Endpoint::parse("PSM2/Arm")); }),
            "asked for 'PSM2/Arm': process 'left' has components 'Console' and 'PSM1'. "
            "Did you mean 'PSM1'?");
}

TEST_F(Wired, AMissingInterfacesNearestIsNamed) {
  EXPECT_EQ(refusal([&] { directory_.provided(Endpoint::parse("PSM1/Arn")); }),
            "asked for the provided interface 'PSM1/Arn': component 'PSM1' has provided interfaces "
            "'Arm'. Did you mean 'Arm'?");
  EXPECT_EQ(
      refusal([&] { directory_.required(Endpoint::parse("PSM1/Arm")); }),
      "asked for the required interface 'PSM1/Arm': component 'PSM1' has no required "
      "interfaces. It stands at the wrong end: a connection goes from a required interface to a "
      "provided one");
  EXPECT_EQ(refusal([&] { directory_.required(Endpoint::parse("PSM1/Slave")); }),
            "asked for the required interface 'PSM1/Slave': component 'PSM1' has no required "
            "interfaces. Look whether another was meant");
  EXPECT_EQ(refusal([] { Directory("empty").required(Endpoint::parse("PSM1/Arm")); }),
            "asked for 'PSM1/Arm': process 'empty' has no components. Look whether another was "
            "meant");
}

TEST_F(Wired, ANameIsTakenOnce) {
  EXPECT_NE(refusal([&] { directory_.add("PSM1", arm_, [] {}); }).find("it has one of that name"),
            std::string::npos);
}

TEST_F(Wired, AnImpossibleNameIsRefused) {
  reference::SimulatedArm other{{}};
  for (const char* const name : {"", "left:PSM2", "PSM2/Arm", "PSM2 -> PSM3", "PSM\n2"}) {
    EXPECT_EQ(refusal([&] { directory_.add(name, other, [] {}); }),
              "adding a component '" + std::string(name) +
                  "' to process 'left': no endpoint 'process:component/interface' could name it. "
                  "Choose a name without ':', '/', '->' and control characters");
  }
}

struct NamedInterfaces final : Device {
  NamedInterfaces(const std::string& first, const std::string& second)
      : provided(*this, first, arm), required(*this, first), another(*this, second) {}

  reference::SimulatedArm arm{{}};
  Provided<reference::ArmLike> provided;
  Required<reference::ArmLike> required, another;
};

TEST_F(Wired, AnImpossibleInterfaceNameIsRefused) {
  for (const char* const name : {"", "a/b:c", "a -> b", "a\n"}) {
    NamedInterfaces component(name, "Slave");
    EXPECT_EQ(refusal([&] { directory_.add("Left", component, [] {}); }),
              "adding a component 'Left' to process 'left': no endpoint "
              "'process:component/interface' could name its interface '" +
                  std::string(name) +
                  "'. Choose a name without ':', '/', '->' and control characters");
  }
}

TEST_F(Wired, TwoInterfacesNeedTwoNames) {
  NamedInterfaces component("Arm", "Arm"), bridge("Arm", "Slave");
  EXPECT_EQ(refusal([&] { directory_.add("Left", component, [] {}); }),
            "adding a component 'Left' to process 'left': two of its required interfaces are "
            "called 'Arm'. Give each of them its own name");
  EXPECT_EQ(directory_.findComponent("Left"), nullptr);
  directory_.add("Left", bridge, [] {});  // both ends may have one
}

TEST_F(Wired, AComponentIsAddedOnce) {
  EXPECT_EQ(refusal([&] { directory_.add("PSM2", arm_, [] {}); }),
            "adding a component 'PSM2' to process 'left': the same object is there as 'PSM1'. "
            "Add each component once");
}

TEST(Differences, AreToldFieldByField) {
  const char* here = R"({"doc": "a", "commands": [
      {"name": "servo_cp", "kind": "write", "queue": 16}, {"name": "hold", "kind": "void"}]})";
  const char* there = R"({"doc": "b", "commands": [
      {"name": "home", "kind": "void"}, {"name": "servo_cp", "kind": "read", "queue": 16}]})";
  EXPECT_EQ(differences(here, there),
            (std::vector<std::string>{"commands.hold.kind: 'void' required, not provided",
                                      "commands.hold.name: 'hold' required, not provided",
                                      "commands.servo_cp.kind: 'write' required, 'read' provided",
                                      "commands.home.kind: not required, 'void' provided",
                                      "commands.home.name: not required, 'home' provided"}));
  EXPECT_TRUE(differences(here, here).empty());
}

bool isUnreadable(const std::string& description) {
  const std::string here = R"({"core": "hash", "name": "Arm", "wire": [{"id": "@0xa1"}]})";
  EXPECT_FALSE(lackingOptional(here, description));
  EXPECT_FALSE(compatibility(here, description).comparable);
  return differences(here, description) ==
         std::vector<std::string>{"name: 'Arm' required, not provided",
                                  "description: not required, unreadable provided"};
}

/// Returns a description whose commands are so many lists, one inside the other.
std::string nested(std::size_t levels) {
  return R"({"core": "hash", "commands": )" + std::string(levels, '[') + std::string(levels, ']') +
         "}";
}

// A peer's description is refused before any work on it that might take a whole stack or endless
// time.
TEST(Description, ATooDeepOneIsUnreadable) {
  for (const std::size_t levels : {32u, 100'000u, 500'000u}) {
    EXPECT_TRUE(isUnreadable(nested(levels))) << levels;
  }
  EXPECT_EQ(differences(nested(20), nested(31)), std::vector<std::string>{});
  const std::string inText =
      R"({"a": "\\\"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[", "b": []})";
  EXPECT_EQ(differences(inText, inText), std::vector<std::string>{});
  EXPECT_EQ(differences("{}", inText).size(), 1u);
}

TEST(Description, ATooLongOneIsUnreadable) {
  std::string there = R"({"core": "hash", "wire": [{"id": "@0xa1"})";
  while (there.size() <= (1u << 20)) there += R"(,{"id": "x"})";
  EXPECT_TRUE(isUnreadable(there + "]}"));
}

TEST(Description, ALongKeyIsNotRepeated) {
  std::string there = R"({")" + std::string(1000, 'k') + R"(": [1)";
  for (int i = 0; i < 100'000; ++i) there += ",[],1";
  there += "]}";
  std::size_t bytes = 0;
  const std::vector<std::string> lines = differences(R"({"name": "Arm"})", there);
  for (const std::string& line : lines) bytes += line.size();
  EXPECT_LT(bytes, 10u << 20);
  EXPECT_TRUE(
      std::ranges::count(lines, "description: not required, longer than can be told provided"));
}

/// Returns the info of a contract with this hash and description instead of suturec's.
InterfaceInfo described(const char* hash, const char* description) {
  InterfaceInfo info = interfaceInfo<reference::ArmLike>();
  info.hash = hash;
  info.description = description;
  return info;
}

TEST(Contract, ADifferentOneIsRefused) {
  const InterfaceInfo info = described("hash", R"({"name": "reference::ArmLike"})");
  const InterfaceInfo other = described("another hash", R"({"name": "other"})");
  const std::string error =
      refusal([&] { requireSameContract(info, other, "a:C/Slave -> b:P/Arm"); });
  EXPECT_NE(error.find("connecting a:C/Slave -> b:P/Arm"), std::string::npos) << error;
  EXPECT_NE(error.find("'reference::ArmLike' required, 'other' provided"), std::string::npos)
      << error;
  EXPECT_NE(error.find("Build both sides from the same header"), std::string::npos) << error;
}

TEST(Contract, AnErrorNamesThreeDifferences) {
  const InterfaceInfo info = described("hash", R"({"name": "reference::ArmLike"})");
  const InterfaceInfo other =
      described("another hash", R"({"name": "other", "a": 1, "b": 2, "c": 3, "d": 4})");
  EXPECT_EQ(refusal([&] { requireSameContract(info, other, "a:C/Slave -> b:P/Arm"); }),
            "connecting a:C/Slave -> b:P/Arm: both are called reference::ArmLike, and "
            "differ. Build both sides from the same header:\n"
            "    name: 'reference::ArmLike' required, 'other' provided\n"
            "    a: not required, 1 provided\n"
            "    b: not required, 2 provided\n"
            "    and 2 more: see `suture why`");
}

TEST(Contract, AnExtendedOneIsAccepted) {
  const InterfaceInfo& base = interfaceInfo<reference::ArmLike>();
  const InterfaceInfo& derived = interfaceInfo<reference::GripperArm>();
  EXPECT_EQ(requireSameContract(base, derived, "a -> b").contract, &base);
  EXPECT_NE(refusal([&] { requireSameContract(derived, base, "a -> b"); }), "");
}

std::string contract(const char* hash, const std::string& commands) {
  return std::string(R"({"core": "same", "hash": ")") + hash + R"(", "commands": [)" + commands +
         "]}";
}

constexpr char kHold[] = R"({"name": "hold", "kind": "void", "doc": "one text"})";
constexpr char kHoldToo[] = R"({"name": "hold", "kind": "void", "doc": "another"})";
constexpr char kPark[] = R"({"name": "park", "kind": "void", "optional": true})";
constexpr char kHome[] = R"({"name": "home", "kind": "void"})";

using Numbers = std::vector<std::uint16_t>;

TEST(Contract, OptionalCommandsMayBeMissing) {
  const std::string two = contract("2", std::string(kHold) + "," + kPark);
  const std::string one = contract("1", kHoldToo);
  EXPECT_EQ(lackingOptional(two, one), Numbers{1});
  EXPECT_EQ(lackingOptional(one, two), Numbers{});
  EXPECT_EQ(lackingOptional(two, two), Numbers{});
}

TEST(Contract, NoOtherDifferenceIsAllowed) {
  const std::string hold = contract("1", kHold);
  EXPECT_EQ(lackingOptional(hold, contract("2", std::string(kHold) + "," + kHome)), std::nullopt);
  EXPECT_EQ(lackingOptional(hold, contract("2", std::string(kPark) + "," + kHold)), std::nullopt);
  EXPECT_EQ(lackingOptional(hold, R"({"core": "other", "commands": []})"), std::nullopt);
  EXPECT_EQ(lackingOptional(hold, R"({"core": 7, "commands": "x"})"), std::nullopt);
  EXPECT_EQ(lackingOptional(hold, "no JSON"), std::nullopt);
}

TEST(Contract, OtherNamesAreNotComparedInside) {
  InterfaceInfo other = described("another hash", R"({"name": "other", "a": 1})");
  other.name = "other";
  const InterfaceInfo info = described("hash", R"({"name": "reference::ArmLike"})");
  EXPECT_TRUE(contractDifferences(info, other).empty());
  EXPECT_TRUE(refusal([&] { requireSameContract(info, other, "a:C/Slave -> b:P/Arm"); })
                  .ends_with("it requires reference::ArmLike and is offered other. Connect "
                             "interfaces of the same contract"));
}

}  // namespace
}  // namespace suture
