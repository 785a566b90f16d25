#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/observe/observe.h>

#include <chrono>
#include <limits>
#include <thread>

#include "reference/simulated_arm.suture.h"
#include "support/pass.h"
#include "support/patience.h"

namespace {

using namespace std::chrono_literals;

class Client final : public suture::PeriodicTask {
 public:
  Client() : PeriodicTask({.period = 1ms}) { measureOver(2ms); }

 private:
  void run() override {
    suture::pass(10us);
    (void)arm_.servo_cp({});
    (void)arm_.measured_cp();
  }

  suture::Required<reference::ArmLike> arm_{*this, "Arm"};
};

TEST(Observe, CountsWhatALocalConnectionDoes) {
  reference::SimulatedArm arm({});
  Client client;
  suture::Manager manager("here");
  manager.add("PSM", arm);
  manager.add("Client", client);
  manager.connect("Client/Arm", "PSM/Arm");
  const auto began = suture::now();
  manager.start();

  suture::Report report;
  const auto deadline = suture::now() + suture::kPatience;
  do {
    suture::pass(std::chrono::microseconds(100));
    report = suture::observe(manager, began);
  } while ((report.connections.at(0).executed < 3 || report.connections.at(0).readAge.count < 3 ||
            report.tasks.at(0).window.cycles == 0) &&
           suture::now() < deadline);
  manager.stop();

  EXPECT_EQ(report.process, "here");
  EXPECT_GT(report.age, 0ns);
  ASSERT_EQ(report.connections.size(), 1u);
  const auto& connection = report.connections[0];
  EXPECT_EQ(connection.name, "here:Client/Arm -> here:PSM/Arm");
  EXPECT_EQ(connection.lane, "local");
  EXPECT_EQ(connection.end, suture::ConnectionEnd::Both);
  EXPECT_EQ(connection.status, suture::ChannelStatus::Connected);
  EXPECT_GE(connection.executed, 3u);
  EXPECT_GE(connection.sent, connection.executed);
  EXPECT_GE(connection.commandAge.count, 3u);
  EXPECT_GE(connection.readAge.max, connection.readAge.p50);
  EXPECT_EQ(connection.bytesSent, 0u);

  ASSERT_EQ(report.tasks.size(), 2u);
  EXPECT_EQ(report.tasks[0].name, "Client");
  EXPECT_EQ(report.tasks[0].state, suture::ComponentState::Running);
  EXPECT_GE(report.tasks[0].cycles, 3u);
  EXPECT_GE(report.tasks[1].lateness.count, 3u);
  EXPECT_GT(report.tasks[0].computeTime.max, 0ns);
  EXPECT_GE(report.tasks[0].window.length, 2ms);
  EXPECT_GT(report.tasks[0].processorTime.value(), 0ns);
  EXPECT_GE(report.processorTime, report.tasks[0].processorTime.value());
  EXPECT_GT(report.tasks[0].window.period.mean, 0ns);
  EXPECT_GT(report.tasks[0].window.compute.p99, 0ns);
}

TEST(Observe, TellsARefusedValuesPart) {
  struct Console final : suture::Device {
    suture::Required<reference::ArmLike> arm{*this, "Arm"};
  } console;
  reference::SimulatedArm arm({});
  suture::Manager manager("here");
  manager.add("PSM", arm);
  manager.add("Console", console);
  manager.connect("Console/Arm", "PSM/Arm");
  manager.start();
  const auto present = [&] { return suture::observe(manager, suture::now()).connections.at(0); };
  EXPECT_EQ(present().lastInvalid, "");
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(console.arm.limit(kNone, reference::Mode::Enabled));
  EXPECT_EQ(present().invalid, 1u);
  EXPECT_EQ(present().lastInvalid, "limit.speed");
  manager.stop();
}

TEST(Observe, TellsOfContractsAndDevices) {
  struct Shelf final : suture::Device {
  } shelf;
  reference::SimulatedArm arm({});
  Client client;
  suture::Manager manager("here");
  manager.add("PSM", arm);
  manager.add("Client", client);
  manager.add("Shelf", shelf);
  manager.connect(
      "Client/Arm", "PSM/Arm",
      {.patience = 1s, .contract = {.maxAge = 1ns, .resume = suture::Resume::Operator}});
  manager.start();
  const auto present = [&] { return suture::observe(manager, suture::now()); };
  const auto deadline = suture::now() + suture::kPatience;
  const auto contract = [&] { return present().connections.at(0).contract; };
  ASSERT_TRUE(contract());
  while (contract()->staleReads < 3 && suture::now() < deadline)
    suture::pass(std::chrono::microseconds(100));
  EXPECT_GE(contract()->staleReads, 3u);
  EXPECT_TRUE(contract()->awaitsOperator);
  EXPECT_EQ(contract()->losses, 0u);

  shelf.park("it fell");
  const suture::Report report = present();
  manager.stop();
  EXPECT_EQ(report.tasks.size(), 2u);
  ASSERT_EQ(report.devices.size(), 1u);
  EXPECT_EQ(report.devices[0].name, "Shelf");
  EXPECT_EQ(report.devices[0].state, suture::ComponentState::Faulted);
  EXPECT_EQ(report.devices[0].fault, "it fell");
  EXPECT_EQ(report.devices[0].faults, 1u);
}

}  // namespace
