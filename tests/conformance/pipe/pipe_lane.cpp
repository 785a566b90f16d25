#include "conformance/pipe/pipe_lane.h"

#include <fcntl.h>
#include <suture/component/contract/unbounded.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace conformance {
namespace {

using namespace suture;

constexpr std::uint32_t kNumber = 1;  // a link has one connection

struct Pipe {
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    out = kj::AutoCloseFd(ends[0]);
    in = kj::AutoCloseFd(ends[1]);
  }
  kj::AutoCloseFd in, out;
};

/// Returns where another process of this machine finds an end of a pipe.
std::string pathOf(const kj::AutoCloseFd& end) {
  return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(end.get());
}

kj::AutoCloseFd openPipe(capnp::Text::Reader path, int how) {
  const int descriptor = open(path.cStr(), how | O_CLOEXEC);
  if (descriptor < 0) throw std::runtime_error("no pipe at " + std::string(path.cStr()));
  return kj::AutoCloseFd(descriptor);
}

/// Waits for bytes and passes them on; false: one of the two has ended.
bool passOn(int from, int to) {
  std::array<std::byte, 16 << 10> bytes;
  const ssize_t count = read(from, bytes.data(), bytes.size());
  ssize_t passed = 0;
  while (passed < count) {
    const ssize_t now = write(to, &bytes[static_cast<std::size_t>(passed)],
                              static_cast<std::size_t>(count - passed));
    if (now <= 0) return false;
    passed += now;
  }
  return count > 0;
}

class PipeAttempt final : public LaneAttempt {
 public:
  PipeAttempt(PipeLane& lane, loop::ControlThread& control) : lane_(lane), control_(control) {}

  void request(capnp::AnyPointer::Builder out) override {
    auto paths = out.initAs<capnp::List<capnp::Text>>(2);
    paths.set(0, pathOf(there_.out));
    paths.set(1, pathOf(back_.in));
  }

  kj::Promise<OpenedEnd> open(OutgoingConnection connection, capnp::AnyPointer::Reader) override {
    return frame::openFramed(std::move(connection),
                             lane_.lead(kj::mv(back_.out), kj::mv(there_.in)), control_);
  }

 private:
  PipeLane& lane_;
  loop::ControlThread& control_;
  Pipe there_, back_;
};

class PipeClient final : public LaneClient {
 public:
  PipeClient(PipeLane& lane, ClientSession& session) : lane_(lane), session_(session) {}

  std::string whyNot(const OutgoingConnection& connection) const override {
    return whyUnbounded(connection.contract);
  }
  kj::Promise<kj::Own<LaneAttempt>> attempt(const OutgoingConnection&) override {
    return kj::Own<LaneAttempt>(kj::heap<PipeAttempt>(lane_, session_.control()));
  }

 private:
  PipeLane& lane_;
  ClientSession& session_;
};

class PipeServer final : public LaneServer {
 public:
  PipeServer(PipeLane& lane, ServerSession& session) : lane_(lane), session_(session) {}

  kj::Promise<AcceptedEnd> accept(IncomingConnection connection, capnp::AnyPointer::Reader brings,
                                  capnp::AnyPointer::Builder) override {
    const auto paths = brings.getAs<capnp::List<capnp::Text>>();
    auto in = openPipe(paths[0], O_RDONLY), out = openPipe(paths[1], O_WRONLY);
    return frame::acceptFramed(connection, lane_.lead(kj::mv(in), kj::mv(out)), session_.control());
  }
  void opened(LaneSocket) override {}

 private:
  PipeLane& lane_;
  ServerSession& session_;
};

}  // namespace

kj::Own<LaneClient> PipeLane::makeClient(ClientSession& session) {
  return kj::heap<PipeClient>(*this, session);
}

kj::Own<LaneServer> PipeLane::makeServer(ServerSession& session) {
  return kj::heap<PipeServer>(*this, session);
}

// The thread of frames watches one socket: what goes through it is led on through the pipes.
frame::FramedOn PipeLane::lead(kj::AutoCloseFd in, kj::AutoCloseFd out) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::runtime_error("no pair of sockets");
  }
  kj::AutoCloseFd socket(ends[0]), here(ends[1]);
  fcntl(socket, F_SETFL, O_NONBLOCK);
  pump(kj::AutoCloseFd(fcntl(here, F_DUPFD_CLOEXEC, 0)), kj::mv(out));
  pump(kj::mv(in), kj::mv(here));
  auto link = std::make_shared<frame::FrameLink>(net::ByteStream(kj::mv(socket)), kNumber);
  thread_.add(link);
  return {name(), thread_, std::move(link), kNumber, frame::Form::Encoded};
}

// A reader behind an end is told when that end closes: of a socket too, also while the other
// direction has it open.
void PipeLane::pump(kj::AutoCloseFd from, kj::AutoCloseFd to) {
  const auto body = [from = std::make_shared<kj::AutoCloseFd>(kj::mv(from)),
                     to = std::make_shared<kj::AutoCloseFd>(kj::mv(to))]() mutable {
    while (passOn(*from, *to)) continue;
    shutdown(*to, SHUT_RDWR);
    from = to = nullptr;
  };
  pumps_.emplace_back().start("pipe", body, rt::Thread::Signals::None);
}

void PipeLane::stop() {
  thread_.stop();
  for (rt::Thread& pump : pumps_) pump.join();
  pumps_.clear();
}

}  // namespace conformance
