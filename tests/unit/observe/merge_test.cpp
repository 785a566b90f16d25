#include <gtest/gtest.h>
#include <suture/observe/merge.h>

#include <chrono>

namespace {

using namespace std::chrono_literals;
using suture::ConnectionEnd;
using suture::ConnectionReport;
using suture::Report;

ConnectionReport clientEnd(const std::string& name) {
  ConnectionReport end;
  end.name = name;
  end.lane = "rpc";
  end.end = ConnectionEnd::Client;
  end.sent = 100;
  end.executed = 90;
  end.replaced = 2;
  end.underWay = 3;
  end.unknown = 5;
  end.heard = {.executed = 90, .replaced = 1};
  end.bytesSent = 5000;
  end.contract = {.staleReads = 6, .losses = 7, .awaitsOperator = true};
  end.readAge = {90, 1ms, 2ms, 3ms};
  return end;
}

ConnectionReport providerEnd(const std::string& name) {
  ConnectionReport end;
  end.name = name;
  end.lane = "rpc";
  end.end = ConnectionEnd::Provider;
  end.sent = 99;  // what the lane handed on
  end.executed = 95;
  end.replaced = 2;
  end.late = 2;
  end.lastInvalid = "limit.speed";
  end.bytesReceived = 4999;
  end.commandAge = {95, 4ms, 5ms, 6ms};
  return end;
}

void expectWhole(const ConnectionReport& whole) {
  EXPECT_EQ(whole.end, ConnectionEnd::Both);
  EXPECT_EQ(whole.sent, 100u);
  EXPECT_EQ(whole.executed, 95u);
  EXPECT_EQ(whole.replaced, 3u);
  EXPECT_EQ(whole.late, 2u);
  EXPECT_EQ(whole.lastInvalid, "limit.speed");
  EXPECT_EQ(whole.bytesSent, 5000u);
  ASSERT_TRUE(whole.contract);
  EXPECT_EQ(whole.contract->staleReads, 6u);
  EXPECT_EQ(whole.contract->losses, 7u);
  EXPECT_TRUE(whole.contract->awaitsOperator);
  EXPECT_EQ(whole.readAge.max, 3ms);
  EXPECT_EQ(whole.commandAge.max, 6ms);
}

TEST(Merge, BothEndsBecomeOneConnection) {
  const auto merged = suture::mergeConnections(
      {{"a", {}, {clientEnd("x")}, {}}, {"b", {}, {providerEnd("x")}, {}}});
  ASSERT_EQ(merged.size(), 1u);
  expectWhole(merged[0]);
}

TEST(Merge, BothEndsMayComeInAnyOrder) {
  const auto merged = suture::mergeConnections({{"a", {}, {providerEnd("x"), clientEnd("x")}, {}}});
  ASSERT_EQ(merged.size(), 1u);
  expectWhole(merged[0]);
}

TEST(Merge, AOneSidedLossIsReported) {
  auto provider = providerEnd("x");
  provider.status = suture::ChannelStatus::Lost;
  const auto merged =
      suture::mergeConnections({{"a", {}, {clientEnd("x")}, {}}, {"b", {}, {provider}, {}}});
  EXPECT_EQ(merged.at(0).status, suture::ChannelStatus::Lost);
}

TEST(Merge, DifferentConnectionsStayApart) {
  const auto merged = suture::mergeConnections(
      {{"a", {}, {clientEnd("x")}, {}}, {"b", {}, {providerEnd("y")}, {}}});
  ASSERT_EQ(merged.size(), 2u);
  EXPECT_EQ(merged[0].end, ConnectionEnd::Client);
  EXPECT_EQ(merged[1].end, ConnectionEnd::Provider);
}

}  // namespace
