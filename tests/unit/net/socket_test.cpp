#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <suture/net/socket.h>

#include <linux/sockios.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <vector>

namespace suture::net {
namespace {

using namespace std::chrono_literals;

int optionOf(int socket, int level, int name) {
  int value = 0;
  socklen_t length = sizeof(value);
  EXPECT_EQ(getsockopt(socket, level, name, &value, &length), 0);
  return value;
}

TEST(Socket, BreaksWhenTheOtherMachineIsSilent) {
  const auto socket = openSocket(Address::parse("tcp://127.0.0.1:1"));
  breakWhenUnanswered(socket, 1500ms);
  EXPECT_EQ(optionOf(socket, IPPROTO_TCP, TCP_USER_TIMEOUT), 1500);
  EXPECT_EQ(optionOf(socket, SOL_SOCKET, SO_KEEPALIVE), 1);
  EXPECT_EQ(optionOf(socket, IPPROTO_TCP, TCP_KEEPIDLE), 2) << "in whole seconds";
}

/// Holds two ends of a TCP connection, of which the far one takes nothing.
struct Connected {
  Connected() {
    const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{
        .sin_family = AF_INET, .sin_port = 0, .sin_addr = {htonl(INADDR_LOOPBACK)}, .sin_zero = {}};
    socklen_t length = sizeof(address);
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(bind(listener, generic, length), 0);
    EXPECT_EQ(listen(listener, 1), 0);
    EXPECT_EQ(getsockname(listener, generic, &length), 0);
    near = kj::AutoCloseFd(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    EXPECT_EQ(connect(near, generic, length), 0);
    far = kj::AutoCloseFd(accept4(listener, nullptr, nullptr, SOCK_CLOEXEC));
    close(listener);
  }
  /// Sends what the kernel takes; returns what of it waits to be sent for the first time.
  int unsentWhenFull() const {
    const std::vector<std::byte> bytes(16 << 10);
    while (send(near, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL) > 0) continue;
    int unsent = 0;
    EXPECT_EQ(ioctl(near, SIOCOUTQNSD, &unsent), 0);
    return unsent;
  }

  kj::AutoCloseFd near, far;
};

TEST(Socket, KeepsWhatWaitsInTheKernelShort) {
  EXPECT_GT(Connected().unsentWhenFull(), 4 * kMostUnsent) << "else there is nothing to keep short";
  const Connected ends;
  keepUnsentShort(ends.near);
  EXPECT_LE(ends.unsentWhenFull(), 2 * kMostUnsent);
}

}  // namespace
}  // namespace suture::net
