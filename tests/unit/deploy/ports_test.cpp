// These see the ports that a deployment file gives to processes.

#include <gtest/gtest.h>
#include <suture/deploy/document/deployment.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/names/security.h>

#include "host_scene.h"
#include "sound_deployment.h"
#include "support/contains.h"
#include "support/refusal.h"

namespace suture::sound {
namespace {

/// Returns a deployment of two processes with these ports.
std::string withPorts(const std::string& manager, const std::string& left,
                      const std::string& right) {
  return "{\"manager\": \"" + manager + "\", \"keys\": \"keys\", \"processes\": [\n" +
         "{\"name\": \"left\", \"components\": [], \"port\": " + left + "},\n" +
         "{\"name\": \"right\", \"components\": [], \"port\": " + right + "}]}";
}

TEST(Ports, APortIsRead) {
  const Deployment deployment(
      JsonDocument::parse(withPorts("tls://10.0.0.1:7700", "4101", "65535"), "d.json"));
  EXPECT_EQ(deployment.process("left").port, 4101);
  EXPECT_EQ(deployment.process("right").port, 65535);
  EXPECT_EQ(Deployment(JsonDocument::parse(kSound, "d.json")).process("left").port, 0);
}

TEST(Ports, NoPortIsZeroOrTooLarge) {
  for (const char* const port : {"0", "-1", "65536", "1.5", "\"4101\""}) {
    const auto problems = problemsOf(withPorts("tls://10.0.0.1:7700", port, "4102"));
    ASSERT_EQ(problems.size(), 1u) << port;
    EXPECT_TRUE(contains(problems[0], "d.json:2: error: ")) << problems[0];
    EXPECT_TRUE(contains(problems[0], "the port at which other processes reach this one"))
        << problems[0];
  }
}

TEST(Ports, AUnixSocketHasNone) {
  const auto problems = problemsOf(withPorts("unix:/run/m.sock", "4101", "4102"));
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[1],
            "d.json:3: error: give process 'right' port 4102: the global manager is at "
            "unix:/run/m.sock, where a process listens at a file and has no port. Leave the port "
            "out, or give the manager a tls:// address.");
}

TEST(Ports, WithoutAManagerNobodyLooksForIt) {
  expectOnly(
      "{\"processes\": [\n{\"name\": \"one\", \"components\": [], \"port\": 4101}]}",
      "d.json:2: error: give process 'one' port 4101: key 'manager' is missing, so no other "
      "process looks for it. Give its address, for example \"tls://10.0.0.1:7700\", or leave the "
      "port out");
}

TEST(Ports, TwoOfOneMachineHaveTwo) {
  for (const std::string manager :
       {"tcp://127.0.0.1:7700", "tls://localhost:7700", "tls://[::1]:7"}) {
    const auto problems = problemsOf(withPorts(manager, "4101", "4101"));
    ASSERT_EQ(problems.size(), 1u) << manager;
    EXPECT_TRUE(contains(problems[0],
                         "d.json:3: error: give process 'right' port 4101: process "
                         "'left' has that port, on line 2, and one machine runs both"))
        << problems[0];
    EXPECT_EQ(problemsOf(withPorts(manager, "4101", "4102")).size(), 0u) << manager;
  }
}

TEST(Ports, TwoMachinesMayHaveTheSame) {
  EXPECT_EQ(problemsOf(withPorts("tls://10.0.0.1:7700", "4101", "4101")).size(), 0u);
}

/// Returns the port of "tcp://127.0.0.1:4101".
std::string portOf(const std::string& address) { return address.substr(address.rfind(':') + 1); }

TEST(Ports, ATakenPortNamesItsProcess) {
  loop::ControlThread control;
  const GlobalManager manager(control, "tcp://127.0.0.1:0");
  const std::string& address = manager.address();
  const std::string port = portOf(address);  // the manager has it
  const Deployment deployment(JsonDocument::parse(
      "{\"manager\": \"" + address + "\",\n\"processes\": [{\"name\": \"arm\", " +
          "\"components\": [],\n\"port\": " + port + "}]}",
      "d.json"));
  const std::string told = refusal([&] { const Host host(deployment, "arm", test::kClasses); });
  EXPECT_EQ(told, "d.json:3: error: give process 'arm' port " + port + ": listen at " + address +
                      ": another process listens there. Stop it, or choose another address: "
                      "--listen of a manager, the port of a process.");
}

TEST(Ports, AProcessByUnixHasNone) {
  const std::string told =
      refusal([] { const Manager arm("arm", "unix:/tmp/m.sock", Security{}, Duration{0}, 4101); });
  EXPECT_EQ(told,
            "give process 'arm' port 4101: the global manager is at unix:/tmp/m.sock, where a "
            "process listens at a file and has no port. Leave the port out, or give the manager a "
            "tls:// address.");
}

}  // namespace
}  // namespace suture::sound
