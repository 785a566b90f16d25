#include "tables/connection_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <suture/deploy/document/json_document.h>

#include <algorithm>
#include <chrono>

#include "run/connection_name.h"

namespace demo {
namespace {

using suture::ConnectionReport;
using suture::Deployment;
using suture::Distribution;
using suture::JsonDocument;
using testing::HasSubstr;
using testing::Not;

constexpr std::size_t kTerminal = 120;  // columns

Deployment fig3b() { return Deployment(JsonDocument::read(FIG3B)); }

/// Every connection has the same figures.
std::vector<ConnectionReport> reports(const Deployment& deployment, suture::Duration age) {
  std::vector<ConnectionReport> all;
  for (const suture::ConnectionEntry& entry : deployment.connections()) {
    ConnectionReport one;
    one.name = nameOf(entry);
    one.lane = "frame";
    one.bytesSent = 999'949'999;
    one.executed = one.replaced = 12'345'678;
    one.contract.emplace().staleReads = 123'456;
    one.readAge = one.commandAge = Distribution{1000, age, age, age};
    all.push_back(one);
  }
  return all;
}

std::size_t widthOf(const Table& table) {
  std::size_t widest = 0;
  for (const std::string& line : table.lines()) widest = std::max(widest, line.size());
  return widest;
}

TEST(ConnectionTable, FitsATerminalHoweverOldValuesWere) {
  const Deployment deployment = fig3b();
  for (const int milliseconds : {1, 99, 100, 999, 1000, 60'000}) {
    const auto all = reports(deployment, std::chrono::milliseconds(milliseconds));
    EXPECT_LE(widthOf(connectionTable(deployment, all)), kTerminal) << milliseconds << " ms";
  }
}

/// Returns what the table says of the contracts of all connections that have this report.
std::string contractsOf(const ConnectionReport& report) {
  const Deployment deployment = fig3b();
  std::vector<ConnectionReport> all;
  for (const suture::ConnectionEntry& entry : deployment.connections()) {
    all.push_back(report);
    all.back().name = nameOf(entry);
    all.back().lane = "frame";
  }
  std::string text;
  for (const std::string& line : connectionTable(deployment, all).lines()) text += line + '\n';
  return text;
}

TEST(ConnectionTable, ProvidersThatEndFirstAreNoLoss) {
  ConnectionReport report;
  report.contract.emplace().losses = 1;
  report.status = suture::ChannelStatus::Lost;
  for (const char* why :
       {"ended: its component has been stopped", "closed: its process has ended"}) {
    report.whyLost = why;
    EXPECT_THAT(contractsOf(report), HasSubstr("kept")) << why;
    EXPECT_THAT(contractsOf(report), Not(HasSubstr("lost"))) << why;
  }
  report.contract->losses = 2;  // it was lost before as well
  EXPECT_THAT(contractsOf(report), HasSubstr("1 lost"));
}

TEST(ConnectionTable, ALossDuringTheRunIsTold) {
  ConnectionReport report;
  report.contract.emplace().losses = 1;
  report.whyLost = "ended: a later connection of this interface stands";
  EXPECT_THAT(contractsOf(report), HasSubstr("1 lost")) << "it is there again";
  report.status = suture::ChannelStatus::Lost;
  report.whyLost = "silent: its process has not answered";
  EXPECT_THAT(contractsOf(report), HasSubstr("1 lost"));
}

}  // namespace
}  // namespace demo
