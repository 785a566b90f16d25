// These tests make links between processes of which some can prove who they are and some cannot.

#include <gtest/gtest.h>
#include <suture/framing/link_server.h>
#include <suture/loop/deadline.h>
#include <suture/net/dialer.h>
#include <suture/net/tls/key_maker.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "echo_server.h"
#include "support/contains.h"
#include "support/other_user.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/socket_pair.h"
#include "support/temporary_directory.h"

namespace suture::framing {
namespace {

using namespace std::chrono_literals;
using capnp::rpc::twoparty::Side;
using test::Echo;

class SecureLinkTest : public testing::Test {
 public:
  SecureLinkTest() {
    tls::makeKeys(keys_, {"server", "client"});
    // A slow machine keeps these deadlines, and the tests that wait for them to pass are fast.
    limits_.handshakeMilliseconds = 1000;
    limits_.helloMilliseconds = 1000;
  }
  ~SecureLinkTest() noexcept override {}

 protected:
  net::Trust trustOf(const std::string& process) const {
    return {.keys = std::make_shared<const tls::Keys>(keys_, process)};
  }
  std::string unixAddress() const { return "unix:" + directory_.file("s"); }

  void serve(const std::string& address, const net::Trust& trust) {
    server_ = kj::heap<LinkServer>(
        port_, net::Address::parse(address),
        [this](std::shared_ptr<Caller> caller) -> capnp::Capability::Client {
          caller->known = knows_;
          last_ = caller->identity;
          return Echo::Client(kj::heap<EchoServer>());
        },
        refusals_, limits_, links_, trust);
  }
  void serveTls() { serve("tls://127.0.0.1:0", trustOf("server")); }

  kj::Own<Link> linkOn(net::ByteStream bytes) {
    return kj::heap<Link>(kj::heap<MessageStream>(port_, kj::mv(bytes)), Side::CLIENT);
  }
  kj::Own<Link> connect(const net::Trust& trust, const std::string& expected = "server") {
    return linkOn(
        net::reach(port_, server_->address(), trust, expected, kPatience).wait(port_.scope()));
  }
  /// Returns what a call over `link` fails with.
  std::string callFault(Link& link) {
    try {
      echo(link.bootstrap<Echo>(), 1).wait(port_.scope());
    } catch (const kj::Exception& e) {
      return loop::describe(e);
    }
    return "answered";
  }
  std::string reachFault(const net::Address& address, const net::Trust& trust,
                         const std::string& expected) {
    try {
      net::reach(port_, address, trust, expected, kPatience).wait(port_.scope());
    } catch (const kj::Exception& e) {
      return loop::describe(e);
    }
    return "connected";
  }
  kj::AutoCloseFd dialServer() {
    return net::dial(port_, server_->address(), kPatience).wait(port_.scope());
  }
  bool closesSoon(Link& link) {
    auto late = port_.getTimer().afterDelay(loop::toKj(kPatience)).then([] { return false; });
    auto gone = link.onDisconnect().then([] { return true; });
    return gone.exclusiveJoin(kj::mv(late)).wait(port_.scope());
  }
  std::size_t echoed(Link& link, std::size_t size) {
    return echo(link.bootstrap<Echo>(), size).wait(port_.scope());
  }

