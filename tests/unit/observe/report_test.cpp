#include <gtest/gtest.h>
#include <suture/observe/report.h>

#include <chrono>

namespace {

using namespace std::chrono_literals;

suture::Report sample() {
  suture::ConnectionReport connection;
  connection.name = "left:Teleop/Slave -> right:PSM1/Arm";
  connection.lane = "rpc";
  connection.end = suture::ConnectionEnd::Provider;
  connection.status = suture::ChannelStatus::Lost;
  connection.whyNotBack = "it has another contract";
  connection.bytesSent = 1;
  connection.bytesReceived = 2;
  connection.contract = {.staleReads = 51, .losses = 52, .awaitsOperator = true};
  connection.sent = 3;
  connection.executed = 4;
  connection.full = 5;
  connection.tooLarge = 6;
  connection.lastInvalid = "servo_cp.goal.pose";
  connection.replaced = 7;
  connection.superseded = 8;
  connection.late = 9;
  connection.failed = 10;
  connection.eventsDelivered = 11;
  connection.eventsDropped = 12;
  connection.messagesLost = 55;
  connection.messagesDuplicated = 56;
  connection.messagesOvertaken = 57;
  connection.cancelled = 60;
  connection.lost = 61;
  connection.unknown = 62;
  connection.underWay = 63;
  connection.heard = {.executed = 64};
  connection.otherIncarnation = 65;
  connection.readAge = {13, 14ns, 15ns, 16ns};
  connection.commandAge = {17, 18ns, 19ns, 20ns};
  suture::TaskReport task;
  task.name = "Teleop";
  task.state = suture::ComponentState::Faulted;
  task.fault = "it threw";
  task.faults = 53;
  task.scheduling = "fifo 66";
  task.cycles = 21;
  task.skipped = 22;
  task.lateness = {23, 24ns, 25ns, 26ns};
  task.computeTime = {27, 28ns, 29ns, 30ns};
  task.processorTime = 66ns;
  task.window = {31ns, 32, 33, {34ns, 35ns, 36ns, 37ns, 38ns}, {39ns, 40ns, 41ns, 42ns, 43ns}};
  const suture::DeviceReport device{"Shelf", suture::ComponentState::Faulted, "it fell", 54};
  return {"left", 2s, {connection}, {task}, {device}, {58, "user 7: no"}, 59, 67ns};
}

TEST(Report, IsTheSameAfterJson) {
  const auto json = suture::toJson(sample());
  const auto again = suture::toJson(suture::reportFromJson(nlohmann::json::parse(json.dump())));
  EXPECT_EQ(again, json);
}

TEST(Report, EveryFieldIsInTheJson) {
  const auto json = suture::toJson(sample());
  const auto& connection = json.at("connections").at(0);
  EXPECT_EQ(connection.at("end"), "provider");
  EXPECT_EQ(connection.at("status"), "lost");
  EXPECT_EQ(connection.at("why_not_back"), "it has another contract");
  EXPECT_EQ(connection.at("contract").at("stale_reads"), 51);
  EXPECT_EQ(connection.at("contract").at("losses"), 52);
  EXPECT_EQ(connection.at("contract").at("awaits_operator"), true);
  EXPECT_EQ(connection.at("dropped"), 79);
  EXPECT_EQ(connection.at("last_invalid"), "servo_cp.goal.pose");
  EXPECT_EQ(connection.at("lost"), 61);
  EXPECT_EQ(connection.at("unknown"), 62);
  EXPECT_EQ(connection.at("under_way"), 63);
  EXPECT_EQ(connection.at("heard").at("executed"), 64);
  EXPECT_EQ(json.at("incarnation"), 59);
  EXPECT_EQ(connection.at("events_dropped"), 12);
  EXPECT_EQ(connection.at("messages_lost"), 55);
  EXPECT_EQ(connection.at("messages_duplicated"), 56);
  EXPECT_EQ(connection.at("messages_overtaken"), 57);
  EXPECT_EQ(connection.at("command_age").at("max"), 20);
  const auto& task = json.at("tasks").at(0);
  EXPECT_EQ(task.at("state"), "faulted");
  EXPECT_EQ(task.at("fault"), "it threw");
  EXPECT_EQ(task.at("faults"), 53);
  EXPECT_EQ(task.at("compute_time").at("p99"), 29);
  EXPECT_EQ(task.at("processor_time"), 66);
  EXPECT_EQ(json.at("processor_time"), 67);
  EXPECT_EQ(task.at("window").at("cycles"), 32);
  EXPECT_EQ(task.at("window").at("period").at("deviation"), 35);
  EXPECT_EQ(task.at("window").at("compute").at("p99"), 43);
  EXPECT_EQ(json.at("age"), 2'000'000'000);
  EXPECT_EQ(json.at("devices"), nlohmann::json::parse(R"([{"name": "Shelf", "state": "faulted",
                                                          "fault": "it fell", "faults": 54}])"));
  EXPECT_EQ(json.at("refusals").at("count"), 58);
  EXPECT_EQ(json.at("refusals").at("latest"), "user 7: no");
}

TEST(Report, AConnectionWithoutAContractHasNone) {
  suture::Report report = sample();
  report.connections[0].contract.reset();
  const auto json = suture::toJson(report);
  EXPECT_TRUE(json.at("connections").at(0).at("contract").is_null());
  EXPECT_FALSE(suture::reportFromJson(json).connections[0].contract);
}

TEST(Report, DroppedIsNotExecutedLateOrReplaced) {
  EXPECT_EQ(sample().connections[0].dropped(), 5u + 6 + 8 + 60);
}

TEST(Report, AnotherJsonIsAnError) {
  EXPECT_THROW(suture::reportFromJson({{"process", "left"}}), nlohmann::json::exception);
}

}  // namespace
