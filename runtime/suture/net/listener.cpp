#include <netinet/in.h>
#include <netinet/tcp.h>
#include <suture/net/host_lookup.h>
#include <suture/net/listener.h>
#include <suture/net/socket.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fcntl.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace suture::net {
namespace {

constexpr int kBacklog = 128;
// The loop looks at its other sockets before the listener accepts more.
constexpr int kMostInATurn = 32;
constexpr mode_t kEverybodys = S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;
// Breaks the connection of a caller that answers nothing for this long: a caller that still runs
// has a shorter bound of its own, and has connected again by then.
constexpr Duration kForgotten = std::chrono::seconds(60);

bool isOtherThanASocket(const Address& address) {
  struct stat status {};
  return address.kind == Address::Kind::Unix && stat(address.path.c_str(), &status) == 0 &&
         !S_ISSOCK(status.st_mode);
}

[[noreturn]] void cannotListen(const Address& address, int error) {
  const std::string asked = "listen at " + address.text();
  if (error == EADDRINUSE && isOtherThanASocket(address)) {
    throw SetupError(asked, "there is a file that is no socket",
                     "Remove it, or choose another address with --listen.");
  }
  if (error == EADDRINUSE) {
    throw SetupError(
        asked, "another process listens there",
        "Stop it, or choose another address: --listen of a manager, the port of a process.");
  }
  throw SetupError(asked, std::strerror(error),
                   address.kind == Address::Kind::Unix
                       ? "Check that the directory exists and is yours."
                       : "Choose another address or port.");
}

/// A BindLock is held from before a Unix socket is bound until it listens, because in between it
/// looks like one that a dead process left behind. The kernel takes it from a process that dies;
/// the file that stays then is in nobody's way. Where the file system has no locks, it keeps
/// nobody out.
class BindLock {
 public:
  explicit BindLock(const Address& address) {
    if (address.kind != Address::Kind::Unix) return;
    path_ = address.path + std::string(Listener::kLockEnd);
    do {
      const int opened = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
      error_ = opened < 0 ? errno : 0;
      if (error_ != 0) return;
      file_ = kj::AutoCloseFd(opened);
      error_ = flock(file_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
      if (hasNoLocks(error_)) error_ = 0;
    } while (error_ == 0 && !isThere());  // another has removed it after this opened it
  }
  ~BindLock() {
    if (file_ != nullptr && error_ == 0) unlink(path_.c_str());
  }
  BindLock(const BindLock&) = delete;
  BindLock& operator=(const BindLock&) = delete;

  /// Returns why it is not held, as errno says it; EADDRINUSE: another holds it.
  int error() const { return error_ == EWOULDBLOCK ? EADDRINUSE : error_; }

 private:
  static bool hasNoLocks(int error) {
    return error == ENOLCK || error == EOPNOTSUPP || error == ENOSYS;
  }
  bool isThere() const {
    struct stat ours {
    }, there{};
    return fstat(file_, &ours) == 0 && stat(path_.c_str(), &there) == 0 &&
           ours.st_ino == there.st_ino && ours.st_dev == there.st_dev;
  }

  std::string path_;
  kj::AutoCloseFd file_;
  int error_ = 0;
};

bool isStale(const Address& address) {
  struct stat status {};
  if (address.kind != Address::Kind::Unix || stat(address.path.c_str(), &status) != 0) return false;
  if (!S_ISSOCK(status.st_mode)) return false;
  const kj::AutoCloseFd probe = openSocket(address);
  const SocketAddress target(address);
  return connect(probe, target.get(), target.length) != 0 && errno == ECONNREFUSED;
}

kj::AutoCloseFd bindTo(const Address& address, Listener::Opens opens) {
  const BindLock lock(address);
  if (lock.error() != 0) cannotListen(address, lock.error());
  const Address place = lookUp(address).front();
  kj::AutoCloseFd listening = openSocket(place);
  const int on = 1;
  if (address.kind != Address::Kind::Unix) {
    setsockopt(listening, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
  } else {
    fchmod(listening, S_IRUSR | S_IWUSR);  // the file that bind() makes inherits it
  }
  const SocketAddress target(place);
  if (bind(listening, target.get(), target.length) != 0) {
    const int error = errno;
    if (error != EADDRINUSE || !isStale(address)) cannotListen(address, error);
    unlink(address.path.c_str());
    if (bind(listening, target.get(), target.length) != 0) cannotListen(address, errno);
  }
  if (opens == Listener::Opens::ToOthers) chmod(address.path.c_str(), kEverybodys);
  if (::listen(listening, kBacklog) != 0) cannotListen(address, errno);
  return listening;
}

std::uint16_t boundPort(int socket, std::uint16_t asked) {
  sockaddr_storage bound{};
  socklen_t length = sizeof(bound);
  if (getsockname(socket, reinterpret_cast<sockaddr*>(&bound), &length) != 0) return asked;
  return ntohs(bound.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6&>(bound).sin6_port
                                           : reinterpret_cast<sockaddr_in&>(bound).sin_port);
}

ino_t inodeOf(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_ino : 0;
}

}  // namespace

void Listener::removeLeftover(const Address& address) {
  const BindLock lock(address);  // its own file goes with it
  if (lock.error() == 0 && isStale(address)) unlink(address.path.c_str());
}

Listener::Listener(loop::EventPort& port, const Address& address, Opens opens)
    : port_(port),
      address_(address),
      socket_(bindTo(address, opens)),
      observer_(port, socket_, loop::EventPort::FdObserver::OBSERVE_READ) {
  if (address_.kind != Address::Kind::Unix) {
    address_.port = boundPort(socket_, address.port);
  } else {
    inode_ = inodeOf(address_.path);
  }
}

Listener::~Listener() noexcept(false) {
  const bool ours = address_.kind == Address::Kind::Unix && inodeOf(address_.path) == inode_;
  if (ours) unlink(address_.path.c_str());
}

kj::Promise<void> Listener::listen(kj::Function<void(kj::AutoCloseFd)> accept,
                                   kj::Function<void(int)> starved) {
  accept_ = kj::mv(accept);
  starved_ = kj::mv(starved);
  return acceptAll();
}

kj::Promise<void> Listener::acceptAll() {
  for (int i = 0; i < kMostInATurn; ++i) {
    const int accepted = accept4(socket_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (accepted >= 0) {
      kj::AutoCloseFd connection(accepted);
      if (address_.kind != Address::Kind::Unix) {
        sendWithoutDelay(connection);
        breakWhenUnanswered(connection, kForgotten);
      }
      accept_(kj::mv(connection));
    } else if (errno == EAGAIN) {
      return observer_.whenBecomesReadable().then([this] { return acceptAll(); });
    } else if (errno != EINTR && errno != ECONNABORTED) {
      starved_(errno);
      return acceptLater(100 * kj::MILLISECONDS);
    }
  }
  return acceptLater(0 * kj::MILLISECONDS);
}

// A timer lets the loop look at its sockets first, which evalLater() does not.
kj::Promise<void> Listener::acceptLater(kj::Duration pause) {
  return port_.getTimer().afterDelay(pause).then([this] { return acceptAll(); });
}

}  // namespace suture::net
