#include <gtest/gtest.h>
#include <suture/wiring/compatibility.h>

#include <nlohmann/json.hpp>
#include <string>

namespace suture {
namespace {

using Json = nlohmann::json;
using Lines = std::vector<std::string>;
using Numbers = std::vector<std::uint16_t>;

/// Returns a contract with a write, a read and an event, as suturec describes it.
Json contract() {
  return Json::parse(R"json({
    "name": "robots::Arm",
    "commands": [{"name": "servo_cp", "ordinal": 1}, {"name": "mode", "ordinal": 2}],
    "events": [{"name": "moved", "ordinal": 1}],
    "wire": [
      {"id": "@0xa1", "kind": "interface", "name": "Arm", "members": [
        {"at": 1, "name": "servoCp", "is": "kind \"write\"",
         "parameters": [{"at": 0, "name": "goal", "is": "@0xb2"}]},
        {"at": 2, "name": "mode", "is": "kind \"read\"",
         "results": [{"at": 0, "name": "value", "is": "@0xc3"}]}]},
      {"id": "@0xb2", "kind": "struct", "name": "Pose", "members": [
        {"at": 0, "name": "x", "is": "Float64 unit \"m\""},
        {"at": 1, "name": "count", "is": "Int32 = 7"}]},
      {"id": "@0xc3", "kind": "enum", "name": "Mode", "members": [
        {"at": 0, "name": "off"}, {"at": 1, "name": "on"}]}]
  })json");
}

Compatibility compare(const Json& here, const Json& there) {
  return compatibility(here.dump(), there.dump());
}

/// Expects that each end is told of the breaks as it sees them.
void expectBreak(const Json& changed, const Lines& here, const Lines& there) {
  EXPECT_EQ(compare(contract(), changed).breaks, here);
  EXPECT_EQ(compare(changed, contract()).breaks, there);
}

TEST(Compatibility, EqualContractsMatch) {
  const Compatibility found = compare(contract(), contract());
  EXPECT_EQ(found.breaks, Lines{});
  EXPECT_EQ(found.lacking, Numbers{});
}

TEST(Compatibility, ExtraMembersAtTheEndAreFine) {
  Json newer = contract();
  newer["commands"].push_back({{"name", "clear"}, {"ordinal", 3}});
  newer["events"].push_back({{"name", "stopped"}, {"ordinal", 2}});
  newer["wire"][0]["members"].push_back({{"at", 3}, {"name", "clear"}, {"is", "kind \"void\""}});
  newer["wire"][0]["members"][0]["parameters"].push_back(
      {{"at", 2}, {"name", "now"}, {"is", "Bool"}});
  newer["wire"][1]["members"].push_back({{"at", 2}, {"name", "weight"}, {"is", "Float64 = 2.5"}});
  newer["wire"][2]["members"].push_back({{"at", 2}, {"name", "fast"}});
  newer["wire"].push_back({{"id", "@0xd4"}, {"kind", "struct"}, {"name", "Twist"}});
  expectBreak(newer, {}, {});
  EXPECT_EQ(compare(contract(), newer).lacking, Numbers{});
  EXPECT_EQ(compare(newer, contract()).lacking, Numbers{2});
}

TEST(Compatibility, NamesDoNotTravel) {
  Json renamed = contract();
  renamed["name"] = "robots::Manipulator";
  renamed["wire"][0]["name"] = "Manipulator";
  renamed["wire"][1]["name"] = "Position";
  renamed["wire"][1]["members"][0]["name"] = "east";
  expectBreak(renamed, {}, {});
}

TEST(Compatibility, TypesUnitsAndDefaultsMustAgree) {
  Json changed = contract();
  changed["wire"][1]["members"][0]["is"] = "Float64 unit \"mm\"";
  changed["wire"][1]["members"][1]["is"] = "Int32";
  changed["wire"][0]["members"][1]["results"][0]["is"] = "Float64";
  expectBreak(changed,
              {"'value' of 'mode' of interface Arm: @0xc3 required, Float64 provided",
               "'x' of struct Pose: Float64 unit \"m\" required, Float64 unit \"mm\" provided",
               "'count' of struct Pose: Int32 = 7 required, Int32 provided"},
              {"'value' of 'mode' of interface Arm: Float64 required, @0xc3 provided",
               "'x' of struct Pose: Float64 unit \"mm\" required, Float64 unit \"m\" provided",
               "'count' of struct Pose: Int32 required, Int32 = 7 provided"});
}

TEST(Compatibility, KindsAndMajorVersionsMustAgree) {
  Json changed = contract();
  changed["wire"][0]["major"] = 2;
  changed["wire"][1]["kind"] = "union";
  expectBreak(changed,
              {"interface Arm: major 1 required, 2 provided", "struct Pose: union provided"},
              {"interface Arm: major 2 required, 1 provided", "union Pose: struct provided"});
}

TEST(Compatibility, VersionsOfAContractDoNotConnect) {
  Json changed = contract();
  changed["wire"][0]["version"] = 2;
  expectBreak(changed, {"interface Arm: version(1) required, version(2) provided"},
              {"interface Arm: version(2) required, version(1) provided"});
}

/// Returns the same contract, which derives from one with a command and an event.
Json derived() {
  Json json = contract();
  const Json send = {{"name", "send"}, {"ordinal", 1}, {"from", "suture::Messages"}};
  json["commands"].insert(json["commands"].begin(), send);
  json["wire"].push_back(
      {{"id", "@0xf6"},
       {"kind", "interface"},
       {"name", "Messages"},
       {"cxx", "suture::Messages"},
       {"members", Json::array({{{"at", 1}, {"name", "send"}, {"is", "kind \"void\""}}})}});
  return json;
}

TEST(Compatibility, ABasesLaterMemberMovesNothing) {
  Json grown = derived();
  const Json clear = {{"name", "clear"}, {"ordinal", 2}, {"from", "suture::Messages"}};
  const Json sent = {{"name", "sent"}, {"ordinal", 1}};
  grown["commands"].insert(grown["commands"].begin() + 1, clear);
  grown["events"].insert(grown["events"].begin(), sent);
  EXPECT_EQ(compare(derived(), grown).breaks, Lines{});
  EXPECT_EQ(compare(grown, derived()).breaks, Lines{});
  EXPECT_EQ(compare(derived(), grown).lacking, Numbers{});
  EXPECT_EQ(compare(grown, derived()).lacking, Numbers{1});
}

TEST(Compatibility, ABaseIsKnownByItsNumber) {
  Json renamed = derived();
  renamed["commands"][0]["from"] = "suture::Post";
  renamed["wire"].back()["cxx"] = "suture::Post";
  EXPECT_EQ(compare(derived(), renamed).lacking, Numbers{});
  EXPECT_EQ(compare(renamed, derived()).lacking, Numbers{});
}

TEST(Compatibility, AnotherContractIsABreak) {
  Json other = contract();
  other["name"] = "robots::Camera";
  other["wire"][0]["id"] = "@0xe5";
  expectBreak(other, {"contract: robots::Arm required, robots::Camera provided"},
              {"contract: robots::Camera required, robots::Arm provided"});
}

TEST(Compatibility, APeersNonsenseIsABreak) {
  const Lines nothing = {"description: it says nothing of the wire"};
  for (const std::string text :
       {"", "{", "[]", "7", "null", R"({"wire": 7})", R"({"wire": []})", R"({"wire": {"a": 1}})"}) {
    EXPECT_EQ(compatibility(contract().dump(), text).breaks, nothing) << text;
    EXPECT_EQ(compatibility(text, contract().dump()).breaks, nothing) << text;
  }
  EXPECT_FALSE(compatibility(contract().dump(), R"({"wire": [7]})").breaks.empty());
  EXPECT_FALSE(
      compatibility(contract().dump(),
                    R"({"wire": [{"id": "@0xa1", "members": [7, {"at": "x"}, {"at": 1e300}]}]})")
          .breaks.empty());
}

}  // namespace
}  // namespace suture
