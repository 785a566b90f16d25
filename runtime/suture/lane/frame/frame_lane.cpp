#include <suture/base/errors.h>
#include <suture/codec/codec.h>
#include <suture/codec/text.h>
#include <suture/component/contract/unbounded.h>
#include <suture/frame.capnp.h>
#include <suture/lane/frame/frame_lane.h>
#include <suture/lane/frame/framed_connection.h>
#include <suture/loop/failure.h>
#include <suture/loop/opened_once.h>
#include <suture/net/socket.h>
#include <suture/wiring/memory_layout.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace suture::frame {
namespace {

// A client that names more commands than this is refused, since no contract has so many.
constexpr unsigned kMostCommands = 4096;

/// A SessionLink is the socket of a session, and its number at both ends.
struct SessionLink {
  SessionLink(LaneSocket socket, LaneThread& thread)
      : number(socket.number),
        link(std::make_shared<FrameLink>(kj::mv(socket.bytes), number, std::move(socket.share))) {
    net::keepUnsentShort(link->descriptor());
    thread.add(link);
  }
  bool broken() const { return link->broken(); }

  const std::uint32_t number;
  const std::shared_ptr<FrameLink> link;
};

void describeCommands(const InterfaceInfo& contract, wire::FrameRequest::Builder out) {
  const auto commands = contract.codec().commands;
  auto names = out.initCommands(static_cast<unsigned>(commands.size()));
  auto latest = out.initLatest(names.size());
  for (unsigned i = 0; i < names.size(); ++i) {
    names[i].setInterface(commands[i].interface);
    names[i].setOrdinal(commands[i].method);
    latest.set(i, contract.commands[i].latest);
  }
}

/// Returns the numbers here of the commands that a client has named.
std::vector<std::uint16_t> numbersOf(capnp::List<wire::FrameRequest::Method>::Reader names,
                                     const InterfaceInfo& contract) {
  const auto commands = contract.codec().commands;
  std::vector<std::uint16_t> numbers(names.size(), ProviderSide::kUnknown);
  for (unsigned i = 0; i < names.size(); ++i) {
    const auto found =
        std::find_if(commands.begin(), commands.end(), [&](const codec::CommandCodec& one) {
          return one.interface == names[i].getInterface() && one.method == names[i].getOrdinal();
        });
    if (found != commands.end()) {
      numbers[i] = static_cast<std::uint16_t>(found - commands.begin());
    }
  }
  return numbers;
}

bool hasTooMany(wire::FrameRequest::Reader request) {
  return std::max(request.getCommands().size(), request.getLatest().size()) > kMostCommands;
}

ClientCommands commandsOf(wire::FrameRequest::Reader request, const InterfaceInfo& contract) {
  ClientCommands commands{numbersOf(request.getCommands(), contract), {}};
  for (const bool latest : request.getLatest()) commands.latest.push_back(latest);
  return commands;
}

class FrameAttempt final : public LaneAttempt {
 public:
  /// `mayBeSlots` says that slots mean the same in both processes, if they lie in memory alike.
  FrameAttempt(FrameLane& lane, loop::ControlThread& control, const InterfaceInfo& contract,
               std::shared_ptr<SessionLink> link, bool mayBeSlots)
      : lane_(lane),
        control_(control),
        contract_(contract),
        link_(std::move(link)),
        mayBeSlots_(mayBeSlots) {}

  void request(capnp::AnyPointer::Builder out) override {
    auto request = out.initAs<wire::FrameRequest>();
    if (mayBeSlots_) request.setLayout(codec::textOf(memoryLayout(contract_)));
    request.setSocket(link_->number);
    describeCommands(contract_, request);
  }

  kj::Promise<OpenedEnd> open(OutgoingConnection connection,
                              capnp::AnyPointer::Reader answer) override {
    const auto accepted = answer.getAs<wire::FrameAnswer>();
    const Form form = accepted.getEncoded() ? Form::Encoded : Form::Slots;
    return openFramed(std::move(connection),
                      {lane_.name(), lane_.thread(), link_->link, accepted.getConnection(), form},
                      control_);
  }

 private:
  FrameLane& lane_;
  loop::ControlThread& control_;
  const InterfaceInfo& contract_;
  const std::shared_ptr<SessionLink> link_;
  const bool mayBeSlots_;
};

class FrameClient final : public LaneClient {
 public:
  FrameClient(FrameLane& lane, ClientSession& session) : lane_(lane), session_(session) {}
  // The thread then checks if the link is still needed.
  ~FrameClient() noexcept(false) {
    link_ = nullptr;
    lane_.thread().doorbell()->ring();
  }

