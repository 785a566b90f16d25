// Valid sessions of a peer are changed a little and sent again: the provider ends them or answers,
// and goes on serving others. SUTURE_SESSIONS of them run, and SUTURE_SEED is the first seed.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <suture/framing/link.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/names/manager_link.h>
#include <suture/peer.capnp.h>
#include <sys/socket.h>

#include <cstdlib>
#include <random>
#include <thread>

#include "integration/network/arm.h"
#include "integration/network/console.h"
#include "reference/arm_like.capnp.h"
#include "reference/connect_request.h"
#include "support/patience.h"
#include "support/process_address.h"
#include "support/resources.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::byte>;

unsigned fromEnvironment(const char* name, unsigned otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : static_cast<unsigned>(std::atoi(text));
}

kj::AutoCloseFd dialled(const net::Address& address) {
  const net::SocketAddress target(address);
  kj::AutoCloseFd socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  EXPECT_EQ(::connect(socket, target.get(), target.length), 0);
  return socket;
}

bool sendAll(int socket, const Bytes& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = send(socket, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

/// Passes one connection on, and keeps what the caller says.
class Recorder {
 public:
  explicit Recorder(const net::Address& target) : target_(target) {
    address.kind = net::Address::Kind::Tcp;
    address.host = "127.0.0.1";
    const net::SocketAddress any(address);
    listener_ = kj::AutoCloseFd(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in own{};
    socklen_t length = sizeof(own);
    EXPECT_EQ(bind(listener_, any.get(), any.length), 0);
    EXPECT_EQ(listen(listener_, 1), 0);
    EXPECT_EQ(getsockname(listener_, reinterpret_cast<sockaddr*>(&own), &length), 0);
    address.port = ntohs(own.sin_port);
    thread_ = std::thread([this] { pass(); });
  }
  /// Returns what was said, once the caller has gone.
  Bytes finish() {
    thread_.join();
    return said_;
  }

  net::Address address;

 private:
  void pass() {
    const kj::AutoCloseFd caller(accept(listener_, nullptr, nullptr));
    const kj::AutoCloseFd callee = dialled(target_);
    pollfd ends[] = {{caller, POLLIN, 0}, {callee, POLLIN, 0}};
    while (poll(ends, 2, 10'000) > 0) {
      Bytes bytes(1 << 16);
      const bool there = (ends[0].revents & (POLLIN | POLLHUP)) != 0;
      const ssize_t count = recv(there ? caller : callee, bytes.data(), bytes.size(), 0);
      if (count <= 0) return;
      bytes.resize(static_cast<std::size_t>(count));
      if (there) said_.insert(said_.end(), bytes.begin(), bytes.end());
      sendAll(there ? callee : caller, bytes);
    }
  }

  const net::Address target_;
  kj::AutoCloseFd listener_;
  Bytes said_;
  std::thread thread_;
};

/// Says hello, looks around, connects, opens, commands.
kj::Promise<void> session(wire::Peer::Client peer) {
  auto hello = peer.helloRequest();
  hello.setVersion(wire::PROTOCOL_VERSION);
  hello.setProcess("test");
  auto connect = peer.connectRequest();
  reference::askForArm(connect, "test");
  connect.setEpoch(toNanoseconds(now()));
  auto open = peer.openRequest();
  open.setComponent("PSM");
  open.setInterface("Arm");
  return hello.send()
      .ignoreResult()
      .then([peer]() mutable { return peer.describeRequest().send().ignoreResult(); })
      .then([peer]() mutable { return peer.pingRequest().send().ignoreResult(); })
      .then([connect = kj::mv(connect)]() mutable { return connect.send().ignoreResult(); })
      .then([open = kj::mv(open)]() mutable { return open.send(); })
      .then([](auto&& opened) {
        auto arm = opened.getContract().template castAs<reference::wire::ArmLike>();
        return arm.holdRequest().send().ignoreResult().then(
            [arm]() mutable { return arm.resetRequest().send().ignoreResult(); });
      });
}

Bytes recordedSession(const std::string& manager, const net::Address& robot) {
  Recorder recorder(robot);
  loop::ControlThread control;
  control.run(kPatience, [&control, &recorder, manager] {
    auto link = kj::heap<ManagerLink>(control, std::vector{net::Address::parse(manager)}, "test");
    auto& held = *link;
    return held.open(kPatience)
        .then([&held, &recorder] {
          ProcessRecord record;
          record.name = "robot";
          record.addresses = {recorder.address.text()};
          return held.reach(record, kPatience);
        })
        .then([&control](net::ByteStream bytes) {
          auto stream = kj::heap<framing::MessageStream>(control.port(), kj::mv(bytes));
          auto peer = kj::heap<framing::Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT);
          return session(peer->bootstrap<wire::Peer>()).attach(kj::mv(peer));
        })
        .attach(kj::mv(link));
  });
  return recorder.finish();
}

/// Returns the bytes after one to four changes.
Bytes changed(Bytes bytes, std::mt19937& random) {
  const auto below = [&](std::size_t most) { return most == 0 ? 0 : random() % most; };
  for (std::size_t left = 1 + below(4); left > 0 && !bytes.empty(); --left) {
    const std::size_t at = below(bytes.size()), count = 1 + below(16);
    const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto behind =
        bytes.begin() + static_cast<std::ptrdiff_t>(std::min(at + count, bytes.size()));
    switch (below(6)) {
      case 0: *place ^= std::byte{1} << below(8); break;
      case 1: *place = static_cast<std::byte>(random()); break;
      case 2: std::fill(place, behind, std::byte{0xff}); break;
      case 3: bytes.erase(place, behind); break;
      case 4: bytes.insert(place, count * 8, std::byte{0}); break;
      case 5: bytes.resize(at); break;
    }
  }
  return bytes;
}

/// Returns true if the provider has ended the connection or answered before it did.
bool survives(const net::Address& robot, const Bytes& bytes) {
  const kj::AutoCloseFd socket = dialled(robot);
  sendAll(socket, bytes);
  shutdown(socket, SHUT_WR);
  pollfd readable{socket, POLLIN, 0};
  Bytes answer(1 << 12);
  while (poll(&readable, 1, 10'000) > 0) {
    if (recv(socket, answer.data(), answer.size(), 0) <= 0) return true;
  }
  return false;
}

TEST(Sessions, ChangedSessionsHurtNoOther) {
  loop::ControlThread control;
  GlobalManager names(control, "tcp://127.0.0.1:0");
  reference::HostedArm arm;
  Console console;
  Manager robot("robot", names.address()), client("console", names.address());
  robot.add("PSM", arm);
  client.add("Console", console);
  robot.start();
  client.start();
  client.connect("Console/Arm", "robot:PSM/Arm");

  const unsigned count = fromEnvironment("SUTURE_SESSIONS", 3000);
  const unsigned seed = fromEnvironment("SUTURE_SEED", 1);
  const auto address = net::Address::parse(addressOf(names.address(), "robot"));
  const Bytes valid = recordedSession(names.address(), address);
  ASSERT_GT(valid.size(), 500u);
  ASSERT_TRUE(survives(address, valid));
  const std::size_t descriptors = openDescriptors();
  for (unsigned i = 0; i < count; ++i) {
    std::mt19937 random(seed + i);
    ASSERT_TRUE(survives(address, changed(valid, random))) << "SUTURE_SEED=" << seed + i;
    if (i % 500 == 0) {
      ASSERT_TRUE(console.arm.hold.start().within(kPatience)) << "SUTURE_SEED=" << seed + i;
    }
  }
  EXPECT_TRUE(console.arm.hold.start().within(kPatience));
  EXPECT_TRUE(eventually([&] { return openDescriptors() <= descriptors + 3; }));
  std::printf("%u sessions of %zu bytes changed and sent, from seed %u\n", count, valid.size(),
              seed);
}

}  // namespace
}  // namespace suture
