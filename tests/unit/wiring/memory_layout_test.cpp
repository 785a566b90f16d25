#include <gtest/gtest.h>
#include <suture/component/contract/unbounded.h>
#include <suture/wiring/memory_layout.h>

#include <string>

#include "reference/arm_like.suture.h"

namespace suture {
namespace {

const char* const kDescription = R"({"name": "Arm", "doc": "An arm.", "structs": [
    {"name": "Pose", "fields": [{"name": "x", "doc": "m"}, {"name": "y"}]}]})";

InterfaceInfo infoWith(const char* description) {
  InterfaceInfo info = interfaceInfo<reference::ArmLike>();
  info.description = description;
  return info;
}

TEST(MemoryLayout, ChangesWithFieldsButNotWithComments) {
  const std::string layout = memoryLayout(infoWith(kDescription));
  EXPECT_EQ(memoryLayout(infoWith(kDescription)), layout);
  EXPECT_EQ(memoryLayout(infoWith(R"({"name": "Arm", "doc": "It moves.", "structs": [
      {"name": "Pose", "fields": [{"name": "x"}, {"name": "y", "doc": "up"}]}]})")),
            layout);
  EXPECT_NE(memoryLayout(infoWith(R"({"name": "Arm", "structs": [
      {"name": "Pose", "fields": [{"name": "y"}, {"name": "x"}]}]})")),
            layout);
}

TEST(MemoryLayout, ChangesWithTheDepthOfAQueue) {
  InterfaceInfo info = infoWith(kDescription);
  const std::string layout = memoryLayout(info);
  std::vector<CommandInfo> commands(info.commands.begin(), info.commands.end());
  commands[0].depth += 1;
  info.commands = commands;
  EXPECT_NE(memoryLayout(info), layout);
}

// A process that sends all of a value is not understood by one that takes its used part, and the
// other way round.
TEST(MemoryLayout, ChangesWithTheLevelsOfAValue) {
  constexpr BoundedLevel kList[] = {{.size = 0, .data = 8, .stride = 8, .capacity = 100}};
  InterfaceInfo info = infoWith(kDescription);
  const std::string layout = memoryLayout(info);
  for (BoundedLevels CommandInfo::*const one :
       {&CommandInfo::argumentsLevels, &CommandInfo::resultLevels}) {
    std::vector<CommandInfo> commands(info.commands.begin(), info.commands.end());
    commands[0].*one = kList;
    InterfaceInfo other = infoWith(kDescription);
    other.commands = commands;
    EXPECT_NE(memoryLayout(other), layout);
  }
  std::vector<EventInfo> events(info.events.begin(), info.events.end());
  ASSERT_FALSE(events.empty());
  events[0].payloadLevels = kList;
  info.events = events;
  EXPECT_NE(memoryLayout(info), layout);
}

TEST(Unbounded, ACommandWithoutABoundIsNamed) {
  InterfaceInfo info = infoWith(kDescription);
  EXPECT_EQ(whyUnbounded(info), "");
  std::vector<CommandInfo> commands(info.commands.begin(), info.commands.end());
  commands[1].sharedArguments = true;
  info.commands = commands;
  EXPECT_EQ(whyUnbounded(info), "command 'servo_jp' has values without a bound");
}

TEST(MemoryLayout, AnotherBuildsLayoutIsToldApart) {
  const InterfaceInfo info = infoWith(kDescription);
  EXPECT_EQ(whyOtherSlots(info, memoryLayout(info)), "");
  EXPECT_EQ(whyOtherSlots(info, "another"),
            "the two were built from different versions of the contract, or lay out its values "
            "differently");
}

/// Tells if the description has stamps that the tables of its contract, which are empty, do not
/// shift.
bool hidesStampsWith(const char* description) {
  InterfaceInfo info = infoWith(description);
  info.commands = {};
  info.events = {};
  return hidesStamps(info);
}

TEST(Stamps, TheDescriptionShowsSteadyStamps) {
  EXPECT_FALSE(hidesStampsWith(R"({"commands": [{"type": {"kind": "Int32"}}]})"));
  EXPECT_FALSE(hidesStampsWith(R"({"commands": [], "structs": [{"clock": "system"}]})"));
  EXPECT_TRUE(hidesStampsWith(R"({"commands": [], "structs": [{"clock": "steady"}]})"));
}

TEST(Stamps, AreVisibleToAShiftingTable) {
  InterfaceInfo info = infoWith(R"({"commands": [], "structs": [{"clock": "steady"}]})");
  std::vector<CommandInfo> commands(info.commands.begin(), info.commands.end());
  commands[0].shiftArguments = [](std::byte*, Duration) {};
  info.commands = commands;
  EXPECT_FALSE(hidesStamps(info));
}

TEST(Stamps, AreAssumedInUndescribedTypes) { EXPECT_TRUE(hidesStampsWith(kDescription)); }

}  // namespace
}  // namespace suture
