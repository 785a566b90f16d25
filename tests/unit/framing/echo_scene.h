#pragma once
// These tests have a server and its peers on one event loop, with real sockets.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <suture/framing/link_server.h>
#include <suture/loop/failure.h>
#include <suture/net/dialer.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <string>

#include "echo_server.h"
#include "support/patience.h"
#include "support/temporary_directory.h"

namespace suture::framing::test {

using namespace std::chrono_literals;
using capnp::rpc::twoparty::Side;

/// Holds a server of echoes, over a Unix socket or TCP, both ends on one event loop.
class EchoScene : public testing::TestWithParam<const char*> {
 public:
  ~EchoScene() noexcept override {}

 protected:
  std::string freshAddress() {
    return std::string(GetParam()) == "unix" ? "unix:" + directory_.file("s") : "tcp://127.0.0.1:0";
  }

  static constexpr LinkLimits kTwo{.all = 2, .ofOne = 2};

  /// A busy machine may take any time to send what a test sends.
  static StreamLimits patientLimits() {
    constexpr std::int64_t kPatience = 600'000;
    return {.partialMilliseconds = kPatience,
            .firstMilliseconds = kPatience,
            .handshakeMilliseconds = kPatience,
            .helloMilliseconds = kPatience};
  }

  void serve(LinkLimits links = kTwo, const StreamLimits& limits = patientLimits()) {
    server_ = kj::heap<LinkServer>(
        port_, net::Address::parse(freshAddress()),
        [this](auto&& caller) -> capnp::Capability::Client {
          caller->known = knows_;
          return Echo::Client(kj::heap<EchoServer>());
        },
        refusals_, limits, links);
  }

  kj::Own<Link> connect() {
    auto socket = net::dial(port_, server_->address(), kPatience).wait(port_.scope());
    return kj::heap<Link>(kj::heap<MessageStream>(port_, kj::mv(socket)), Side::CLIENT);
  }

  /// Connects a socket to the server, which has not accepted it.
  kj::AutoCloseFd connectedSocket() {
    const net::SocketAddress target(server_->address());
    kj::AutoCloseFd socket(::socket(target.family(), SOCK_STREAM | SOCK_CLOEXEC, 0));
    EXPECT_EQ(::connect(socket, target.get(), target.length), 0) << std::strerror(errno);
    fcntl(socket, F_SETFL, O_NONBLOCK);
    return socket;
  }

  /// Sends all of `bytes`, and lets the server run meanwhile.
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
      return loop::describe(e);
    }
    return "";
  }

  std::string dialFault(const net::Address& address) {
    try {
      net::dial(port_, address, 1s).wait(port_.scope());
    } catch (const kj::Exception& e) {
      return loop::describe(e);
    }
    return "connected";
  }

  TemporaryDirectory directory_;
  loop::EventPort port_;
  bool knows_ = true;
  net::Refusals refusals_{"server"};
  kj::Own<LinkServer> server_;
};

}  // namespace suture::framing::test
