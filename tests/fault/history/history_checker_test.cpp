// The checker reports what is planted in a sound history, and nothing else.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "fault/history/history.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using Kind = HistoryEntry::Kind;
using History = std::vector<HistoryEntry>;

const Time kStart = fromNanoseconds(1'000'000'000);
constexpr Tolerance kTolerance{.lateness = 100ms, .unheard = 10ms};

/// Returns a history of two clients with a hundred commands each, over four connections each, to
/// two providers.
History sound() {
  History history;
  Time at = kStart;
  for (std::uint64_t id = 1; id <= 100; ++id) {
    for (std::uint32_t client = 1; client <= 2; ++client) {
      const std::uint64_t epoch = 1 + id / 25;
      const Duration deadline = id % 3 == 0 ? 200ms : 0ms;
      if (id == 1 || id % 25 == 0) history.push_back({Kind::Connected, at, client, 0, epoch});
      history.push_back({Kind::Sent, at, client, id, epoch, deadline});
      history.push_back({Kind::Executed, at + 2ms, client, id, epoch, 500ms});
      history.push_back({Kind::Ended, at + 3ms, client, id, epoch});
      history.push_back({Kind::Heard, at + 4ms, client, id, 1 + id / 50});
      if (id % 25 == 24)
        history.push_back({Kind::Told, at + 4ms, client, 0, epoch, {}, Errc::Lost});
      at += 5ms;
    }
  }
  return history;
}

/// Returns the `n`-th entry of a kind, from 0.
HistoryEntry& nth(History& history, Kind kind, int n) {
  const auto found = std::find_if(history.begin(), history.end(), [&](const HistoryEntry& entry) {
    return entry.kind == kind && n-- == 0;
  });
  return *found;
}

void sortByTime(History& history) {
  std::stable_sort(history.begin(), history.end(),
                   [](const auto& a, const auto& b) { return a.at < b.at; });
}

void expectNone(const History& history) {
  for (const std::string& one : violations(history, kTolerance)) ADD_FAILURE() << one;
}

void expectOne(const History& history, const std::string& text) {
  const auto found = violations(history, kTolerance);
  ASSERT_EQ(found.size(), 1u) << (found.empty() ? "" : found[0] + "; " + found[1]);
  EXPECT_NE(found[0].find(text), std::string::npos) << found[0];
}

TEST(HistoryChecker, FindsNothingInASoundHistory) {
  expectNone(sound());
  expectNone({});
}

TEST(HistoryChecker, ACommandThatIsExecutedTwice) {
  History history = sound();
  HistoryEntry again = nth(history, Kind::Executed, 60);
  history.push_back(again);
  sortByTime(history);
  expectOne(history, "was executed twice");
}

TEST(HistoryChecker, ACommandOlderThanItsTtl) {
  History history = sound();
  HistoryEntry& late = nth(history, Kind::Executed, 80);
  late.age = late.limit;
  late.at += 1ms;  // what came after the comparison does not count
  expectNone(history);
  late.age += 1ns;
  expectOne(history, "command 41 of client 1 was executed 500.000001 ms old, its ttl is 500");
}

TEST(HistoryChecker, ACommandThatBeginsAfterTheLoss) {
  History history = sound();
  HistoryEntry& last = nth(history, Kind::Executed, 46);  // the first client's connection ran it
  const HistoryEntry told = nth(history, Kind::Told, 0);
  ASSERT_EQ(last.epoch, told.epoch);
  last.at = told.at + kTolerance.unheard;
  expectNone(history);
  last.at += 1ns;
  expectOne(history,
            "command 24 of client 1 was executed 10.000001 ms after its sender was told that "
            "connection 1 is lost");
}

TEST(HistoryChecker, ASecondCommandAfterTheLoss) {
  constexpr Tolerance kHeldUp{.lateness = 100ms, .unheard = 10ms, .justJudged = 1};
  History history = sound();
  const HistoryEntry told = nth(history, Kind::Told, 0);
  HistoryEntry& last = nth(history, Kind::Executed, 46);
  HistoryEntry& lastButOne = nth(history, Kind::Executed, 44);
  ASSERT_EQ(last.epoch, told.epoch);
  ASSERT_EQ(lastButOne.epoch, told.epoch);
  last.at = told.at + 12ms;
  EXPECT_TRUE(violations(history, kHeldUp).empty());
  lastButOne.at = told.at + 11ms;
  EXPECT_EQ(violations(history, kHeldUp).size(), 1u);
}

TEST(HistoryChecker, TheNextConnectionHasNoLoss) {
  History history = sound();
  HistoryEntry& last = nth(history, Kind::Executed, 46);
  last.at = nth(history, Kind::Told, 0).at + kTolerance.unheard + 1ns;
  nth(history, Kind::Ended, 46).epoch = 2;  // its sender found the new one when it had sent it
  expectNone(history);
}

/// Holds what both ends of the first client's connection say in the end.
struct Ledgers {
  HistorySums client{.accepted = 103,
                     .executed = 98,
                     .others = 2,
                     .lost = 1,
                     .unknown = 2,
                     .heard = 97,
                     .process = 7,
                     .other = 8};
  HistorySums provider{.accepted = 97, .executed = 96, .others = 1, .process = 8, .other = 7};
  std::uint64_t begun = 96;

  History history() const {
    History all = sound();
    HistoryEntry entry{Kind::Counted, all.back().at, 1};
    entry.sums = client;
    all.push_back(entry);
    entry.kind = Kind::Served;
    entry.id = begun;
    entry.sums = provider;
    all.push_back(entry);
    return all;
  }
};

TEST(HistoryChecker, FindsALedgerWithAMissingExecution) {
  Ledgers ledgers;
  expectNone(ledgers.history());
  --ledgers.client.executed;
  ++ledgers.client.others;
  expectOne(ledgers.history(),
            "the ledger of client 1 says that 97 commands were executed, and 2 may have been; 100 "
            "were");
  ledgers.client.executed = 101;
  ledgers.client.others = 0;
  --ledgers.client.lost;
  expectOne(ledgers.history(), "says that 101 commands were executed");
}

TEST(HistoryChecker, ALedgerThatDoesNotAddUp) {
  Ledgers ledgers;
  ++ledgers.client.accepted;
  expectOne(ledgers.history(), "the ledger of client 1 has places for 103 of 104 commands");
  ledgers = {};
  ++ledgers.provider.underWay;
  expectOne(ledgers.history(), "the provider's ledger of client 1 has places for 98 of 97");
}

TEST(HistoryChecker, FindsALedgerUnawareOfItsExecution) {
  Ledgers ledgers;
  ledgers.begun = 95;
  expectOne(ledgers.history(),
            "the provider's ledger of client 1 says that 96 commands were executed; 95 were");
}

TEST(HistoryChecker, AClientThatHeardOfTooMany) {
  Ledgers ledgers;
  ++ledgers.client.heard;
  expectOne(ledgers.history(),
            "the ledger of client 1 has heard of 98 outcomes, and its provider has counted 97");
  ledgers.client.other = 9;
  expectNone(ledgers.history());
}

TEST(HistoryChecker, ACallThatEndsLate) {
  History history = sound();
  nth(history, Kind::Ended, 4).at += 301ms;  // the third command has a deadline
  expectOne(history, "command 3 of client 1 ended after 304.000000 ms");
}

TEST(HistoryChecker, ACallThatNeverEnds) {
  History history = sound();
  const HistoryEntry gone = nth(history, Kind::Ended, 4);
  std::erase_if(history, [&](const HistoryEntry& entry) {
    return entry.kind == Kind::Ended && entry.client == gone.client && entry.id == gone.id;
  });
  expectOne(history, "never ended");
  history.push_back({Kind::Killed, gone.at + 400ms, gone.client});
  expectOne(history, "never ended");
  history.back().at = gone.at + 100ms;
  expectNone(history);
}

TEST(HistoryChecker, CommandsThatChangePlaces) {
  History history = sound();
  nth(history, Kind::Executed, 60).at = nth(history, Kind::Executed, 62).at + 1ns;
  sortByTime(history);
  expectOne(history, "command 31 of client 1 was executed after command 32");
}

TEST(HistoryChecker, ACommandOfAnOlderConnection) {
  History history = sound();
  std::erase_if(history, [](const HistoryEntry& entry) { return entry.kind == Kind::Told; });
  const auto late = std::find_if(history.begin(), history.end(), [](const HistoryEntry& entry) {
    return entry.kind == Kind::Executed && entry.id == 20 && entry.client == 1;
  });
  HistoryEntry resurrected = *late;
  history.erase(late);
  resurrected.at = history.back().at + 1ms;
  resurrected.limit = {};
  history.push_back(resurrected);
  expectOne(history, "of connection 1 was executed after one of connection 5");
}

TEST(HistoryChecker, ACommandThatWasToldNotExecuted) {
  History history = sound();
  nth(history, Kind::Ended, 10).error = Errc::Lost;
  expectOne(history, "and its sender was told");
  nth(history, Kind::Ended, 10).error = Errc::OutcomeUnknown;
  expectNone(history);
}

TEST(HistoryChecker, ACommandThatAwaitedItsOperator) {
  History history = sound();
  const HistoryEntry sent = nth(history, Kind::Sent, 40);
  HistoryEntry awaits{Kind::Awaits, sent.at - 1ms, sent.client, 0, sent.epoch};
  HistoryEntry resumed{Kind::Resumed, sent.at + 1ms, sent.client, 0, sent.epoch};
  history.insert(history.end(), {awaits, resumed});
  sortByTime(history);
  expectOne(history, "command " + std::to_string(sent.id) + " of client " +
                         std::to_string(sent.client) +
                         " was let through while its operator was awaited");
  std::erase_if(history, [&](const HistoryEntry& one) {
    return one.kind == Kind::Executed && one.client == sent.client && one.id == sent.id;
  });
  for (HistoryEntry& one : history) {
    const bool isIts = one.client == sent.client && one.id == sent.id;
    if (isIts && one.kind == Kind::Ended) one.error = Errc::AwaitingOperator;
  }
  expectNone(history);
}

TEST(HistoryChecker, ACommandThatWasNotSent) {
  History history = sound();
  history.push_back({Kind::Executed, history.back().at, 1, 1000, 9});
  expectOne(history, "nobody sent it");
}

TEST(HistoryChecker, AnEventOfAnOlderProvider) {
  History history = sound();
  history.push_back({Kind::Heard, history.back().at, 2, 101, 3});
  history.push_back({Kind::Heard, history.back().at, 2, 49, 2});
  expectOne(history, "client 2 heard event 49 of provider 2 after 101 of provider 3");
}

TEST(HistoryChecker, AnEventHeardTwice) {
  History history = sound();
  const HistoryEntry twice = nth(history, Kind::Heard, 199);
  history.push_back(twice);
  expectOne(history, "heard event 100");
}

TEST(HistoryLog, ReadsBackAllButACutLine) {
  const TemporaryDirectory directory;
  History history = sound();
  nth(history, Kind::Connected, 0).lane = "shm";
  nth(history, Kind::Executed, 0).age = 1ms;
  nth(history, Kind::Executed, 0).sums = {.accepted = 1, .other = 2};
  std::vector<std::string> files;
  {
    for (const char* name : {"a", "b", "c"}) files.push_back(directory.file(name));
    HistoryLog one(files[0]), two(files[1]), provider(files[2]);
    for (const HistoryEntry& entry : history) {
      const bool executed = entry.kind == Kind::Executed;
      (executed ? provider : entry.client == 1 ? one : two).write(entry);
    }
  }
  const auto size = std::filesystem::file_size(files[0]);
  std::filesystem::resize_file(files[0], size - 2);
  const History back = readHistory(files);
  ASSERT_EQ(back.size(), history.size() - 1);
  expectNone(back);
  EXPECT_EQ(back[0].lane, "shm");
  EXPECT_EQ(back[1].lane, "");
  EXPECT_EQ(back[2].limit, 500ms);
  EXPECT_EQ(back[2].age, 1ms);
  EXPECT_EQ(back[2].sums, (HistorySums{.accepted = 1, .other = 2}));
  EXPECT_EQ(back[2].at, kStart + 2ms);
}

}  // namespace
}  // namespace suture
