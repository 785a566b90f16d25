#include <gtest/gtest.h>
#include <suture/transport/shm/memory_layout.h>

#include <string>

#include "reference/arm_like.suture.h"

namespace suture::shm {
namespace {

const char* const kDescription = R"({"name": "Arm", "doc": "An arm.", "structs": [
    {"name": "Pose", "fields": [{"name": "x", "doc": "m"}, {"name": "y"}]}]})";

InterfaceInfo infoWith(const char* description) {
  InterfaceInfo info = interfaceInfo<reference::ArmLike>();
  info.description = description;
  return info;
}

TEST(MemoryLayout, IsThatOfTheBytesAndNotOfTheWords) {
  const std::string layout = memoryLayout(infoWith(kDescription));
  EXPECT_EQ(memoryLayout(infoWith(kDescription)), layout);
  EXPECT_EQ(memoryLayout(infoWith(R"({"name": "Arm", "doc": "It moves.", "structs": [
      {"name": "Pose", "fields": [{"name": "x"}, {"name": "y", "doc": "up"}]}]})")),
            layout);
  EXPECT_NE(memoryLayout(infoWith(R"({"name": "Arm", "structs": [
      {"name": "Pose", "fields": [{"name": "y"}, {"name": "x"}]}]})")),
            layout);
}

TEST(MemoryLayout, IsThatOfTheTablesToo) {
  InterfaceInfo info = infoWith(kDescription);
  const std::string layout = memoryLayout(info);
  std::vector<CommandInfo> commands(info.commands.begin(), info.commands.end());
  commands[0].depth += 1;
  info.commands = commands;
  EXPECT_NE(memoryLayout(info), layout);
}

TEST(MemoryLayout, WhatHasNoBoundIsNotShared) {
  InterfaceInfo info = infoWith(kDescription);
  EXPECT_EQ(whyNotShared(info), "");
  std::vector<CommandInfo> commands(info.commands.begin(), info.commands.end());
  commands[1].sharedArguments = true;
  info.commands = commands;
  EXPECT_EQ(whyNotShared(info), "command 'servo_jp' has values without a bound");
}

}  // namespace
}  // namespace suture::shm
