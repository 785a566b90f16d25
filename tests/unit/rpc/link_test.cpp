// Listener, dialer and link with real sockets, both ends on one event loop.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <suture/base/sanitizers.h>
#include <suture/framing/link_server.h>
#include <suture/loop/failure.h>
#include <suture/net/dialer.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "echo_server.h"
#include "socket_pair.h"
#include "support/contains.h"
#include "support/no_more_descriptors.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/refused_call.h"
#include "support/temporary_directory.h"

namespace suture::rpc {
namespace {

using namespace std::chrono_literals;
using capnp::rpc::twoparty::Side;
using test::Echo;

class LinkTest : public testing::TestWithParam<const char*> {
 public:
  ~LinkTest() noexcept override {}

 protected:
  std::string freshAddress() {
    return std::string(GetParam()) == "unix" ? "unix:" + directory_.file("s") : "tcp://127.0.0.1:0";
  }

  /// A busy machine may take any time to send what a test sends.
  static StreamLimits patientLimits() {
    constexpr std::int64_t kPatience = 600'000;
    return {.partialMilliseconds = kPatience,
            .firstMilliseconds = kPatience,
            .handshakeMilliseconds = kPatience,
            .helloMilliseconds = kPatience};
  }

  void serve(std::size_t maxLinks = 2) {
    server_ = kj::heap<LinkServer>(
        port_, Address::parse(freshAddress()),
        [this](auto&& caller) -> capnp::Capability::Client {
          caller->known = knows_;
          return Echo::Client(kj::heap<EchoServer>());
        },
        refusals_, patientLimits(), maxLinks);
  }

  kj::Own<Link> connect() {
    auto socket = dial(port_, server_->address(), kPatience).wait(port_.scope());
    return kj::heap<Link>(kj::heap<MessageStream>(port_, kj::mv(socket)), Side::CLIENT);
  }

  /// Connects a socket to the server, which has not accepted it.
  kj::AutoCloseFd connectedSocket() {
    const SocketAddress target(server_->address());
    kj::AutoCloseFd socket(::socket(target.family(), SOCK_STREAM | SOCK_CLOEXEC, 0));
    EXPECT_EQ(::connect(socket, target.get(), target.length), 0) << std::strerror(errno);
    fcntl(socket, F_SETFL, O_NONBLOCK);
    return socket;
  }

  /// The server runs meanwhile.
  void sendWhole(int socket, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t count = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (count < 0 && errno != EAGAIN) return;
      if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
      port_.scope().poll();
    }
  }

  template <class Work>
  std::string faultOf(Work work) {
    try {
      work();
    } catch (const kj::Exception& e) {
      return describe(e);
    }
    return "";
  }

  std::string dialFault(const Address& address) {
    try {
      dial(port_, address, 1s).wait(port_.scope());
    } catch (const kj::Exception& e) {
      return describe(e);
    }
    return "connected";
  }

