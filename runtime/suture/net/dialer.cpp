#include <suture/loop/deadline.h>
#include <suture/loop/failure.h>
#include <suture/loop/write_observer.h>
#include <suture/net/dialer.h>
#include <suture/net/socket.h>

#include <cerrno>
#include <cstring>

namespace suture::net {
namespace {

kj::Exception cannotConnect(const Address& address, int error) {
  std::string found = std::strerror(error);
  if (error == ENOENT) found = "there is no such socket";
  if (error == ECONNREFUSED) found = "nobody listens there";
  return loop::disconnected(
      "connect to " + address.text() + ": " + found +
      ". Start the process that should listen there, or correct the address.");
}

int pendingError(int socket) {
  int error = 0;
  socklen_t length = sizeof(error);
  return getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &length) == 0 ? error : errno;
}

/// Waits until a connection that was started is made.
kj::Promise<kj::AutoCloseFd> finish(loop::EventPort& port, kj::AutoCloseFd socket,
                                    const Address& address) {
  auto observer = kj::heap<loop::WriteObserver>(port, socket);
  auto writable = observer->whenWritable();
  return writable.attach(kj::mv(observer))
      .then([socket = kj::mv(socket), address]() mutable -> kj::Promise<kj::AutoCloseFd> {
        if (const int error = pendingError(socket)) return cannotConnect(address, error);
        return kj::mv(socket);
      });
}

/// Tries to connect. A Unix socket whose listener is busy refuses only for the moment, so it tries
/// again.
kj::Promise<kj::AutoCloseFd> tryConnect(loop::EventPort& port, const Address& address) {
  kj::AutoCloseFd socket = openSocket(address);
  if (address.kind != Address::Kind::Unix) sendWithoutDelay(socket);
  const SocketAddress target(address);
  if (connect(socket, target.get(), target.length) == 0) return kj::mv(socket);
  if (errno == EINPROGRESS) return finish(port, kj::mv(socket), address);
  if (errno != EAGAIN) return cannotConnect(address, errno);
  return port.getTimer().afterDelay(5 * kj::MILLISECONDS).then([&port, address] {
    return tryConnect(port, address);
  });
}

}  // namespace

kj::Promise<kj::AutoCloseFd> dial(loop::EventPort& port, const Address& address,
                                  Duration deadline) {
  return loop::unlessLate(
      port.getTimer(), deadline, kj::evalNow([&] { return tryConnect(port, address); }),
      [address]() -> kj::Promise<kj::AutoCloseFd> { return cannotConnect(address, ETIMEDOUT); });
}

}  // namespace suture::net
