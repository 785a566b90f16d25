// The process that refuses hears of it as the client does.
#include <gtest/gtest.h>
#include <suture/base/virtual_time.h>
#include <suture/component/task/event_task.h>
#include <suture/framing/link.h>
#include <suture/net/dialer.h>
#include <suture/peer.capnp.h>
#include <unistd.h>

#include <algorithm>

#include "reference/gripper_arm.suture.h"
#include "reference/still_arm.h"
#include "support/pass.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "unit/manager/two_processes.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

TEST(RefusalsTest, ARepeatedRefusalIsToldEachMinute) {
  net::Refusals refusals("left");
  testing::internal::CaptureStderr();
  for (int i = 0; i < 3; ++i) refusals.add("user 7", "talk to it: no");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "left: refused user 7: talk to it: no\n");
  EXPECT_EQ(refusals.summary().count, 3u);
  EXPECT_EQ(refusals.summary().latest, "user 7: talk to it: no");
  pass(61s);
  testing::internal::CaptureStderr();
  refusals.add("user 7", "talk to it: no");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "left: refused user 7: talk to it: no\n");
}

TEST(RefusalsTest, InventedReasonsFillNoLog) {
  net::Refusals refusals("left");
  testing::internal::CaptureStderr();
  for (int i = 0; i < 1000; ++i) refusals.add("user 7", "use 'left:" + std::to_string(i) + "'");
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 20);
  EXPECT_EQ(refusals.summary().count, 1000u);
}

TEST(RefusalsTest, APeersNameIsMadeHarmless) {
  net::Refusals refusals("left");
  testing::internal::CaptureStderr();
  refusals.add("process '\x1b[2J\nright: refused nobody'", "talk to it: no");
  refusals.add(std::string(1u << 20, 'x'), "no");
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(told.starts_with("left: refused process '?[2J\n  right: refused nobody': talk"));
  EXPECT_LT(told.size(), 5000u);
  EXPECT_LT(refusals.summary().latest.size(), 5000u);
}

struct RefusingArm final : EventTask, StillArm {
  ~RefusingArm() override { stop(); }
  void run() override {}
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

/// It asks for more than that arm offers.
struct GripperClient final : EventTask {
  ~GripperClient() override { stop(); }
  void run() override {}
  Required<reference::GripperArm> slave{*this, "Slave"};
};

TEST(RefusalsTest, TheProviderTellsWhatItsClientHears) {
  RefusingArm arm;
  GripperClient client;
  TwoProcesses processes;
  processes.there.add("PSM", arm);
  processes.here.add("Teleop", client);
  processes.start();
  EXPECT_EQ(processes.there.refusals().count, 0u);
  std::uint64_t count = 0;
  for (const char* const provided : {"there:PSM/Arm", "there:PSM/Leg", "there:ECM/Arm"}) {
    testing::internal::CaptureStderr();
    const std::string error = refusal([&] { processes.here.connect("Teleop/Slave", provided); });
    const std::string told = testing::internal::GetCapturedStderr();
    const auto [refused, latest] = processes.there.refusals();
    EXPECT_NE(error, "");
    EXPECT_EQ(refused, ++count) << latest;
    const std::string line = latest.substr(0, latest.find('\n'));
    const std::string text = line.substr(line.find(": ") + 2);
    EXPECT_NE(error.find(text), std::string::npos) << error << "\nand here\n" << latest;
    EXPECT_EQ(told, "there: refused " + latest + "\n");
  }
  EXPECT_EQ(processes.here.refusals().count, 0u);
}

/// Asks the process behind `address` what "PSM/Leg" is. Returns the refusal, or "".
std::string whyNotExplained(const std::string& address) {
  loop::ControlThread control;
  return control.run(kPatience, [&] {
    return net::dial(control.port(), net::Address::parse(address), kPatience)
        .then([&](kj::AutoCloseFd socket) {
          auto link = kj::heap<framing::Link>(
              kj::heap<framing::MessageStream>(control.port(), kj::mv(socket)),
              capnp::rpc::twoparty::Side::CLIENT);
          auto peer = link->bootstrap<wire::Peer>();
          auto hello = peer.helloRequest();
          hello.setVersion(wire::PROTOCOL_VERSION);
          hello.setProcess("test");
          return hello.send()
              .then([peer](auto&&) mutable {
                auto request = peer.explainRequest();
                request.setComponent("PSM");
                request.setInterface("Leg");
                return request.send();
              })
              .then([](auto&& results) {
                return results.isRefused() ? fromWire(results.getRefused()).text : std::string();
              })
              .attach(kj::mv(link));
        });
  });
}

TEST(RefusalsTest, AFailedLookUpIsToldToo) {
  RefusingArm arm;
  TwoProcesses processes;
  processes.there.add("PSM", arm);
  processes.start();
  const std::string socket = "there." + std::to_string(getpid()) + ".sock";
  const std::string told = whyNotExplained("unix:" + processes.directory.file(socket));
  EXPECT_NE(told.find("'there:PSM/Leg'"), std::string::npos) << told;
  const auto [refused, latest] = processes.there.refusals();
  EXPECT_EQ(refused, 1u);
  EXPECT_TRUE(latest.ends_with(told)) << latest;
}

}  // namespace
}  // namespace suture