  TemporaryDirectory directory_;
  EventPort port_;
  bool knows_ = true;
  Refusals refusals_{"server"};
  kj::Own<LinkServer> server_;
};

INSTANTIATE_TEST_SUITE_P(Sockets, LinkTest, testing::Values("unix", "tcp"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(LinkTest, CallsReturn) {
  serve();
  auto link = connect();
  auto client = link->bootstrap<Echo>();
  for (std::size_t size : {0u, 1u, 1000u, 1u << 20}) {
    EXPECT_EQ(echo(client, size).wait(port_.scope()), size);
  }
  EXPECT_GT(link->counters()->sentBytes, 1u << 20);
  EXPECT_GT(link->counters()->receivedBytes, 1u << 20);
}

TEST_P(LinkTest, ManyCallsInFlight) {
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
    EXPECT_EQ(describe(e), "the arm is not homed");
  }
}

TEST_P(LinkTest, AMessageMayBeLargerThanItsRoom) {
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
    EXPECT_EQ(describe(e), reason);
  }
}

TEST_P(LinkTest, APeerThatClosesEndsCallsAndTheLink) {
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

TEST_P(LinkTest, AHostilePeerIsCutOffAndOthersAreServed) {
  serve();
  auto link = connect();
  auto client = link->bootstrap<Echo>();
  auto hostile = dial(port_, server_->address(), kPatience).wait(port_.scope());
  sendAll(hostile, std::vector(64, std::byte{0xff}));
  EXPECT_TRUE(closes(port_, hostile));
  EXPECT_EQ(echo(client, 1).wait(port_.scope()), 1u);
}

TEST_P(LinkTest, APeerBeyondTheLimitIsTold) {
  serve();  // for two at a time
  auto first = connect();
  auto second = connect();
  auto third = connect();
  EXPECT_EQ(echo(second->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
  const std::string fault = faultOf([&] { echo(third->bootstrap<Echo>(), 1).wait(port_.scope()); });
  EXPECT_NE(fault.find("it has 2 links"), std::string::npos) << fault;
  EXPECT_NE(refusals_.summary().latest.find(fault), std::string::npos)
      << refusals_.summary().latest;
  third = nullptr;
  first = nullptr;
  EXPECT_EQ(echo(second->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
  auto fourth = connect();
  EXPECT_EQ(echo(fourth->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
}

TEST_P(LinkTest, FurtherPeersBeyondTheLimitAreClosed) {
  serve();
  std::vector<kj::Own<Link>> links;
  for (int i = 0; i < 2 + 16; ++i) links.push_back(connect());
  EXPECT_EQ(echo(links[1]->bootstrap<Echo>(), 1).wait(port_.scope()), 1u);
  auto refused = dial(port_, server_->address(), kPatience).wait(port_.scope());
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
      kj::heap<Link>(kj::heap<MessageStream>(port_, ByteStream(kj::mv(socket))), Side::CLIENT);
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
TEST_P(LinkTest, UnfinishedMessagesOfAPeerAreBoundedInSum) {
  serve(8);
  auto known = connect();
  auto client = known->bootstrap<Echo>();
  EXPECT_EQ(echo(client, 1).wait(port_.scope()), 1u);
  std::vector<ByteStream> greedy;  // each begins a message of 16 MiB and does not end it
  std::vector<std::byte> begun(15u << 20, std::byte{0});
  const std::uint32_t words = (16u << 20) / 8 - 2;
  std::memcpy(begun.data() + 4, &words, sizeof(words));
  const auto beginAnother = [&] {
    greedy.push_back(dial(port_, server_->address(), kPatience).wait(port_.scope()));
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

TEST_P(LinkTest, AnAddressInUseIsRefused) {
  serve();
  try {
    Listener second(port_, server_->address());
    FAIL() << "bound twice";
  } catch (const SetupError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find(server_->address().text()), std::string::npos) << text;
    EXPECT_NE(text.find("another process listens"), std::string::npos) << text;
  }
  auto link = connect();
  EXPECT_EQ(echo(link->bootstrap<Echo>(), 3).wait(port_.scope()), 3u);
}

/// Fills the queue of a listener with connections, whose peers say nothing.
std::vector<kj::AutoCloseFd> queueAt(const Address& address, std::size_t count) {
  const SocketAddress target(address);
  std::vector<kj::AutoCloseFd> sockets;
  while (sockets.size() < count) {
    sockets.emplace_back(::socket(target.family(), SOCK_STREAM | SOCK_CLOEXEC, 0));
    EXPECT_EQ(::connect(sockets.back(), target.get(), target.length), 0) << std::strerror(errno);
  }
  return sockets;
}

// Who connects faster than connections are accepted must not keep the loop from its other sockets.
TEST_P(LinkTest, ACrowdLeavesTheOthersTheirTurns) {
  constexpr std::size_t kCrowd = 120;
  Listener listener(port_, Address::parse(freshAddress()));
  const auto crowd = queueAt(listener.address(), kCrowd);
  SocketPair other = makeSocketPair();
  EventPort::FdObserver observer(port_, other.ours, EventPort::FdObserver::OBSERVE_READ);
  std::vector<kj::AutoCloseFd> accepted;
  auto all = kj::newPromiseAndFulfiller<void>();
  std::size_t before = 0;
  auto heard = observer.whenBecomesReadable()
                   .then([&] { before = accepted.size(); })
                   .eagerlyEvaluate(nullptr);
  auto listening = listener
                       .listen([&](kj::AutoCloseFd socket) {
                         if (accepted.empty()) sendText(other.theirs, "x");
                         accepted.push_back(kj::mv(socket));
                         if (accepted.size() == kCrowd) all.fulfiller->fulfill();
                       })
                       .eagerlyEvaluate(nullptr);
  all.promise.wait(port_.scope());
  heard.wait(port_.scope());
  EXPECT_GT(before, 0u);
  EXPECT_LT(before, kCrowd);
}

/// Returns what a server says the second time that the kernel refuses it a connection with `error`.
std::string toldWhenRefused(const Address& address, int error) {
  EventPort port;
  Refusals refusals("server");
  const LinkServer server(
      port, address,
      [](auto&&) -> capnp::Capability::Client { return Echo::Client(kj::heap<EchoServer>()); },
      refusals);
  refuseCall(SYS_accept4, error);
  const auto crowd = queueAt(server.address(), 1);
  const Time end = now() + suture::kPatience;
  while (refusals.summary().count < 2 && now() < end)
    port.getTimer().afterDelay(1 * kj::MILLISECONDS).wait(port.scope());
  return refusals.summary().latest;
}

// A rule of a firewall, or a network that goes down, refuses for a while.
TEST_P(LinkTest, AServerComesBackWhateverTheKernelRefuses) {
  const std::string wait = ": wait until this process can accept connections again: ";
  const std::pair<int, std::string> cases[] = {
      {EPERM, "Operation not permitted. Look what keeps this machine from it: its network, a"},
      {ENETDOWN, "Network is down. Look what keeps this machine from it"},
      {EMFILE, "Too many open files. Raise its limit (ulimit -n)"}};
  for (const auto& [error, words] : cases) {
    std::string told;
    std::thread([&, refused = error] {  // what is refused to a thread stays so
      told = toldWhenRefused(Address::parse(freshAddress()), refused);
    })
        .join();
    EXPECT_TRUE(contains(told, wait + words)) << told;
  }
}

TEST(Listener, APlainFileAtTheAddressIsAnError) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("s");
  std::ofstream(path) << "somebody's notes";
  EventPort port;
  try {
    Listener listener(port, Address::parse("unix:" + path));
    FAIL() << "a file was taken for a socket";
  } catch (const SetupError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("unix:" + path), std::string::npos) << text;
    EXPECT_NE(text.find("a file that is no socket"), std::string::npos) << text;
    EXPECT_NE(text.find("Remove it"), std::string::npos) << text;
  }
  EXPECT_TRUE(std::ifstream(path).good()) << "the file was taken away";
}

TEST_P(LinkTest, NoListenerIsAnError) {
  serve();
  const Address address = server_->address();
  server_ = nullptr;
  const std::string text = dialFault(address);
  EXPECT_NE(text.find("connect to " + address.text()), std::string::npos) << text;
  EXPECT_NE(text.find("Start the process"), std::string::npos) << text;
}

TEST_P(LinkTest, TheRealPortIsReported) {
  serve();
  if (server_->address().kind == Address::Kind::Tcp) {
    EXPECT_NE(server_->address().port, 0);
  }
}

class UnixListenerTest : public LinkTest {};
INSTANTIATE_TEST_SUITE_P(Sockets, UnixListenerTest, testing::Values("unix"));

TEST_P(UnixListenerTest, TheSocketFileIsPrivateAndRemoved) {
  serve();
  const std::string path = server_->address().path;
  struct stat status {};
  ASSERT_EQ(stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  server_ = nullptr;
  EXPECT_NE(stat(path.c_str(), &status), 0);
}

TEST_P(UnixListenerTest, AStaleSocketFileIsReplaced) {
  const Address address = Address::parse(freshAddress());
  {
    const kj::AutoCloseFd dead(socket(AF_UNIX, SOCK_STREAM, 0));
    const SocketAddress target(address);
    ASSERT_EQ(bind(dead, target.get(), target.length), 0);
  }
  serve();
  auto link = connect();
  EXPECT_EQ(echo(link->bootstrap<Echo>(), 3).wait(port_.scope()), 3u);
}

TEST(Listening, WhereTheKernelRefusesIsAnError) {
  EventPort port;
  const auto refused = [&](const char* address) {
    return refusal([&] { Listener(port, Address::parse(address)); });
  };
  EXPECT_EQ(refused("unix:/nowhere/at/all.sock"),
            "listen at unix:/nowhere/at/all.sock: No such file or directory. Check that the "
            "directory exists and is yours.");
  EXPECT_EQ(refused("tls://192.0.2.1:7700"),
            "listen at tls://192.0.2.1:7700: Cannot assign requested address. Choose another "
            "address or port.");
}

TEST_P(UnixListenerTest, AnOrdinaryFileIsNotTouched) {
  const Address address = Address::parse(freshAddress());
  std::ofstream(address.path) << "notes";
  EXPECT_TRUE(contains(refusal([&] { Listener(port_, address); }),
                       "there is a file that is no socket. Remove it, or choose"));
  std::string content;
  std::ifstream(address.path) >> content;
  EXPECT_EQ(content, "notes");
}

TEST_P(UnixListenerTest, AMissingDirectoryIsAnError) {
  try {
    const Listener listener(port_, Address::parse("unix:/nonexistent/s"));
    FAIL() << "listens in a directory that does not exist";
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("directory"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace suture::rpc
