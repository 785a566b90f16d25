#include <gtest/gtest.h>
#include <suture/rt/queue/mailbox.h>

#include <cstring>
#include <random>
#include <thread>
#include <vector>

namespace suture::rt {
namespace {

// These are two newest-wins commands and two queued ones, as an arm has them.
constexpr std::uint16_t kServoCp = 0, kServoJp = 1, kHold = 2, kEnable = 3;
constexpr CommandLimits kCommands[] = {{8, 2, true}, {8, 2, true}, {0, 4, false}, {8, 16, false}};

bool send(Mailbox& mailbox, std::uint16_t command, std::uint64_t value = 0,
          std::uint32_t call = 0) {
  const auto memory = mailbox.claim(command, now(), call);
  if (!memory) return false;
  if (kCommands[command].argumentsSize > 0) std::memcpy(*memory, &value, sizeof(value));
  mailbox.commit();
  return true;
}

struct Executed {
  std::uint16_t command;
  std::uint64_t value;
  bool operator==(const Executed&) const = default;
};

std::vector<Executed> drain(Mailbox& mailbox) {
  std::vector<Executed> executed;
  mailbox.fixCut();
  while (const CommandRecord* record = mailbox.next()) {
    std::uint64_t value = 0;
    if (kCommands[record->command].argumentsSize > 0) {
      std::memcpy(&value, record->arguments(), sizeof(value));
    }
    executed.push_back({record->command, value});
    const std::uint16_t command = record->command;
    const bool queued = !kCommands[command].latest || record->call != 0;
    mailbox.pop();
    if (queued) mailbox.returnCredit(command);
  }
  return executed;
}

TEST(Mailbox, TellsHowMuchRoomThereIs) {
  Mailbox mailbox(kCommands);
  EXPECT_EQ(mailbox.room(kHold), 4u);
  EXPECT_EQ(mailbox.room(kServoCp), Mailbox::kUnlimited);
  for (int i = 0; i < 4; ++i) send(mailbox, kHold);
  EXPECT_FALSE(mailbox.roomAwaited().isUp(std::memory_order_relaxed));
  EXPECT_EQ(mailbox.room(kHold), 0u);
  EXPECT_EQ(mailbox.room(kEnable), 16u) << "each command has room of its own";
  EXPECT_TRUE(mailbox.roomAwaited().take(std::memory_order_relaxed));
  drain(mailbox);
  EXPECT_EQ(mailbox.room(kHold), 4u);
}

TEST(Mailbox, ServoThenHoldEndsInHold) {
  Mailbox mailbox(kCommands);
  send(mailbox, kServoCp, 1);
  send(mailbox, kHold);
  EXPECT_EQ(drain(mailbox), (std::vector<Executed>{{kServoCp, 1}, {kHold, 0}}));
}

TEST(Mailbox, HoldThenServoEndsInServo) {
  Mailbox mailbox(kCommands);
  send(mailbox, kHold);
  send(mailbox, kServoCp, 1);
  EXPECT_EQ(drain(mailbox), (std::vector<Executed>{{kHold, 0}, {kServoCp, 1}}));
}

TEST(Mailbox, NewestWinsCommandsRunInOrder) {
  Mailbox mailbox(kCommands);
  send(mailbox, kServoCp, 1);
  send(mailbox, kServoJp, 2);
  EXPECT_EQ(drain(mailbox), (std::vector<Executed>{{kServoCp, 1}, {kServoJp, 2}}));
  send(mailbox, kServoCp, 3);
  send(mailbox, kServoJp, 4);
  send(mailbox, kServoCp, 5);
  EXPECT_EQ(drain(mailbox), (std::vector<Executed>{{kServoJp, 4}, {kServoCp, 5}}));
  EXPECT_EQ(mailbox.counters.replaced, 1u);
}

// The producer sends again while the drain is under way: what comes after the cut waits.
TEST(Mailbox, CommandsAfterTheCutWait) {
  Mailbox mailbox(kCommands);
  send(mailbox, kServoCp, 1);
  send(mailbox, kHold);
  mailbox.fixCut();
  send(mailbox, kServoCp, 2);
  ASSERT_EQ(mailbox.next()->command, kServoCp);
  mailbox.pop();
  ASSERT_EQ(mailbox.next()->command, kHold);
  mailbox.pop();
  mailbox.returnCredit(kHold);
  EXPECT_EQ(mailbox.next(), nullptr);
  EXPECT_TRUE(mailbox.pending());
  EXPECT_EQ(drain(mailbox), (std::vector<Executed>{{kServoCp, 2}}));
  EXPECT_FALSE(mailbox.pending());
}

TEST(Mailbox, FullIsToldPerCommand) {
  Mailbox mailbox(kCommands);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(send(mailbox, kHold));
  const auto refused = mailbox.claim(kHold, now(), 0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), Errc::Full);
  EXPECT_TRUE(send(mailbox, kEnable, 1));  // another command's credits are its own
  EXPECT_TRUE(send(mailbox, kServoCp, 1));
  EXPECT_EQ(mailbox.counters.full, 1u);
  EXPECT_EQ(drain(mailbox).size(), 6u);
  EXPECT_TRUE(send(mailbox, kHold));
}

TEST(Mailbox, OnlyAReturnedCreditComesBack) {
  Mailbox mailbox(kCommands);
  for (int i = 0; i < 4; ++i) send(mailbox, kHold);
  mailbox.fixCut();
  mailbox.next();
  mailbox.pop();
  EXPECT_FALSE(send(mailbox, kHold));
  mailbox.returnCredit(kHold);
  EXPECT_TRUE(send(mailbox, kHold));
}

TEST(Mailbox, AnAbandonedClaimCostsNothing) {
  Mailbox mailbox(kCommands);
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(mailbox.claim(kHold, now(), 0));
  EXPECT_FALSE(mailbox.pending());
  send(mailbox, kHold);
  mailbox.fixCut();
  EXPECT_EQ(mailbox.next()->sequence, 1u);
}

TEST(Mailbox, ANewestWinsCallIsQueued) {
  Mailbox mailbox(kCommands);
  EXPECT_TRUE(send(mailbox, kServoCp, 1, 17));
  EXPECT_TRUE(send(mailbox, kServoCp, 2));
  EXPECT_EQ(drain(mailbox), (std::vector<Executed>{{kServoCp, 1}, {kServoCp, 2}}));
}

// The law of the mailbox with the producer racing the drain: what runs is in the order of sending,
// nothing queued is lost, of each newest-wins command the last one sent runs last, and each that
// does not run is counted.
TEST(Mailbox, OrderHoldsInARace) {
  constexpr std::uint64_t kSent = 300'000;
  Mailbox mailbox(kCommands);
  std::vector<Executed> lastSent(4);
  std::uint64_t queuedSent = 0;
  std::atomic<bool> done{false};
  std::thread producer([&] {
    std::mt19937 random(7);
    for (std::uint64_t value = 1; value <= kSent; ++value) {
      const std::uint16_t latest = random() % 2 == 0 ? kServoCp : kServoJp;
      const std::uint16_t command = random() % 2 == 0 ? kEnable : latest;
      while (!send(mailbox, command, value)) std::this_thread::yield();
      lastSent[command] = {command, value};
      queuedSent += command == kEnable ? 1 : 0;
    }
    done = true;
  });
  std::uint64_t last = 0, queuedExecuted = 0, runs = 0;
  std::vector<Executed> lastExecuted(4);
  bool finished = false;
  while (!finished) {
    finished = done;
    for (const Executed& executed : drain(mailbox)) {
      ASSERT_GT(executed.value, last);
      last = executed.value;
      ++runs;
      lastExecuted[executed.command] = executed;
      queuedExecuted += executed.command == kEnable ? 1 : 0;
    }
  }
  producer.join();
  EXPECT_EQ(queuedExecuted, queuedSent);
  EXPECT_EQ(lastExecuted, lastSent);
  EXPECT_EQ(mailbox.counters.superseded, 0u);
  EXPECT_EQ(runs + mailbox.counters.replaced + mailbox.counters.overtaken, kSent);
}

}  // namespace
}  // namespace suture::rt
