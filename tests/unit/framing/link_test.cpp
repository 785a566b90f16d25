// Links between a server and its peers carry calls, have failures, and keep limits.

#include <gtest/gtest.h>
#include <suture/framing/link_server.h>
#include <suture/loop/failure.h>
#include <suture/net/dialer.h>
#include <unistd.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "echo_scene.h"
#include "support/no_more_descriptors.h"
#include "support/patience.h"
#include "support/socket_pair.h"

namespace suture::framing {
namespace {

using namespace std::chrono_literals;
using capnp::rpc::twoparty::Side;
using test::Echo;

class LinkTest : public test::EchoScene {
 protected:
  struct ThreeLinks {
    kj::Own<Link> first, second, third;
  };
  ThreeLinks connectThree() {
    ThreeLinks links{connect(), connect(), connect()};
    EXPECT_EQ(echo(links.second->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
    return links;
  }
  std::string faultOfThird(ThreeLinks& links) {
    auto third = links.third->bootstrap<Echo>();
    return faultOf([&] { echo(third, 1).wait(port_.scope()); });
  }
  /// The server tells the refusal too, and the places of links that end are free again.
  void expectToldAndFree(ThreeLinks& links, const std::string& fault) {
    EXPECT_NE(refusals_.summary().latest.find(fault), std::string::npos)
        << refusals_.summary().latest;
    links.third = nullptr;
    links.first = nullptr;
    EXPECT_EQ(echo(links.second->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
    auto fourth = connect();
    EXPECT_EQ(echo(fourth->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
  }
};
INSTANTIATE_TEST_SUITE_P(Sockets, LinkTest, testing::Values("unix", "tcp"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(LinkTest, CallsReturnWhatTheySent) {
  serve();
  auto link = connect();
  auto client = link->bootstrap<Echo>();
  for (std::size_t size : {0u, 1u, 1000u, 1u << 20}) {
    EXPECT_EQ(echo(client, size).wait(port_.scope()), size);
  }
  EXPECT_GT(link->counters()->sentBytes, 1u << 20);
  EXPECT_GT(link->counters()->receivedBytes, 1u << 20);
}

TEST_P(LinkTest, ManyCallsAtOnceReturn) {
  serve();
  auto link = connect();
  auto client = link->bootstrap<Echo>();
  auto calls = kj::heapArrayBuilder<kj::Promise<std::size_t>>(1000);
  for (std::size_t i = 0; i < 1000; ++i) calls.add(echo(client, i));
  auto sizes = kj::joinPromises(calls.finish()).wait(port_.scope());
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_EQ(sizes[i], i);
}

TEST_P(LinkTest, AFailureArrivesAsItsTextAlone) {
  serve();
  auto link = connect();
  auto request = link->bootstrap<Echo>().failRequest();
  request.setText("the arm is not homed");
  try {
    request.send().ignoreResult().wait(port_.scope());
    FAIL() << "no failure";
  } catch (const kj::Exception& e) {
    EXPECT_EQ(loop::describe(e), "the arm is not homed");
  }
}

TEST_P(LinkTest, AMessageMayExceedItsRoom) {
  serve();
  auto link = connect();
  auto client = link->bootstrap<Echo>();
  auto announced = client.echoRequest(capnp::MessageSize{4000, 0});
  memset(announced.initData(30'000).begin(), 5, 30'000);
  EXPECT_EQ(announced.send().wait(port_.scope()).getData().size(), 30'000u);
  auto failing = client.failRequest();
  const std::string reason(3000, 'x');
  failing.setText(reason);
  try {
    failing.send().ignoreResult().wait(port_.scope());
    FAIL() << "no failure";
  } catch (const kj::Exception& e) {
    EXPECT_EQ(loop::describe(e), reason);
  }
}

TEST_P(LinkTest, AClosingPeerEndsItsCalls) {
  serve();
  auto link = connect();
  auto client = link->bootstrap<Echo>();
  EXPECT_EQ(echo(client, 1).wait(port_.scope()), 1u);
  auto pending = client.neverRequest().send().ignoreResult();
  server_ = nullptr;
  EXPECT_THROW(pending.wait(port_.scope()), kj::Exception);
  link->onDisconnect().wait(port_.scope());
  EXPECT_THROW(echo(client, 1).wait(port_.scope()), kj::Exception);
}

TEST_P(LinkTest, AHostilePeerHurtsNoOthers) {
  serve();
  auto link = connect();
  auto client = link->bootstrap<Echo>();
  auto hostile = net::dial(port_, server_->address(), kPatience).wait(port_.scope());
  sendAll(hostile, std::vector(64, std::byte{0xff}));
  EXPECT_TRUE(closes(port_, hostile));
  EXPECT_EQ(echo(client, 1).wait(port_.scope()), 1u);
}

// Cap'n Proto keeps each answer for as long as its client does.
TEST_P(LinkTest, AnswersThatAPeerKeepsAreBounded) {
  StreamLimits limits = patientLimits();
  limits.answerBytes = 1u << 20;
  serve(kTwo, limits);
  auto link = connect();
  auto client = link->bootstrap<Echo>();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(echo(client, 400'000).wait(port_.scope()), 400'000u);
  std::vector<capnp::Response<Echo::EchoResults>> kept;
  const std::string fault = faultOf([&] {
    for (int i = 0; i < 10; ++i) {
      auto request = client.echoRequest();
      request.initData(400'000);
      kept.push_back(request.send().wait(port_.scope()));
    }
  });
  EXPECT_NE(fault, "");
  EXPECT_EQ(kept.size(), 3u) << "the third may exceed it";
  EXPECT_NE(refusals_.summary().latest.find("the peer keeps more answers than it may"),
            std::string::npos)
      << refusals_.summary().latest;
}

TEST_P(LinkTest, QuestionsAtATimeAreBounded) {
  StreamLimits limits = patientLimits();
  limits.questions = 4;  // one of them asks for the server itself
  serve(kTwo, limits);
  auto link = connect();
  auto client = link->bootstrap<Echo>();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(echo(client, 1).wait(port_.scope()), 1u);
  kj::Vector<kj::Promise<void>> asked;
  for (int i = 0; i < 5; ++i) asked.add(client.neverRequest().send().ignoreResult());
  EXPECT_NE(faultOf([&] { echo(client, 1).wait(port_.scope()); }), "");
  EXPECT_NE(refusals_.summary().latest.find("the peer asks more at a time than it may"),
            std::string::npos)
      << refusals_.summary().latest;
}

TEST_P(LinkTest, APeerBeyondTheLimitIsTold) {
  serve();  // for two at a time
  ThreeLinks links = connectThree();
  const std::string fault = faultOfThird(links);
  EXPECT_NE(fault.find("it has 2 links"), std::string::npos) << fault;
  expectToldAndFree(links, fault);
}

// Plain TCP does not prove who is who, so there all peers share the limit of all.
TEST_P(LinkTest, APeerBeyondItsLimitIsTold) {
  serve({.all = 8, .ofOne = 2});
  ThreeLinks links = connectThree();
  const std::string fault = faultOfThird(links);
  if (server_->address().kind == net::Address::Kind::Tcp) {
    EXPECT_EQ(fault, "");
    return;
  }
  EXPECT_EQ(fault, "talk to " + server_->address().text() + ": 2 of its links are with user " +
                       std::to_string(geteuid()) + ", and no peer has more. End some of them.");
  expectToldAndFree(links, fault);
}

TEST_P(LinkTest, APeerClosedUnansweredIsToldWhy) {
  serve();
  std::vector<kj::Own<Link>> links;
  for (int i = 0; i < 2 + 16; ++i) links.push_back(connect());
  EXPECT_EQ(echo(links[1]->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
  auto bytes = net::reach(port_, server_->address(), {}, "server", kPatience).wait(port_.scope());
  auto closed = kj::heap<Link>(kj::heap<MessageStream>(port_, kj::mv(bytes)), Side::CLIENT);
  const std::string fault =
      faultOf([&] { echo(closed->bootstrap<Echo>(), 1).wait(port_.scope()); });
  EXPECT_TRUE(fault.starts_with("the peer at " + server_->address().text())) << fault;
  EXPECT_TRUE(
      fault.ends_with(" before a word. It may have reached its limit of links: see what it "
                      "says."))
      << fault;
}

TEST_P(LinkTest, FurtherPeersBeyondTheLimitAreClosed) {
  serve();
  std::vector<kj::Own<Link>> links;
  for (int i = 0; i < 2 + 16; ++i) links.push_back(connect());
  EXPECT_EQ(echo(links[1]->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
  auto refused = net::dial(port_, server_->address(), kPatience).wait(port_.scope());
  EXPECT_TRUE(closes(port_, refused));
  EXPECT_EQ(echo(links[1]->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
}

TEST_P(LinkTest, APeerWithoutADescriptorWaits) {
#if defined(SUTURE_ADDRESS_SANITIZER)
  GTEST_SKIP() << "UBSan itself takes a descriptor to look at an object";
#endif
  serve();
  auto first = connect();
  EXPECT_EQ(echo(first->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
  kj::AutoCloseFd socket = connectedSocket();
  auto limit = std::make_unique<NoMoreDescriptors>();
  auto waiting =
      kj::heap<Link>(kj::heap<MessageStream>(port_, net::ByteStream(kj::mv(socket))), Side::CLIENT);
  auto client = waiting->bootstrap<Echo>();
  auto answer = echo(client, 2);
  while (refusals_.summary().count == 0)
    port_.getTimer().afterDelay(1 * kj::MILLISECONDS).wait(port_.scope());
  EXPECT_NE(refusals_.summary().latest.find("Too many open files"), std::string::npos)
      << refusals_.summary().latest;
  EXPECT_NE(refusals_.summary().latest.find("ulimit -n"), std::string::npos);
  limit.reset();
  EXPECT_EQ(answer.wait(port_.scope()), 2u);
}

// A link reads no more of a process that has not said who it is than a first message needs.
TEST_P(LinkTest, AStrangersMessagesAreSmall) {
  knows_ = false;
  serve();
  auto stranger = connect();
  auto client = stranger->bootstrap<Echo>();
  EXPECT_EQ(echo(client, 15'000).wait(port_.scope()), 15'000u);
  const std::string fault = faultOf([&] { echo(client, 17'000).wait(port_.scope()); });
  EXPECT_NE(fault.find("one that has not said who it is"), std::string::npos) << fault;
  EXPECT_NE(refusals_.summary().latest.find(fault), std::string::npos)
      << refusals_.summary().latest;
  knows_ = true;
  auto known = connect();
  EXPECT_EQ(echo(known->bootstrap<Echo>(), 17'000).wait(port_.scope()), 17'000u);
}

// All peers of plain TCP share one budget, as do all processes of one user.
TEST_P(LinkTest, UnfinishedMessagesAreBoundedInSum) {
  serve({.all = 8, .ofOne = 8});
  auto known = connect();
  auto client = known->bootstrap<Echo>();
  EXPECT_EQ(echo(client, 1).wait(port_.scope()), 1u);
  std::vector<net::ByteStream> greedy;  // each begins a message of 16 MiB and does not end it
  std::vector<std::byte> begun(15u << 20, std::byte{0});
  const std::uint32_t words = (16u << 20) / 8 - 2;
  std::memcpy(begun.data() + 4, &words, sizeof(words));
  const auto beginAnother = [&] {
    greedy.push_back(net::dial(port_, server_->address(), kPatience).wait(port_.scope()));
    sendWhole(greedy.back().socket(), begun);
  };
  for (int held = 0; held < 4; ++held) beginAnother();
  EXPECT_EQ(refusals_.summary().count, 0u);
  beginAnother();
  // The kernel takes the last megabytes of a message before the server has read them.
  const Time end = now() + suture::kPatience;
  while (refusals_.summary().count == 0 && now() < end)
    port_.getTimer().afterDelay(1 * kj::MILLISECONDS).wait(port_.scope());
  EXPECT_NE(refusals_.summary().latest.find("67108864 bytes"), std::string::npos)
      << refusals_.summary().latest;
  EXPECT_EQ(echo(client, 1).wait(port_.scope()), 1u);
}

TEST_P(LinkTest, NoListenerIsAnError) {
  serve();
  const net::Address address = server_->address();
  server_ = nullptr;
  const std::string text = dialFault(address);
  EXPECT_NE(text.find("connect to " + address.text()), std::string::npos) << text;
  EXPECT_NE(text.find("Start the process"), std::string::npos) << text;
}

}  // namespace
}  // namespace suture::framing