  const TemporaryDirectory directory_;
  const std::filesystem::path keys_ = directory_.path() / "keys";
  StreamLimits limits_;
  LinkLimits links_{.all = 3, .ofOne = 3};
  bool knows_ = true;
  net::PeerIdentity last_;
  loop::EventPort port_;
  net::Refusals refusals_{"server"};
  kj::Own<LinkServer> server_;
};

TEST_F(SecureLinkTest, APeerWithoutTlsIsNotAwaited) {
  auto pair = makeSocketPair();
  const std::string error = refusal([&] {
    net::handshake(port_, kj::mv(pair.ours), trustOf("client").keys, tls::Session::Side::Client,
                   std::chrono::milliseconds(1))
        .wait(port_.scope());
  });
  EXPECT_TRUE(contains(error, "it did not finish the TLS handshake in time.")) << error;
}

TEST_F(SecureLinkTest, CallsOfAnySizeReturn) {
  serveTls();
  auto link = connect(trustOf("client"));
  for (const std::size_t size : {0u, 1u, 1000u, 16'384u, 100'000u, 8u << 20}) {
    EXPECT_EQ(echoed(*link, size), size);
  }
  EXPECT_EQ(last_.proof, net::PeerIdentity::Proof::Certificate);
  EXPECT_EQ(last_.process, "client");
}

TEST_F(SecureLinkTest, ManyCallsAtOnceReturn) {
  serveTls();
  auto link = connect(trustOf("client"));
  auto client = link->bootstrap<Echo>();
  auto calls = kj::heapArrayBuilder<kj::Promise<std::size_t>>(1000);
  for (std::size_t i = 0; i < 1000; ++i) calls.add(echo(client, i * 37));
  auto sizes = kj::joinPromises(calls.finish()).wait(port_.scope());
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_EQ(sizes[i], i * 37);
}

TEST_F(SecureLinkTest, AnUnexpectedProcessGetsNoLink) {
  serveTls();
  const std::string fault = reachFault(server_->address(), trustOf("client"), "PSM");
  EXPECT_TRUE(contains(fault, "it has the certificate of process 'server', and 'PSM' is expected"))
      << fault;
}

TEST_F(SecureLinkTest, WithoutKeysThereIsNoTls) {
  const std::string dialled = refusal(
      [&] { net::reach(port_, net::Address::parse("tls://127.0.0.1:7"), {}, "server", 1s); });
  EXPECT_TRUE(contains(dialled, "this process has no keys")) << dialled;
  const std::string served = refusal([&] { serve("tls://127.0.0.1:0", {}); });
  EXPECT_TRUE(contains(served, "this process has no keys")) << served;
}

TEST_F(SecureLinkTest, AnotherSystemsCertificateGetsNoLink) {
  serveTls();
  const auto other = directory_.path() / "other";
  tls::makeKeys(other, {"client"});
  const net::Trust stranger{.keys = std::make_shared<const tls::Keys>(other, "client")};
  const std::string fault = reachFault(server_->address(), stranger, "server");
  EXPECT_TRUE(contains(fault, "is not signed by this system's CA")) << fault;
  EXPECT_EQ(last_.process, "") << "nothing was offered to it";
}

TEST_F(SecureLinkTest, ATlsPortTellsAPlainClient) {
  serveTls();
  auto link = linkOn(dialServer());
  const std::string fault = callFault(*link);
  EXPECT_TRUE(contains(fault, "it speaks TLS, and this end does not")) << fault;
  EXPECT_EQ(echoed(*connect(trustOf("client")), 1), 1u) << "and others are served";
}

TEST_F(SecureLinkTest, APlainPortTellsATlsClient) {
  serve("tcp://127.0.0.1:0", {});
  net::Address address = server_->address();
  address.kind = net::Address::Kind::Tls;
  const std::string fault = reachFault(address, trustOf("client"), "server");
  EXPECT_TRUE(contains(fault, "it does not speak TLS")) << fault;
}

TEST_F(SecureLinkTest, GarbageHurtsNoOther) {
  serveTls();
  auto link = connect(trustOf("client"));
  const std::string garbage[] = {std::string(64, '\xff'), std::string(64, '\0'),
                                 "GET / HTTP/1.1\r\n\r\n",
                                 std::string("\x16\x03\x01\xff\xff", 5) + std::string(70'000, 'x')};
  for (const std::string& said : garbage) {
    auto hostile = dialServer();
    sendText(hostile, said);
    EXPECT_TRUE(closes(port_, hostile)) << said.substr(0, 5);
    EXPECT_EQ(echoed(*link, 1), 1u);
  }
}

TEST_F(SecureLinkTest, HalfAHandshakeEndsInTime) {
  serveTls();
  kj::Vector<kj::AutoCloseFd> held;
  for (int i = 0; i < 3; ++i) {  // as many as there may be links
    held.add(dialServer());
    sendText(held.back(), std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11));
  }
  const Time begin = now();
  for (const auto& socket : held) EXPECT_TRUE(closes(port_, socket));
  EXPECT_GE(now() - begin, 900ms) << "they were closed for another reason";
  EXPECT_EQ(echoed(*connect(trustOf("client")), 1), 1u) << "their places are free again";
}

TEST_F(SecureLinkTest, LeakedLinksShutOutNoOther) {
  links_ = {.all = 24, .ofOne = 2};
  serveTls();
  std::vector<kj::Own<Link>> leaked;
  for (int i = 0; i < 30; ++i) leaked.push_back(connect(trustOf("client")));
  EXPECT_EQ(echoed(*leaked[1], 1), 1u);
  EXPECT_EQ(echoed(*connect(trustOf("server")), 1), 1u) << "another peer has places of its own";
  EXPECT_EQ(callFault(*leaked[2]),
            "talk to " + server_->address().text() +
                ": 2 of its links are with process 'client', and no peer has more. End some of "
                "them.");
  const std::string closed = callFault(*leaked[29]);
  EXPECT_TRUE(contains(closed, "the peer at " + server_->address().text())) << closed;
  EXPECT_TRUE(contains(closed, " before a word. It may have reached its limit of links")) << closed;
  EXPECT_TRUE(contains(refusals_.summary().latest, "are with process 'client'"));
  leaked.clear();
  EXPECT_EQ(echoed(*connect(trustOf("client")), 1), 1u) << "its places are free again";
}

TEST_F(SecureLinkTest, AHandshakeClosedUnansweredIsToldWhy) {
  links_ = {.all = 1, .ofOne = 1};
  limits_.handshakeMilliseconds = 600'000;  // these hold their places
  serveTls();
  kj::Vector<kj::AutoCloseFd> held;
  for (int i = 0; i < 1 + 16; ++i) held.add(dialServer());
  const std::string fault = reachFault(server_->address(), trustOf("client"), "server");
  EXPECT_TRUE(contains(fault, "It may have reached its limit of links: see what it says."))
      << fault;
}

TEST_F(SecureLinkTest, ASilentPeerIsClosedAfterHandshake) {
  knows_ = false;
  serveTls();
  auto link = connect(trustOf("client"));
  EXPECT_EQ(echoed(*link, 1), 1u);  // this does not say who the peer is
  EXPECT_TRUE(closesSoon(*link));
  EXPECT_NE(callFault(*link), "answered");
  const std::string told = refusals_.summary().latest;
  EXPECT_TRUE(
      contains(told, "see what that process does: it sends messages, and has not said who it is"))
      << told;
}

TEST_F(SecureLinkTest, AKnownPeerStays) {
  serve(unixAddress(), {});
  auto link = connect({});
  EXPECT_EQ(echoed(*link, 1), 1u);
  knows_ = false;
  auto stranger = connect({});
  EXPECT_EQ(echoed(*stranger, 1), 1u);
  EXPECT_TRUE(closesSoon(*stranger)) << "that is how long a peer may take to be known";
  EXPECT_EQ(echoed(*link, 1), 1u);
  EXPECT_EQ(last_.proof, net::PeerIdentity::Proof::User);
  EXPECT_EQ(last_.user, geteuid());
}

TEST_F(SecureLinkTest, AnotherUserHearsTheReason) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root, to be somebody else";
  for (const bool trusted : {false, true}) {
    serve(unixAddress(), {.keys = nullptr, .users = {trusted ? kNobody : kNobody - 1}});
    std::filesystem::permissions(directory_.path(), std::filesystem::perms::all);
    kj::AutoCloseFd socket;
    asNobody([&] {
      socket = kj::AutoCloseFd(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0));
      const net::SocketAddress target(server_->address());
      ASSERT_EQ(::connect(socket, target.get(), target.length), 0) << strerror(errno);
    });
    auto link = linkOn(kj::mv(socket));
    const std::string fault = callFault(*link);
    EXPECT_EQ(fault == "answered", trusted) << fault;
    if (!trusted) {
      EXPECT_TRUE(contains(fault, "it does not talk to user 65534")) << fault;
    }
    server_ = nullptr;
  }
}

TEST_F(SecureLinkTest, ASocketOfAnotherUserIsLeft) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root, to be somebody else";
  std::filesystem::permissions(directory_.path(), std::filesystem::perms::all);
  const net::Address address = net::Address::parse(unixAddress());
  kj::AutoCloseFd squatter(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0));
  asNobody([&] {
    const net::SocketAddress target(address);
    ASSERT_EQ(bind(squatter, target.get(), target.length), 0);
    ASSERT_EQ(listen(squatter, 5), 0);
  });
  const std::string fault = reachFault(address, {}, "server");
  EXPECT_TRUE(contains(fault, "it is run by user 65534")) << fault;
  EXPECT_EQ(reachFault(address, {.keys = nullptr, .users = {kNobody}}, "server"), "connected");
}

}  // namespace
}  // namespace suture::framing
