// A server listens where it is told, and goes on when the kernel refuses.

#include <gtest/gtest.h>
#include <suture/net/listener.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <fcntl.h>

#include <atomic>
#include <barrier>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "echo_scene.h"
#include "support/contains.h"
#include "support/refusal.h"
#include "support/refused_call.h"
#include "support/socket_pair.h"

namespace suture::framing {
namespace {

using namespace std::chrono_literals;
using test::Echo;

class ListenerTest : public test::EchoScene {};
INSTANTIATE_TEST_SUITE_P(Sockets, ListenerTest, testing::Values("unix", "tcp"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(ListenerTest, AnAddressInUseIsRefused) {
  serve();
  try {
    net::Listener second(port_, server_->address());
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
std::vector<kj::AutoCloseFd> queueAt(const net::Address& address, std::size_t count) {
  const net::SocketAddress target(address);
  std::vector<kj::AutoCloseFd> sockets;
  while (sockets.size() < count) {
    sockets.emplace_back(::socket(target.family(), SOCK_STREAM | SOCK_CLOEXEC, 0));
    EXPECT_EQ(::connect(sockets.back(), target.get(), target.length), 0) << std::strerror(errno);
  }
  return sockets;
}

// A crowd that connects faster than connections are accepted must not keep the loop from its other
// sockets.
TEST_P(ListenerTest, ACrowdLeavesTheOthersTheirTurns) {
  constexpr std::size_t kCrowd = 120;
  net::Listener listener(port_, net::Address::parse(freshAddress()));
  const auto crowd = queueAt(listener.address(), kCrowd);
  SocketPair other = makeSocketPair();
  loop::EventPort::FdObserver observer(port_, other.ours,
                                       loop::EventPort::FdObserver::OBSERVE_READ);
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

/// Returns what a server says the second time that the kernel refuses it a connection with
/// `error`.
std::string toldWhenRefused(const net::Address& address, int error) {
  loop::EventPort port;
  net::Refusals refusals("server");
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
TEST_P(ListenerTest, AServerOutlivesTheKernelsRefusals) {
  const std::string wait = ": wait until this process can accept connections again: ";
  const std::pair<int, std::string> cases[] = {
      {EPERM, "Operation not permitted. Look what keeps this machine from it: its network, a"},
      {ENETDOWN, "Network is down. Look what keeps this machine from it"},
      {EMFILE, "Too many open files. Raise its limit (ulimit -n)"}};
  for (const auto& [error, words] : cases) {
    std::string told;
    std::thread([&, refused = error] {  // what is refused to a thread stays so
      told = toldWhenRefused(net::Address::parse(freshAddress()), refused);
    })
        .join();
    EXPECT_TRUE(contains(told, wait + words)) << told;
  }
}

TEST(Listener, APlainFileIsAnError) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("s");
  std::ofstream(path) << "somebody's notes";
  loop::EventPort port;
  try {
    net::Listener listener(port, net::Address::parse("unix:" + path));
    FAIL() << "a file was taken for a socket";
  } catch (const SetupError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("unix:" + path), std::string::npos) << text;
    EXPECT_NE(text.find("a file that is no socket"), std::string::npos) << text;
    EXPECT_NE(text.find("Remove it"), std::string::npos) << text;
  }
  EXPECT_TRUE(std::ifstream(path).good()) << "the file was taken away";
}

TEST_P(ListenerTest, TheRealPortIsReported) {
  serve();
  if (server_->address().kind == net::Address::Kind::Tcp) {
    EXPECT_NE(server_->address().port, 0);
  }
}

class UnixListenerTest : public test::EchoScene {};
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

/// Binds a socket, at which nobody listens yet.
kj::AutoCloseFd boundAt(const net::Address& address) {
  kj::AutoCloseFd bound(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const net::SocketAddress target(address);
  EXPECT_EQ(bind(bound, target.get(), target.length), 0) << std::strerror(errno);
  return bound;
}

TEST_P(UnixListenerTest, AStaleSocketFileIsReplaced) {
  const net::Address address = net::Address::parse(freshAddress());
  boundAt(address) = nullptr;
  serve();
  auto link = connect();
  EXPECT_EQ(echo(link->bootstrap<Echo>(), 3).wait(port_.scope()), 3u);
}

// A socket that is bound, and at which nobody listens yet, looks like one that was left behind.
TEST_P(UnixListenerTest, ABoundSocketIsLeftAlone) {
  const net::Address address = net::Address::parse(freshAddress());
  const std::string lock = address.path + ".bind";
  kj::AutoCloseFd held(open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  ASSERT_EQ(flock(held, LOCK_EX), 0);
  const kj::AutoCloseFd beginning = boundAt(address);
  EXPECT_TRUE(contains(refusal([&] { net::Listener(port_, address); }),
                       "another process listens there. Stop it, or choose another"));
  struct stat status {};
  EXPECT_EQ(stat(address.path.c_str(), &status), 0) << "its socket was taken away";
  held = nullptr;
  const net::Listener listener(port_, address);  // it has died
  EXPECT_NE(stat(lock.c_str(), &status), 0) << "the lock stays behind";
}

// Users name their own files.
TEST_P(UnixListenerTest, AUsersLockIsLeftAlone) {
  const net::Address address = net::Address::parse(freshAddress());
  std::ofstream(address.path + ".lock") << "notes";
  { const net::Listener listener(port_, address); }
  std::string content;
  std::ifstream(address.path + ".lock") >> content;
  EXPECT_EQ(content, "notes");
}

TEST_P(UnixListenerTest, AFailedLockSaysWhy) {
  const net::Address address = net::Address::parse(freshAddress());
  std::filesystem::create_directory(address.path + ".bind");
  EXPECT_TRUE(
      contains(refusal([&] { net::Listener(port_, address); }), "Is a directory. Check that"));
}

// Each of several may find that nobody answers, before the first of them listens.
TEST_P(UnixListenerTest, OneReplacesAStaleSocketFile) {
  constexpr int kRounds = 100, kThreads = 4;
  for (int round = 0; round < kRounds; ++round) {
    const net::Address address = net::Address::parse(freshAddress());
    boundAt(address) = nullptr;
    std::barrier together(kThreads);
    std::atomic<int> listening{0};
    std::vector<std::jthread> threads;
    for (int i = 0; i < kThreads; ++i) {
      threads.emplace_back([&] {
        loop::EventPort port;
        std::unique_ptr<net::Listener> listener;
        together.arrive_and_wait();
        refusal([&] { listener = std::make_unique<net::Listener>(port, address); });
        if (listener != nullptr) ++listening;
        together.arrive_and_wait();  // else one could come after another has gone
      });
    }
    threads.clear();
    ASSERT_EQ(listening, 1) << "in round " << round;
  }
}

TEST(Listening, WhereTheKernelRefusesIsAnError) {
  loop::EventPort port;
  const auto refused = [&](const char* address) {
    return refusal([&] { net::Listener(port, net::Address::parse(address)); });
  };
  EXPECT_EQ(refused("unix:/nowhere/at/all.sock"),
            "listen at unix:/nowhere/at/all.sock: No such file or directory. Check that the "
            "directory exists and is yours.");
  EXPECT_EQ(refused("tls://192.0.2.1:7700"),
            "listen at tls://192.0.2.1:7700: Cannot assign requested address. Choose another "
            "address or port.");
}

TEST_P(UnixListenerTest, AnOrdinaryFileIsNotTouched) {
  const net::Address address = net::Address::parse(freshAddress());
  std::ofstream(address.path) << "notes";
  EXPECT_TRUE(contains(refusal([&] { net::Listener(port_, address); }),
                       "there is a file that is no socket. Remove it, or choose"));
  std::string content;
  std::ifstream(address.path) >> content;
  EXPECT_EQ(content, "notes");
}

TEST_P(UnixListenerTest, AMissingDirectoryIsAnError) {
  try {
    const net::Listener listener(port_, net::Address::parse("unix:/nonexistent/s"));
    FAIL() << "listens in a directory that does not exist";
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("directory"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace suture::framing
