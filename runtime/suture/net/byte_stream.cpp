#include <suture/loop/failure.h>
#include <suture/net/byte_stream.h>
#include <suture/net/tls/certificate.h>
#include <suture/net/tls/session.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace suture::net {

ByteStream::ByteStream(kj::AutoCloseFd socket, std::unique_ptr<tls::Session> session)
    : socket_(kj::mv(socket)), session_(std::move(session)) {}

ByteStream::ByteStream(kj::AutoCloseFd socket) : ByteStream(kj::mv(socket), nullptr) {}

ByteStream::ByteStream(ByteStream&& other) noexcept = default;

ByteStream::~ByteStream() = default;

PeerIdentity ByteStream::peer() const {
  if (session_ == nullptr) return identityOf(socket_);
  return {.proof = PeerIdentity::Proof::Certificate, .user = 0, .process = session_->peer()};
}

std::string ByteStream::certificatesEnd() const {
  return session_ == nullptr ? "" : tls::ending(session_->certificate());
}

ssize_t ByteStream::receive(std::span<std::byte> into, Descriptors& descriptors) {
  return session_ ? session_->receive(into) : receiveWith(socket_, into, descriptors);
}

ssize_t ByteStream::send(std::span<const std::byte> bytes, const Descriptors& descriptors) {
  return session_ ? session_->send(bytes) : sendWith(socket_, bytes, descriptors);
}

bool ByteStream::carriesDescriptors() const {
  int domain = 0;
  socklen_t size = sizeof(domain);
  return session_ == nullptr && getsockopt(socket_, SOL_SOCKET, SO_DOMAIN, &domain, &size) == 0 &&
         domain == AF_UNIX;
}

void ByteStream::end() {
  if (session_) session_->end();
  shutdown(socket_, SHUT_WR);
}

void ByteStream::cut() { shutdown(socket_, SHUT_RDWR); }

kj::Exception ByteStream::lost(int error) const {
  const bool explained = session_ != nullptr && error == EPROTO;
  return loop::disconnected("connection lost: " +
                            (explained ? session_->failure() : std::string(std::strerror(error))));
}

}  // namespace suture::net
