#include "rivals/floor_sockets.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "harness/fail.h"
#include "harness/plain_pose.h"

namespace peers {
namespace {

enum class Kind : std::uint32_t { Echo, Push, Blob };

struct Header {
  std::uint32_t bytes;
  Kind kind;
};
struct Frame {
  Header header;
  PlainPose pose;
};
static_assert(sizeof(Frame) == 128);
/// It stands before the numbers of a blob.
struct BlobLead {
  Header header;
  double timestamp;
};

void sendAll(int socket, const void* bytes, std::size_t size) {
  const char* from = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t sent = ::send(socket, from, size, MSG_NOSIGNAL);
    if (sent <= 0) fail("send: " + std::string(std::strerror(errno)));
    from += sent;
    size -= static_cast<std::size_t>(sent);
  }
}

/// It receives as much as there is at once, and large blocks straight to where they belong.
class Receiver {
 public:
  explicit Receiver(int socket) : socket_(socket), room_(64u << 10) {}

  /// Returns false if the other end is gone.
  bool receive(void* bytes, std::size_t size) {
    char* to = static_cast<char*>(bytes);
    while (size > 0) {
      if (begin_ == end_ && size < room_.size()) {
        begin_ = 0;
        end_ = some(room_.data(), room_.size());
        if (end_ == 0) return false;
      }
      const std::size_t taken = begin_ == end_ ? some(to, size) : take(to, size);
      if (taken == 0) return false;
      to += taken;
      size -= taken;
    }
    return true;
  }

 private:
  std::size_t some(char* to, std::size_t most) const {
    const ssize_t received = ::recv(socket_, to, most, 0);
    return received > 0 ? static_cast<std::size_t>(received) : 0;
  }

  std::size_t take(char* to, std::size_t most) {
    const std::size_t taken = std::min(most, end_ - begin_);
    std::memcpy(to, room_.data() + begin_, taken);
    begin_ += taken;
    return taken;
  }

  const int socket_;
  std::vector<char> room_;
  std::size_t begin_ = 0, end_ = 0;
};

struct Address {
  sockaddr_storage storage{};
  socklen_t size = 0;

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
};

Address tcpAddress(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  Address result;
  std::memcpy(&result.storage, &address, sizeof address);
  result.size = sizeof address;
  return result;
}

Address unixAddress(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) fail("the path of a socket is too long: " + path);
  std::memcpy(address.sun_path, path.c_str(), path.size());
  Address result;
  std::memcpy(&result.storage, &address, sizeof address);
  result.size = sizeof address;
  return result;
}

Address addressOf(const Options& options, int server, bool tcp) {
  return tcp ? tcpAddress(options.port + server) : unixAddress(options.socketPath(server));
}

int socketFor(const Address& address) {
  const int made = ::socket(address.storage.ss_family, SOCK_STREAM, 0);
  if (made < 0) fail("socket: " + std::string(std::strerror(errno)));
  return made;
}

void sendAtOnce(int socket, bool tcp) {
  const int yes = 1;
  if (tcp) setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

int listenAt(const Address& address) {
  const int listener = socketFor(address);
  const int yes = 1;
  setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (::bind(listener, address.get(), address.size) != 0 || ::listen(listener, 4) != 0) {
    fail("bind: " + std::string(std::strerror(errno)));
  }
  return listener;
}

void serveClient(int socket, const Sink& sink) {
  Receiver receiver(socket);
  Frame frame;
  Pose pose;
  std::vector<char> blob;
  while (receiver.receive(&frame.header, sizeof frame.header)) {
    const Header header = frame.header;
    if (header.kind == Kind::Blob) {
      blob.resize(sizeof header + header.bytes);
      std::memcpy(blob.data(), &header, sizeof header);
      if (!receiver.receive(blob.data() + sizeof header, header.bytes)) return;
      sendAll(socket, blob.data(), blob.size());
      continue;
    }
    if (!receiver.receive(&frame.pose, sizeof frame.pose)) return;
    load(frame.pose, pose);
    if (header.kind == Kind::Push) {
      sink(pose);
    } else {
      store(pose, frame.pose);
      sendAll(socket, &frame, sizeof frame);
    }
  }
}

class SocketClient final : public Client {
 public:
  explicit SocketClient(int socket) : socket_(socket), receiver_(socket) {}
  ~SocketClient() noexcept(false) override { close(socket_); }

  void echo(const Pose& sent, Pose& back) override {
    frame_.header = {sizeof frame_.pose, Kind::Echo};
    store(sent, frame_.pose);
    sendAll(socket_, &frame_, sizeof frame_);
    receive(&frame_, sizeof frame_);
    load(frame_.pose, back);
  }

  void echo(const Blob& sent, Blob& back) override {
    const std::size_t bytes = sent.data.size() * sizeof(double);
    BlobLead lead{{static_cast<std::uint32_t>(sizeof(double) + bytes), Kind::Blob}, sent.timestamp};
    blob_.resize(sizeof lead + bytes);  // one send is faster than two, in spite of the copy
    std::memcpy(blob_.data(), &lead, sizeof lead);
    std::memcpy(blob_.data() + sizeof lead, sent.data.data(), bytes);
    sendAll(socket_, blob_.data(), blob_.size());

    receive(&lead, sizeof lead);
    back.timestamp = lead.timestamp;
    back.data.resize(lead.header.bytes / sizeof(double) - 1);
    receive(back.data.data(), back.data.size() * sizeof(double));
  }

  void send(const Pose& pose) override {
    frame_.header = {sizeof frame_.pose, Kind::Push};
    store(pose, frame_.pose);
    sendAll(socket_, &frame_, sizeof frame_);
  }

 private:
  void receive(void* bytes, std::size_t size) {
    if (!receiver_.receive(bytes, size)) fail("the server is gone");
  }

  const int socket_;
  Receiver receiver_;
  Frame frame_{};
  std::vector<char> blob_;
};

}  // namespace

void SocketPeer::serve(const Options& options, const Sink& sink,
                       const std::function<void()>& ready) {
  const int listener = listenAt(addressOf(options, options.server, tcp_));
  sink.control().exitWhenToldBeside();
  ready();
  const int socket = ::accept(listener, nullptr, nullptr);
  if (socket < 0) fail("accept: " + std::string(std::strerror(errno)));
  sendAtOnce(socket, tcp_);
  serveClient(socket, sink);
}

std::unique_ptr<Client> SocketPeer::client(const Options& options, int server) {
  const Address address = addressOf(options, server, tcp_);
  const int socket = socketFor(address);
  if (::connect(socket, address.get(), address.size) != 0) {
    fail("connect: " + std::string(std::strerror(errno)));
  }
  sendAtOnce(socket, tcp_);
  return std::make_unique<SocketClient>(socket);
}

}  // namespace peers
