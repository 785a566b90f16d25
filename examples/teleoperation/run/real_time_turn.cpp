#include "run/real_time_turn.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <string_view>

namespace demo {
namespace {

using namespace std::string_view_literals;

// It begins with a zero, so it is not a file, and the kernel removes it with the socket.
constexpr auto kName = "\0suture-demo/real-time"sv;

}  // namespace

RealTimeTurn::~RealTimeTurn() {
  if (socket_ >= 0) close(socket_);
}

bool RealTimeTurn::take() {
  socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, kName.data(), kName.size());
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + kName.size());
  return bind(socket_, reinterpret_cast<const sockaddr*>(&address), length) == 0;
}

}  // namespace demo