  std::string whyNot(const OutgoingConnection& connection) const override {
    return whyUnbounded(connection.contract);
  }

  kj::Promise<kj::Own<LaneAttempt>> attempt(const OutgoingConnection& connection) override {
    return opened_.get([this] { return open(); })
        .then([this, &contract = connection.contract](
                  std::shared_ptr<SessionLink>&& link) -> kj::Own<LaneAttempt> {
          link_ = link;
          const bool mayBeSlots =
              lane_.form() == Form::Slots && (session_.hasOneClock() || !hidesStamps(contract));
          return kj::heap<FrameAttempt>(lane_, session_.control(), contract, std::move(link),
                                        mayBeSlots);
        });
  }

  void bear(Duration silence) override {
    longest_ = silence;
    if (link_ != nullptr) net::breakWhenUnanswered(link_->link->descriptor(), silence);
  }

 private:
  kj::Promise<std::shared_ptr<SessionLink>> open() {
    return session_.openSocket(lane_.name()).then([this](LaneSocket&& socket) {
      net::breakWhenUnanswered(socket.bytes.socket(), longest_);
      return std::make_shared<SessionLink>(kj::mv(socket), lane_.thread());
    });
  }

  FrameLane& lane_;
  ClientSession& session_;
  Duration longest_{0};
  loop::OpenedOnce<SessionLink> opened_;
  std::shared_ptr<SessionLink> link_;  // as long as the session has no other
};

class FrameServer final : public LaneServer, private loop::Pump {
 public:
  FrameServer(FrameLane& lane, ServerSession& session) : lane_(lane), session_(session) {
    session_.control().add(*this);
  }
  ~FrameServer() noexcept(false) {
    session_.control().remove(*this);
    pump();
    link_ = nullptr;
    lane_.thread().doorbell()->ring();
  }

  kj::Promise<AcceptedEnd> accept(IncomingConnection connection, capnp::AnyPointer::Reader brings,
                                  capnp::AnyPointer::Builder answer) override {
    const auto request = brings.getAs<wire::FrameRequest>();
    std::string why = whyUnbounded(connection.contract);
    if (why.empty() && !carries(request.getSocket())) why = "the session's frames have ended";
    if (why.empty() && hasTooMany(request)) why = "it has too many commands";
    if (!why.empty()) return loop::failure(kj::Exception::Type::FAILED, why);
    const bool encoded =
        !whyOtherSlots(connection.contract, codec::stringOf(request.getLayout())).empty();
    auto accepted = answer.initAs<wire::FrameAnswer>();
    accepted.setConnection(++latest_);
    accepted.setEncoded(encoded);
    const FramedOn on{lane_.name(), lane_.thread(), link_->link, latest_,
                      encoded ? Form::Encoded : Form::Slots};
    return acceptFramed(connection, on, session_.control(),
                        commandsOf(request, connection.contract));
  }

  // A value that comes in pieces is joined outside of the channel.
  std::size_t bytesFor(const IncomingConnection& connection) const override {
    return Channel::bytesFor(connection.contract) + largestSlot(connection.contract);
  }

  // Connections on the socket before keep it for as long as they live.
  void opened(LaneSocket socket) override {
    pump();
    link_ = std::make_shared<SessionLink>(kj::mv(socket), lane_.thread());
    told_ = false;
  }

 private:
  // Tells the operator of this process what ended the link, if the peer is to blame.
  void pump() override {
    if (told_ || link_ == nullptr || !link_->broken() || link_->link->refusal().empty()) return;
    told_ = true;
    session_.cutOff(link_->link->refusal());
  }
  bool carries(std::uint32_t socket) const {
    return link_ != nullptr && link_->number == socket && !link_->broken();
  }

  FrameLane& lane_;
  ServerSession& session_;
  std::shared_ptr<SessionLink> link_;
  bool told_ = false;         // what of it was refused
  std::uint32_t latest_ = 0;  // connection
};

}  // namespace

std::string FrameLane::whyNever(const InterfaceInfo& contract, bool /*byUnixSocket*/) const {
  return whyUnbounded(contract);
}

kj::Own<LaneClient> FrameLane::makeClient(ClientSession& session) {
  return kj::heap<FrameClient>(*this, session);
}

kj::Own<LaneServer> FrameLane::makeServer(ServerSession& session) {
  return kj::heap<FrameServer>(*this, session);
}

}  // namespace suture::frame
