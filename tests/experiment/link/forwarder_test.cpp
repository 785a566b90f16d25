// These test what packets meet on a link, and what the kernel's TCP makes of it.

#include "experiment/link/forwarder.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <future>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "support/eventually.h"

namespace experiment {
namespace {

using namespace std::chrono_literals;
using suture::Time;

constexpr const char* kHere = "10.213.8.1";
constexpr const char* kThere = "10.213.8.2";
constexpr std::uint16_t kPort = 7700;

bool permitted() { return geteuid() == 0 && access("/dev/net/tun", R_OK | W_OK) == 0; }

sockaddr_in addressOf(const char* host) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(kPort);
  inet_pton(AF_INET, host, &address.sin_addr);
  return address;
}

/// This is a socket of that end, bound to its address. A receipt waits no longer than a test's
/// patience.
class Socket {
 public:
  Socket(const LinkEnd& end, int type, const char* host) {
    const auto open = [&] {
      end.enter();
      return socket(AF_INET, type, 0);
    };
    descriptor = std::async(std::launch::async, open).get();
    const int on = 1;
    const timeval patience{.tv_sec = suture::kPatience / 1s, .tv_usec = 0};
    const sockaddr_in address = addressOf(host);
    setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
    setsockopt(descriptor, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
    EXPECT_EQ(bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  }
  ~Socket() { close(descriptor); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  void connectTo(const char* host) const {
    const sockaddr_in address = addressOf(host);
    EXPECT_EQ(connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0)
        << std::strerror(errno);
  }

  int descriptor;
};

/// A LiveLink is a link with a thread that forwards for as long as it lives.
class LiveLink {
 public:
  explicit LiveLink(const PacketFate& fate)
      : forwarder(here, there, fate), thread_([this] { forwarder.runUntil(end_); }) {}
  ~LiveLink() {
    eventfd_write(end_, 1);
    thread_.join();
    close(end_);
  }
  LiveLink(const LiveLink&) = delete;
  LiveLink& operator=(const LiveLink&) = delete;

  LinkEnd here{kHere, kThere}, there{kThere, kHere};
  Forwarder forwarder;

 private:
  const int end_ = eventfd(0, EFD_CLOEXEC);
  std::thread thread_;
};

struct Datagram {
  std::uint32_t number;
  Time sent;
};

/// Sends numbered datagrams from here to there.
class Datagrams {
 public:
  explicit Datagrams(LiveLink& link) : link_(link) { from_.connectTo(kThere); }

  void send() {
    const Datagram one{++sent_, suture::now()};
    ASSERT_EQ(::send(from_.descriptor, &one, sizeof(one), 0), ssize_t{sizeof(one)});
  }
  /// Waits until all that have been sent have been taken, and have arrived or are lost.
  bool settled() const {
    const PacketCounts& counts = link_.forwarder.thereCounts();
    return suture::eventually(
        [&] { return counts.taken == sent_ && counts.delivered + counts.lost == counts.taken; });
  }
  /// Takes what has arrived, or the next that does.
  bool receive(Datagram& one, int flags) const {
    return recv(to_.descriptor, &one, sizeof(one), flags) == ssize_t{sizeof(one)};
  }
  std::vector<std::uint32_t> arrived() const {
    std::vector<std::uint32_t> numbers;
    Datagram one;
    while (receive(one, MSG_DONTWAIT)) numbers.push_back(one.number);
    return numbers;
  }

 private:
  LiveLink& link_;
  Socket from_{link_.here, SOCK_DGRAM, kHere}, to_{link_.there, SOCK_DGRAM, kThere};
  std::uint32_t sent_ = 0;
};

class ForwarderTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!permitted()) GTEST_SKIP() << "only root may make namespaces with TUN devices";
  }
};

TEST_F(ForwarderTest, NoPacketIsEarlyOrOvertakesAnother) {
  constexpr auto kWay = 30ms;
  LiveLink link({.way = kWay, .jitter = 10ms});
  Datagrams datagrams(link);
  for (int i = 0; i < 100; ++i) {
    datagrams.send();
    std::this_thread::sleep_for(500us);  // so that the jitter would have some overtake
  }
  for (std::uint32_t number = 1; number <= 100; ++number) {
    Datagram one{};
    ASSERT_TRUE(datagrams.receive(one, 0)) << number;
    EXPECT_EQ(one.number, number);
    EXPECT_GE(suture::now() - one.sent, kWay);
  }
}

/// Returns the numbers of those of 1000 datagrams that arrive.
std::vector<std::uint32_t> arrivedOf(std::uint64_t seed) {
  LiveLink link({.loss = 0.1, .seed = seed});
  Datagrams datagrams(link);
  std::vector<std::uint32_t> numbers;
  for (int batch = 0; batch < 10; ++batch) {  // no queue on the way holds more
    for (int i = 0; i < 100; ++i) datagrams.send();
    EXPECT_TRUE(datagrams.settled());
    for (const std::uint32_t one : datagrams.arrived()) numbers.push_back(one);
  }
  EXPECT_EQ(numbers.size(), 1000 - link.forwarder.thereCounts().lost);
  EXPECT_EQ(link.forwarder.backCounts().taken, 0u);
  return numbers;
}

TEST_F(ForwarderTest, ASeedLosesTheSamePacketsAgain) {
  const auto once = arrivedOf(7);
  EXPECT_NEAR(static_cast<double>(once.size()), 900, 40);  // by this seed, always
  EXPECT_EQ(arrivedOf(7), once);
  EXPECT_NE(arrivedOf(8), once);
}

TEST_F(ForwarderTest, AStreamDeliversEverythingInOrder) {
  LiveLink link({.way = 2ms, .loss = 0.05});
  std::vector<std::uint32_t> numbers(100'000);
  std::iota(numbers.begin(), numbers.end(), 0);
  const std::size_t size = numbers.size() * sizeof(numbers[0]);

  const Socket listening(link.there, SOCK_STREAM, kThere), from(link.here, SOCK_STREAM, kHere);
  ASSERT_EQ(listen(listening.descriptor, 1), 0);
  std::thread sender([&] {
    from.connectTo(kThere);
    EXPECT_EQ(send(from.descriptor, numbers.data(), size, 0), static_cast<ssize_t>(size));
    shutdown(from.descriptor, SHUT_WR);
  });
  const int to = accept(listening.descriptor, nullptr, nullptr);
  ASSERT_GE(to, 0);
  std::vector<std::uint32_t> arrived(numbers.size());
  EXPECT_EQ(recv(to, arrived.data(), size, MSG_WAITALL), static_cast<ssize_t>(size));
  sender.join();
  close(to);
  EXPECT_TRUE(arrived == numbers);
  EXPECT_GT(link.forwarder.thereCounts().lost, 0u);
  EXPECT_GT(link.forwarder.backCounts().taken, 0u);
}

}  // namespace
}  // namespace experiment
