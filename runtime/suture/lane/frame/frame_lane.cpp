#include <suture/base/errors.h>
#include <suture/frame.capnp.h>
#include <suture/lane/frame/frame_lane.h>
#include <suture/lane/frame/framed_connection.h>
#include <suture/lane/opened_once.h>
#include <suture/loop/failure.h>
#include <suture/net/socket.h>
#include <suture/wire/text.h>
#include <suture/wiring/memory_layout.h>

#include <algorithm>
#include <utility>

namespace suture::frame {
namespace {

/// The socket of a session, and what both ends call it.
struct SessionLink {
  SessionLink(LaneSocket socket, LaneThread& thread)
      : number(socket.number), link(std::make_shared<Link>(kj::mv(socket.bytes), number)) {
    thread.add(link);
  }
  bool broken() const { return link->broken(); }

  const std::uint32_t number;
  const std::shared_ptr<Link> link;
};

class FrameAttempt final : public LaneAttempt {
 public:
  FrameAttempt(OutgoingConnection connection, std::shared_ptr<SessionLink> link, LaneThread& thread,
               rpc::ControlThread& control)
      : connection_(std::move(connection)),
        link_(std::move(link)),
        thread_(thread),
        control_(control) {}

  void request(capnp::AnyPointer::Builder out) override {
    auto request = out.initAs<wire::FrameRequest>();
    request.setLayout(textOf(memoryLayout(connection_.contract)));
    request.setSocket(link_->number);
  }

  kj::Promise<OpenedEnd> open(capnp::AnyPointer::Reader answer, std::uint32_t rows) override {
    const std::uint32_t number = answer.getAs<wire::FrameAnswer>().getConnection();
    return openFramed(connection_, rows, {"frame", thread_, link_->link, number}, control_);
  }

 private:
  const OutgoingConnection connection_;
  const std::shared_ptr<SessionLink> link_;
  LaneThread& thread_;
  rpc::ControlThread& control_;
};

class FrameClient final : public LaneClient {
 public:
  FrameClient(LaneThread& thread, ClientSession& session) : thread_(thread), session_(session) {}
  // The thread looks whether somebody still needs the link.
  ~FrameClient() noexcept(false) {
    link_ = nullptr;
    thread_.doorbell()->ring();
  }

  std::string whyNot(const OutgoingConnection& connection) const override {
    if (std::string why = whyUnbounded(connection.contract); !why.empty()) return why;
    const bool hidden = !session_.hasOneClock() && hidesStamps(connection.contract);
    return hidden ? "the two processes have different clocks" : "";
  }

  kj::Promise<kj::Own<LaneAttempt>> attempt(OutgoingConnection connection) override {
    return opened_.get([this] { return open(); })
        .then([this, connection = std::move(connection)](
                  std::shared_ptr<SessionLink>&& link) mutable -> kj::Own<LaneAttempt> {
          link_ = link;
          return kj::heap<FrameAttempt>(std::move(connection), std::move(link), thread_,
                                        session_.control());
        });
  }

  void bear(Duration silence) override {
    longest_ = silence;
    if (link_ != nullptr) rpc::breakWhenUnanswered(link_->link->descriptor(), silence);
  }

 private:
  kj::Promise<std::shared_ptr<SessionLink>> open() {
    return session_.openSocket("frame").then([this](LaneSocket&& socket) {
      rpc::breakWhenUnanswered(socket.bytes.socket(), longest_);
      return std::make_shared<SessionLink>(kj::mv(socket), thread_);
    });
  }

  LaneThread& thread_;
  ClientSession& session_;
  Duration longest_{0};
  OpenedOnce<SessionLink> opened_;
  std::shared_ptr<SessionLink> link_;  // as long as the session has no other
};

class FrameServer final : public LaneServer {
 public:
  FrameServer(LaneThread& thread, ServerSession& session) : thread_(thread), session_(session) {}
  ~FrameServer() noexcept(false) {
    link_ = nullptr;
    thread_.doorbell()->ring();
  }

  kj::Promise<AcceptedEnd> accept(IncomingConnection connection, capnp::AnyPointer::Reader brings,
                                  capnp::AnyPointer::Builder answer) override {
    const auto request = brings.getAs<wire::FrameRequest>();
    std::string why = whyOtherSlots(connection.contract, stringOf(request.getLayout()));
    if (why.empty() && !carries(request.getSocket())) why = "the session's frames have ended";
    if (!why.empty()) return rpc::failure(kj::Exception::Type::FAILED, why);
    answer.initAs<wire::FrameAnswer>().setConnection(++latest_);
    return acceptFramed(connection, {"frame", thread_, link_->link, latest_}, session_.control());
  }

  // Connections on the one before have it for as long as they stand.
  void opened(LaneSocket socket) override {
    link_ = std::make_shared<SessionLink>(kj::mv(socket), thread_);
  }

 private:
  bool carries(std::uint32_t socket) const {
    return link_ != nullptr && link_->number == socket && !link_->broken();
  }

  LaneThread& thread_;
  ServerSession& session_;
  std::shared_ptr<SessionLink> link_;
  std::uint32_t latest_ = 0;  // connection
};

}  // namespace

kj::Own<LaneClient> FrameLane::makeClient(ClientSession& session) {
  return kj::heap<FrameClient>(thread_, session);
}

kj::Own<LaneServer> FrameLane::makeServer(ServerSession& session) {
  return kj::heap<FrameServer>(thread_, session);
}

}  // namespace suture::frame
