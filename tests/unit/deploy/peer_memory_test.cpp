// A deployment file says how much memory the connections of peers may take in a process.

#include <gtest/gtest.h>
#include <suture/deploy/document/deployment.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/names/security.h>

#include <cstddef>
#include <list>
#include <string>

#include "host_scene.h"
#include "sound_deployment.h"
#include "support/contains.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace suture::sound {
namespace {

constexpr std::size_t kMebibyte = std::size_t{1} << 20;

/// Returns a deployment of a process with that memory.
std::string withMemory(const std::string& memory) {
  return with("\"name\": \"left\",", "\"name\": \"left\", \"peer_memory\": " + memory + ",");
}

framing::PeerBudget::Limits memoryOf(const std::string& text) {
  return Deployment(JsonDocument::parse(text, "d.json")).process("left").peerMemory;
}

TEST(PeerMemory, IsReadInMebibytes) {
  const auto both = memoryOf(withMemory(R"({"of_one": 8, "of_all": 32})"));
  EXPECT_EQ(both.peer, 8 * kMebibyte);
  EXPECT_EQ(both.process, 32 * kMebibyte);
  const auto ofAll = memoryOf(withMemory(R"({"of_all": 32})"));
  EXPECT_EQ(ofAll.peer, 32 * kMebibyte) << "one has no more than all";
  EXPECT_EQ(ofAll.process, 32 * kMebibyte);
}

TEST(PeerMemory, IsTheUsualOneWithoutTheKey) {
  for (const std::string& text : {std::string(kSound), withMemory("{}")}) {
    EXPECT_EQ(memoryOf(text).peer, Security::kConnectionMemory.peer);
    EXPECT_EQ(memoryOf(text).process, Security::kConnectionMemory.process);
  }
}

TEST(PeerMemory, OneMayTakeNoMoreThanAll) {
  expectOnly(withMemory(R"({"of_one": 64, "of_all": 32})"),
             "d.json:5: error: one peer may take 64 MiB for its connections, and all together only "
             "32 MiB; let \"of_one\" be at most \"of_all\"");
}

TEST(PeerMemory, NoMemoryIsZero) {
  EXPECT_EQ(problemsOf(withMemory(R"({"of_one": 0})")).size(), 1u);
  EXPECT_EQ(problemsOf(withMemory(R"({"of_all": 1048577})")).size(), 1u);
}

TEST(PeerMemory, BoundsTheConnectionsOfAPeer) {
  const TemporaryDirectory directory;
  loop::ControlThread control;
  const GlobalManager names(control, "unix:" + directory.file("m.sock"));
  const Deployment deployment(JsonDocument::parse(
      "{\"manager\": \"" + names.address() + "\"," + R"("processes": [{"name": "robot",
          "peer_memory": {"of_one": 1},
          "components": [{"name": "PSM", "class": "SimulatedArm"}]}]})",
      "d.json"));
  Host robot(deployment, "robot", test::kClasses);
  robot.start();
  std::list<test::Client> clients;
  Manager console("console", names.address());
  const std::string refused = refusal([&] {
    for (int i = 0; i < 100; ++i) {
      const std::string name = "Client" + std::to_string(i);
      console.add(name, clients.emplace_back());
      console.connect(name + "/Arm", "robot:PSM/Arm");
    }
  });
  EXPECT_TRUE(contains(refused, "bytes, and of the 1048576 for the connections of user "))
      << refused;
  console.stop();
}

}  // namespace
}  // namespace suture::sound
