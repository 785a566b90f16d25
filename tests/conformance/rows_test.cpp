// Says which rows there are, and that they miss no pair that is possible.
#include "conformance/rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace conformance {
namespace {

using Pairs = std::set<std::pair<std::string, std::string>>;

std::string transportOf(const Row& row) {
  return "transport " + std::to_string(static_cast<int>(row.transport));
}

/// These are lane kind and provider, lane kind and client, provider and client.
Pairs lanePairs(const std::vector<Row>& rows) {
  Pairs pairs;
  for (const Row& row : rows) {
    const std::string client = "client " + row.clientName();
    pairs.insert({row.laneKind(), row.providerName()});
    pairs.insert({row.laneKind(), client});
    pairs.insert({row.providerName(), client});
  }
  return pairs;
}

/// These are lane and place, place and provider, transport and provider.
Pairs wirePairs(const std::vector<Row>& rows) {
  Pairs pairs;
  for (const Row& row : rows) {
    pairs.insert({row.laneName(), row.placeName()});
    pairs.insert({row.placeName(), row.providerName()});
    pairs.insert({transportOf(row), row.providerName()});
  }
  return pairs;
}

void expectAll(const Pairs& possible, const Pairs& covered, const std::string& which) {
  Pairs missing;
  std::set_difference(possible.begin(), possible.end(), covered.begin(), covered.end(),
                      std::inserter(missing, missing.end()));
  for (const auto& [one, other] : missing) {
    ADD_FAILURE() << one << " with " << other << " is on no row of " << which;
  }
}

std::vector<Row> kept(std::vector<Row> rows, const Keep& keep) {
  std::erase_if(rows, [&](const Row& row) { return !keep(row); });
  return rows;
}

const std::pair<const char*, Keep> kKeeps[] = {
    {"all scenarios", [](const Row&) { return true; }},
    {"queued commands", isQueued},
    {"direct connections", &Row::isDirect},
    {"tasks", [](const Row& row) { return !row.providerIsDevice(); }},
    {"providers that can end", &Row::providerCanEnd},
    {"connections without faults", [](const Row& row) { return row.filter != Filter::Faults; }},
};

TEST(Rows, CoverEveryPairOfProviderAndClient) {
  for (const auto& [which, keep] : kKeeps) {
    expectAll(lanePairs(kept(everyLaneRow(), keep)), lanePairs(laneRows(keep)), which);
    expectAll(lanePairs(kept(everyRow(), keep)), lanePairs(wireRows(keep)), which);
  }
  EXPECT_EQ(lanePairs(everyLaneRow()).size(), 6u * 3 + 6 * 2 + 3 * 2);
}

TEST(Rows, WireRowsCoverLanesTransportsAndPlaces) {
  for (const auto& [which, keep] : kKeeps) {
    expectAll(wirePairs(kept(everyRow(), keep)), wirePairs(wireRows(keep)), which);
  }
}

TEST(Rows, DelayEachLane) {
  std::set<std::string> delayed;
  for (const Row& row : laneRows()) {
    if (row.filter == Filter::Delay) delayed.insert(row.laneName());
  }
  EXPECT_EQ(delayed,
            (std::set<std::string>{"DelayedLocal", "DelayedShm", "DelayedFrame", "DelayedRpc"}));
}

TEST(Rows, IncludeALossOnEachLane) {
  expectAll(lanePairs(everyLossyRow()), lanePairs(lossyRows()), "lossy ones");
  expectAll(wirePairs(everyLossyRow()), wirePairs(lossyRows()), "lossy ones");
  EXPECT_TRUE(wirePairs(lossyRows()).contains({"LossyRpc", "InTwoProcesses"}));
}

/// Calls `look` with the suite and the row of each case that has one of everyRow().
void forEachCase(const std::function<void(const std::string&, const Row&)>& look) {
  std::map<std::string, Row> rows;
  for (const Row& row : everyRow()) rows.emplace(row.name(), row);
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const char* const name = suite.GetTestInfo(j)->value_param();
      const auto row = rows.find(name == nullptr ? "" : name);
      if (row != rows.end()) look(suite.name(), row->second);
    }
  }
}

// A filter that leaves out more than it means would do so in silence.
TEST(Rows, LeaveOutOnlyTheListedLanes) {
  const std::set<std::string> all = {"Local", "Shm", "Frame", "Rpc", "Delayed", "Faulty"};
  const std::map<std::string, std::set<std::string>> fewer = {
      {"Lanes/CallersThreadAndATask", {"Local"}},
      {"Lanes/DirectOrder", {"Local"}},
      {"Lanes/LentHandlers", {"Local"}},
      {"Lanes/NoHistory", {"Local"}},
      {"Lanes/Order", {"Local", "Shm", "Frame", "Rpc", "Delayed"}},
      {"Lanes/WireClientProcesses", {"Shm", "Frame", "Rpc", "Delayed", "Faulty"}},
      {"Lanes/WireOrder", {"Local", "Shm", "Frame", "Rpc", "Delayed"}},
  };
  std::map<std::string, std::set<std::string>> kindsBySuite;
  forEachCase([&](const std::string& suite, const Row& row) {
    kindsBySuite[suite].insert(row.laneKind());
  });
  for (const auto& [suite, kinds] : kindsBySuite) {
    const auto one = fewer.find(suite);
    EXPECT_EQ(kinds, one == fewer.end() ? all : one->second) << suite;
  }
  EXPECT_GT(kindsBySuite.size(), fewer.size());
}

TEST(Rows, ADozenScenariosMeetEachWireRow) {
  std::map<std::pair<std::string, std::string>, int> scenarios;
  forEachCase([&](const std::string&, const Row& row) {
    ++scenarios[{row.laneName(), row.placeName()}];
  });
  for (const Row& row : everyRow()) {
    EXPECT_GE((scenarios[{row.laneName(), row.placeName()}]), 12) << row;
  }
}

// Their number must not grow unseen: three presets run each of them, and the long tests the cross.
TEST(Rows, MakeNoMoreCasesThanSaid) {
  const int cases = testing::UnitTest::GetInstance()->total_test_count();
  std::printf("%d cases; %zu rows of lanes, %zu of the wire, %zu lossy ones\n", cases,
              laneRows().size(), wireRows().size(), lossyRows().size());
  EXPECT_LE(cases, fullCrossIsAsked() ? 9700 : 1800);
  EXPECT_GT(cases, 1000);
}

}  // namespace
}  // namespace conformance
