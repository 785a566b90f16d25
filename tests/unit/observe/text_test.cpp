#include <gtest/gtest.h>
#include <suture/observe/text.h>

#include <chrono>

namespace suture {
namespace {

using namespace std::chrono_literals;

ConnectionReport connection(ConnectionEnd end) {
  ConnectionReport one;
  one.name = "left:Teleop/Slave -> right:PSM1/Arm";
  one.lane = "rpc";
  one.end = end;
  one.sent = 100;
  one.executed = 95;
  one.full = 3;
  one.late = 2;
  return one;
}

TEST(Text, TellsAllOfAProcess) {
  TaskReport task{.name = "PSM",
                  .state = ComponentState::Faulted,
                  .fault = "no answer",
                  .faults = 2,
                  .scheduling = "fifo 80",
                  .cycles = 500,
                  .skipped = 1,
                  .lateness = {500, 1us, 20us, 300us},
                  .computeTime = {},
                  .processorTime = 12345us,
                  .window = {}};
  EXPECT_EQ(
      toText({"right",
              1500ms,
              {},
              {task},
              {{"Shelf", ComponentState::Running, "", 0}},
              {},
              0,
              67800us}),
      "process right after 1.5 s, processor time 67.8 ms\n"
      "tasks\n"
      "  PSM: faulted (no answer), faults 2, fifo 80, cycles 500, skipped 1, lateness p50 1.0 "
      "us, p99 20.0 us, max 300.0 us, processor time 12.3 ms\n"
      "devices\n"
      "  Shelf: running, faults 0\n");
}

TEST(Text, TellsAllOfAConnection) {
  ConnectionReport one = connection(ConnectionEnd::Both);
  one.whyLost = "hung: it sleeps";
  one.whyNotBack = "it sleeps still";
  one.contract = {.staleReads = 7, .losses = 1, .awaitsOperator = true};
  one.lastInvalid = "servo_cp.goal.pose";
  one.failed = 4;
  one.eventsDropped = 5;
  one.lost = 9;
  one.unknown = 10;
  one.underWay = 11;
  one.messagesLost = 6;
  one.messagesDuplicated = 7;
  one.messagesOvertaken = 8;
  EXPECT_EQ(toText({"left", 0s, {one}, {}, {}}),
            "process left after 0.0 s\n"
            "connections\n"
            "  left:Teleop/Slave -> right:PSM1/Arm: rpc, connected, both ends\n"
            "    sent 100, executed 95, dropped 3, late 2, stale reads 7, losses 1, awaits its "
            "operator, last invalid servo_cp.goal.pose, failed 4, events dropped 5, lost 9, "
            "unknown 10, under way 11, messages lost 6, "
            "duplicated 7, overtaken 8, last loss: hung: it sleeps, not back: it sleeps still\n");
}

TEST(Text, TellsWhatWasRefusedToPeers) {
  EXPECT_EQ(toText({"left", 0s, {}, {}, {}, {3, "user 7: talk to 'left': no"}}),
            "process left after 0.0 s\n"
            "refused to peers: 3, the latest to user 7: talk to 'left': no\n");
}

TEST(Text, SaysWhichEndCountsTheRest) {
  EXPECT_EQ(toText({"left", 0s, {connection(ConnectionEnd::Client)}, {}, {}}),
            "process left after 0.0 s\n"
            "connections\n"
            "  left:Teleop/Slave -> right:PSM1/Arm: rpc, connected, its client's end\n"
            "    sent 100, executed 95 (as heard), dropped 3 (at this end), late 2, "
            "no contract\n");
  EXPECT_EQ(
      toText({"right", 0s, {connection(ConnectionEnd::Provider)}, {}, {}}),
      "process right after 0.0 s\n"
      "connections\n"
      "  left:Teleop/Slave -> right:PSM1/Arm: rpc, connected, its provider's end\n"
      "    sent 100 (by the lane), executed 95, dropped 3 (at this end), late 2, stale reads, "
      "losses: see the client's end\n");
}

}  // namespace
}  // namespace suture
