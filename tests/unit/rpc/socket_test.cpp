#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <suture/net/socket.h>

namespace suture::rpc {
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

}  // namespace
}  // namespace suture::rpc
