// A client and a provider are on two machines, as far as the network goes.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/names/security.h>
#include <suture/net/tls/key_maker.h>
#include <suture/net/tls/keys.h>

#include <csignal>
#include <optional>
#include <thread>

#include "integration/network/console.h"
#include "paths.h"
#include "support/cable.h"
#include "support/child.h"
#include "support/eventually.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// A Case has the address of the global manager, the lane asked for, and the lane expected.
using Case = std::tuple<const char*, Lane, const char*>;

class Namespaces : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (geteuid() != 0) GTEST_SKIP() << "only root may make network namespaces";
    cable_.emplace();
    if (isSecure()) tls::makeKeys(keys(), {tls::kManagerName, "robot", "console"});
    names_ = std::make_unique<GlobalManager>(control(), std::get<0>(GetParam()),
                                             securityOf(tls::kManagerName));
  }
  void TearDown() override {
    names_ = nullptr;
    control_ = nullptr;
  }

  bool isSecure() const { return std::string_view(std::get<0>(GetParam())).starts_with("tls"); }
  std::string keys() const { return directory_.file("keys"); }
  Security securityOf(const std::string& process) const {
    if (!isSecure()) return {};
    return {.keys = std::make_shared<const tls::Keys>(keys(), process), .policy = {}};
  }
  loop::ControlThread& control() {
    if (control_ == nullptr) control_ = std::make_unique<loop::ControlThread>();
    return *control_;
  }
  /// Starts the host in a namespace of its own, at the other end of the cable.
  std::unique_ptr<Child> host() {
    const std::string program = std::string(paths::kArmHost) + " '" + names_->address() +
                                "' robot" + (isSecure() ? " " + keys() : "");
    auto child = std::make_unique<Child>(
        std::vector<std::string>{"/usr/bin/unshare", "--net", "/bin/sh", "-c",
                                 "until ip link show there >/dev/null 2>&1; do sleep 0.01; done; " +
                                     Cable::pluggingIn() + " && exec " + program});
    const std::string pid = std::to_string(child->pid());
    EXPECT_TRUE(
        eventually([&] { return Cable::namespaceOf(pid) != Cable::namespaceOf("thread-self"); }));
    cable_->stretchTo(child->pid());
    EXPECT_EQ(child->line(), "ready");
    return child;
  }

  TemporaryDirectory directory_;
  std::optional<Cable> cable_;
  std::unique_ptr<loop::ControlThread> control_;  // made after the cable, so in its namespace
  std::unique_ptr<GlobalManager> names_;
};

TEST_P(Namespaces, AreConnectedAsMachinesAre) {
  const auto provider = host();
  Console console;
  Manager manager("console", names_->address(), securityOf("console"));
  manager.add("Console", console);
  manager.start();
  manager.connect("Console/Arm", "robot:PSM/Arm", {.lane = std::get<1>(GetParam())});
  EXPECT_TRUE(reaches(console, 3));
  const auto channel = manager.channels().at(0);
  EXPECT_EQ(channel->lane, std::get<2>(GetParam()));
  EXPECT_GT(channel->bytesSent, 100u);
  EXPECT_GT(channel->bytesReceived, 100u);
  EXPECT_NE(provider->pid(), getpid());

  // The cable is pulled, and put back as soon as that is noticed, or long after.
  for (const Duration out : {0s, 3s}) {
    cable_->pull();
    EXPECT_TRUE(eventually([&] { return !console.arm.connected(); }));
    std::this_thread::sleep_for(out);
    cable_->putBack();
    EXPECT_TRUE(eventually([&] { return console.arm.connected(); }));
    EXPECT_TRUE(reaches(console, 4 + static_cast<double>(out.count())));
    EXPECT_EQ(manager.channels().at(0)->lane, std::get<2>(GetParam())) << "the same lane";
  }
  manager.stop();
  EXPECT_EQ(provider->end(SIGTERM), 0);
}

std::string caseName(const testing::TestParamInfo<Case>& info) {
  const std::string address = std::get<0>(info.param);
  return address.substr(0, address.find(':')) + "_" + std::get<2>(info.param);
}

INSTANTIATE_TEST_SUITE_P(Lanes, Namespaces,
                         testing::Values(Case{"tcp://10.213.7.1:0?insecure", Lane::Auto, "frame"},
                                         Case{"tcp://10.213.7.1:0?insecure", Lane::Rpc, "rpc"},
                                         Case{"tls://10.213.7.1:0", Lane::Auto, "frame"},
                                         Case{"tls://10.213.7.1:0", Lane::Rpc, "rpc"}),
                         caseName);

}  // namespace
}  // namespace suture
