#include <suture/manager/peer_host.h>
#include <suture/manager/remote_connection.h>
#include <suture/transport/delay/delay_thread.h>
#include <suture/transport/rpc/deadline.h>
#include <suture/transport/rpc/dialer.h>
#include <suture/transport/rpc/stamps.h>

#include <algorithm>

namespace suture {
namespace {

using Type = kj::Exception::Type;

constexpr Duration kDialLimit = std::chrono::seconds(2);
constexpr Duration kFirstPause = std::chrono::milliseconds(50);
constexpr Duration kLongestPause = std::chrono::seconds(2);
constexpr Duration kComeBackPatience = std::chrono::seconds(5);
constexpr Duration kHeartbeat = std::chrono::milliseconds(500);
constexpr Duration kSilence = std::chrono::seconds(2);

// As far back as the provider's own table; a peer must not make this process take more memory.
void mirrorRows(std::uint32_t rows, rt::StateTable& mirror) {
  constexpr std::size_t kMostBytes = std::size_t{64} << 20;
  const std::size_t most = std::max<std::size_t>(kMostBytes / mirror.rowBytes(), 1);
  const auto kept = static_cast<unsigned>(std::min<std::size_t>(rows, most));
  if (kept > mirror.capacity()) mirror.resize(kept);
}

}  // namespace

/// Hears what befalls the provider.
class RemoteConnection::NoticesReceiver final : public wire::Notices::Server {
 public:
  explicit NoticesReceiver(kj::Own<rpc::ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> faulted(FaultedContext) override {
    port_->tell(ChannelStatus::Faulted);
    return kj::READY_NOW;
  }
  kj::Promise<void> suspended(SuspendedContext) override {
    port_->tell(ChannelStatus::Suspended);
    return kj::READY_NOW;
  }
  kj::Promise<void> resumed(ResumedContext) override {
    port_->tell(ChannelStatus::Connected);
    return kj::READY_NOW;
  }
  kj::Promise<void> replayed(ReplayedContext context) override {
    const auto in = context.getParams();
    port_->noteReplay(in.getEvent(), in.getStamp());
    return kj::READY_NOW;
  }
  kj::Promise<void> closed(ClosedContext) override {
    port_->close(ChannelStatus::Lost);
    return kj::READY_NOW;
  }

 private:
  kj::Own<rpc::ProxyPort> port_;
};

RemoteConnection::RemoteConnection(rpc::ControlThread& control, ManagerLink& manager,
                                   RequiredBase& required, Endpoint from, Endpoint to, Made made,
                                   const Interposer& interposer,
                                   std::shared_ptr<ConnectionWatch> watch)
    : control_(control),
      manager_(manager),
      required_(required),
      from_(std::move(from)),
      to_(std::move(to)),
      made_(std::move(made)),
      interposer_(interposer),
      watch_(std::move(watch)) {}

RemoteConnection::~RemoteConnection() noexcept(false) {
  keeping_ = kj::READY_NOW;
  KJ_IF_MAYBE (port, port_) (*port)->close(ChannelStatus::Lost);
}

kj::Promise<void> RemoteConnection::open(Duration patience) {
  return connect(patience).then([this] { keeping_ = keep().eagerlyEvaluate(nullptr); });
}

void RemoteConnection::end() {
  keeping_ = kj::READY_NOW;
  KJ_IF_MAYBE (port, port_) (*port)->close(ChannelStatus::Closed);
}

kj::Promise<void> RemoteConnection::connect(Duration patience) {
  auto connected = manager_.resolve(to_.process, patience)
                       .then([this](ProcessRecord process) { return dial(process); })
                       .then([this] { return greet(); })
                       .then([this] { return ask(); });
  // The manager answers in time itself; what is left is the peer.
  return rpc::within(control_.timer(), patience + kDialLimit, kj::mv(connected),
                     "process '" + to_.process +
                         "' is there, but does not answer, or has not yet made its "
                         "components known. Look at what it is doing.");
}

kj::Promise<void> RemoteConnection::dial(const ProcessRecord& process) {
  if (process.addresses.empty()) {
    return rpc::failure(Type::FAILED, "process '" + process.name + "' has no address. Restart it.");
  }
  const auto address = rpc::Address::parse(process.addresses.front());
  return rpc::dial(control_.port(), address, kDialLimit).then([this](kj::AutoCloseFd socket) {
    auto stream = kj::heap<rpc::MessageStream>(control_.port(), kj::mv(socket));
    link_ = kj::heap<rpc::Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT);
    peer_ = KJ_ASSERT_NONNULL(link_)->bootstrap<wire::Peer>();
  });
}

kj::Promise<void> RemoteConnection::greet() {
  auto request = KJ_ASSERT_NONNULL(peer_).helloRequest();
  request.setVersion(wire::PROTOCOL_VERSION);
  request.setProcess(textOf(from_.process));
  request.setBootId(textOf(bootId()));
  const Time asked = now();
  return request.send().then([this, asked](auto&& results) -> kj::Promise<void> {
    if (results.isRefused()) return refused(results.getRefused());
    const Time answered = now();
    const auto there = Duration(rpc::bounded(results.getReceived() / 2 + results.getSent() / 2));
    const auto here = asked.time_since_epoch() / 2 + answered.time_since_epoch() / 2;
    const bool sameMachine = stringOf(results.getBootId()) == bootId();
    clockOffset_ = sameMachine ? Duration{0} : there - here;
    return kj::READY_NOW;
  });
}

kj::Promise<void> RemoteConnection::ask() {
  Component& client = interposer_.delays == nullptr ? required_.owner() : *interposer_.delays;
  const Channel::Ends ends{.client = &client.doorbell(), .provider = &control_.doorbell()};
  channel_ =
      std::make_shared<Channel>(required_.info(), from_.toString() + " -> " + to_.toString(), "rpc",
                                ends, makeStateTable(required_.info()), required_.subscribed());
  channel_->clientsBell = client.sharedDoorbell();
  channel_->watch = watch_;
  auto port = kj::refcounted<rpc::ProxyPort>(control_, channel_, -clockOffset_,
                                             KJ_ASSERT_NONNULL(link_)->counters());
  auto request = KJ_ASSERT_NONNULL(peer_).connectRequest();
  request.setFromProcess(textOf(from_.process));
  request.setFromComponent(textOf(from_.component));
  request.setRequired(textOf(from_.interface));
  request.setToComponent(textOf(to_.component));
  request.setProvided(textOf(to_.interface));
  request.setContract(required_.info().name);
  request.setHash(required_.info().hash);
  request.setDescription(required_.info().description);
  request.setEvents(required_.subscribed());
  request.setClockOffset(-clockOffset_.count());
  request.setNotices(kj::heap<NoticesReceiver>(kj::addRef(*port)));
  port_ = kj::mv(port);
  return request.send().then([this](auto&& results) -> kj::Promise<void> {
    if (results.isRefused()) return refused(results.getRefused());
    begin(results.getAccepted());
    return kj::READY_NOW;
  });
}

void RemoteConnection::begin(wire::ConnectResults::Accepted::Reader accepted) {
  connection_ = accepted.getConnection();
  channel_->offered = std::min<std::size_t>(accepted.getOffered(), channel_->info.commands.size());
  mirrorRows(accepted.getRows(), *channel_->state);
  auto& port = *KJ_ASSERT_NONNULL(port_);
  port.open(required_.info().binding().makeProxy(accepted.getContract(), port));
  std::shared_ptr<Channel> clients = channel_;
  if (interposer_.delays != nullptr) {
    clients = interposer_.delays->interpose(required_, channel_, interposer_.delay);
  }
  made_(clients);  // known before it is used
  required_.attach(std::move(clients));
}

kj::Promise<void> RemoteConnection::keep() {
  return KJ_ASSERT_NONNULL(link_)
      ->onDisconnect()
      .exclusiveJoin(whenSilent())
      .then([this] {
        lost();
        return comeBack(kFirstPause);
      })
      .then([this] { return keep(); });
}

// A peer that is stopped, or behind a cable that was pulled, says nothing; so it is asked.
kj::Promise<void> RemoteConnection::whenSilent() {
  return control_.timer().afterDelay(rpc::toKj(kHeartbeat)).then([this] {
    auto ping = KJ_ASSERT_NONNULL(peer_).pingRequest().send().ignoreResult();
    return rpc::within(control_.timer(), kSilence, kj::mv(ping), "silent")
        .then([this] { return whenSilent(); },
              [](kj::Exception&&) -> kj::Promise<void> { return kj::READY_NOW; });
  });
}

void RemoteConnection::lost() {
  KJ_IF_MAYBE (port, port_) (*port)->close(ChannelStatus::Lost);
  port_ = nullptr;
  connection_ = nullptr;
  peer_ = nullptr;
  link_ = nullptr;
}

kj::Promise<void> RemoteConnection::comeBack(Duration pause) {
  return control_.timer()
      .afterDelay(rpc::toKj(pause))
      .then([this] { return connect(kComeBackPatience); })
      .catch_([this, pause](kj::Exception&&) {
        lost();
        return comeBack(std::min(2 * pause, kLongestPause));
      });
}

}  // namespace suture
