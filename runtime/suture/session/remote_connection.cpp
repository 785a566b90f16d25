#include <suture/lane/delay/delay_thread.h>
#include <suture/lane/frame/client_side.h>
#include <suture/lane/frame/frame_end.h>
#include <suture/lane/frame/frame_sockets.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/shm/shared_memory.h>
#include <suture/loop/deadline.h>
#include <suture/loop/failure.h>
#include <suture/net/socket.h>
#include <suture/session/notices_receiver.h>
#include <suture/session/peer_host.h>
#include <suture/session/remote_connection.h>
#include <suture/session/tallies.h>
#include <suture/wire/stamps.h>
#include <suture/wiring/memory_layout.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

using Type = kj::Exception::Type;

constexpr Duration kDialLimit = std::chrono::seconds(2);
constexpr Duration kFirstRedialPause = std::chrono::milliseconds(50);
// A pause and an attempt that fails together take less than the second within which the connection
// is to be back after a fault.
constexpr Duration kLongestRedialPause = std::chrono::milliseconds(250);
constexpr Duration kTakeOverLimit = std::chrono::milliseconds(500);
constexpr Duration kComeBackPatience = std::chrono::seconds(5);

constexpr unsigned kClockQuestions = 8;

std::string microseconds(Duration duration) {
  return std::to_string(std::chrono::duration_cast<std::chrono::microseconds>(duration).count()) +
         " us";
}

// Keeps as many rows as the provider, up to a bound: a peer must not make us take more memory.
void mirrorRows(std::uint32_t rows, rt::StateTable& mirror) {
  constexpr std::size_t kMostBytes = std::size_t{64} << 20;
  const std::size_t most = std::max<std::size_t>(kMostBytes / mirror.rowBytes(), 1);
  const auto kept = static_cast<unsigned>(std::min<std::size_t>(rows, most));
  if (kept > mirror.capacity()) mirror.resize(kept);
}

}  // namespace

RemoteConnection::RemoteConnection(rpc::ControlThread& control, FrameLinks& frames,
                                   ManagerLink& manager, RequiredBase& required, Endpoint from,
                                   Endpoint to, Lane lane, Told told, const Interposer& interposer,
                                   std::shared_ptr<ConnectionWatch> watch,
                                   std::uint64_t incarnation, std::shared_ptr<Ledger> ledger)
    : control_(control),
      frames_(frames),
      manager_(manager),
      required_(required),
      from_(std::move(from)),
      to_(std::move(to)),
      lane_(lane),
      told_(std::move(told)),
      interposer_(interposer),
      watch_(std::move(watch)),
      incarnation_(incarnation),
      ledger_(std::move(ledger)),
      longestSilence_(watch_ == nullptr ? ConnectionContract::kDefaultSilence
                                        : watch_->contract.longestSilence()) {}

RemoteConnection::~RemoteConnection() noexcept(false) {
  keeping_ = kj::READY_NOW;
  KJ_IF_MAYBE (end, end_) (*end)->close(ChannelStatus::Lost);
}

kj::Promise<void> RemoteConnection::open(Duration patience) {
  return connect(patience, patience + kDialLimit).then([this] {
    keeping_ = keep().eagerlyEvaluate(nullptr);
  });
}

void RemoteConnection::end() {
  keeping_ = kj::READY_NOW;
  KJ_IF_MAYBE (end, end_) (*end)->close(ChannelStatus::Closed);
}

kj::Promise<void> RemoteConnection::connect(Duration patience, Duration limit) {
  auto connected =
      manager_.resolve(to_.process, patience)
          .then([this, limit](const ProcessRecord& process) { return dial(process, limit); })
          .then([this, limit] { return introduce(limit); });
  // The manager itself answers in time, so only the peer can be late.
  return rpc::within(control_.timer(), patience + kDialLimit, kj::mv(connected),
                     "process '" + to_.process +
                         "' is there, but does not answer. It hangs, has no file descriptor left "
                         "for another link, or has not yet made its components known: see what it "
                         "says and does.");
}

kj::Promise<void> RemoteConnection::dial(const ProcessRecord& process, Duration limit) {
  process_ = process;
  return manager_.reach(process, std::min(limit, kDialLimit)).then([this](rpc::ByteStream bytes) {
    sharesMachine_ = bytes.carriesDescriptors();
    if (!sharesMachine_) rpc::breakWhenUnanswered(bytes.socket(), longestSilence_);
    auto stream = kj::heap<rpc::MessageStream>(control_.port(), kj::mv(bytes));
    link_ = kj::heap<rpc::Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT);
    peer_ = KJ_ASSERT_NONNULL(link_)->bootstrap<wire::Peer>();
  });
}

// Does not connect a provider that hangs, only to lose it again.
kj::Promise<void> RemoteConnection::introduce(Duration limit) {
  auto heartbeat = makeHeartbeat(limit);
  auto lost = heartbeat->whenLost().then([this](std::string&& why) -> kj::Promise<void> {
    return rpc::failure(Type::FAILED, "connecting " + from_.toString() + " -> " + to_.toString() +
                                          ": the provider is " + why +
                                          ". Look at what it is doing.");
  });
  auto well = heartbeat->whenWell();
  return lost
      .exclusiveJoin(
          greet().then([well = kj::mv(well)]() mutable { return kj::mv(well); }).then([this] {
            return ask();
          }))
      .attach(kj::mv(heartbeat));
}

kj::Promise<void> RemoteConnection::greet() {
  auto request = KJ_ASSERT_NONNULL(peer_).helloRequest();
  request.setVersion(wire::PROTOCOL_VERSION);
  request.setProcess(textOf(from_.process));
  request.setBootId(textOf(bootId()));
  request.setIncarnation(incarnation_);
  const Time asked = now();
  return request.send().then([this, asked](auto&& results) -> kj::Promise<void> {
    if (results.isRefused()) return refused(results.getRefused());
    providersIncarnation_ = results.getIncarnation();
    if (stringOf(results.getBootId()) == bootId()) {
      clock_ = ClockOffset::none();
      return kj::READY_NOW;
    }
    clock_ = {};
    clock_.add(asked, results.getReceived(), results.getSent(), now());
    return compareClocks(kClockQuestions);
  });
}

kj::Promise<void> RemoteConnection::compareClocks(unsigned times) {
  if (times == 0) return requireClocksThatCanTell();
  const Time asked = now();
  return KJ_ASSERT_NONNULL(peer_).pingRequest().send().then([this, asked, times](auto&& told) {
    clock_.add(asked, told.getReceived(), told.getSent(), now());
    return compareClocks(times - 1);
  });
}

// Within the clocks' error a ttl means nothing: late commands would run, or timely ones be late.
kj::Promise<void> RemoteConnection::requireClocksThatCanTell() {
  const Duration error = clock_.error(now());
  for (const CommandInfo& one : required_.info().commands) {
    if (one.ttl == Duration{0} || one.ttl > error) continue;
    return rpc::failure(Type::FAILED,
                        "connecting " + name() + ": '" + one.name + "' has a ttl of " +
                            microseconds(one.ttl) + ", and the two clocks can be compared to " +
                            microseconds(error) + " only. Use a faster link, or a longer ttl.");
  }
  return kj::READY_NOW;
}

Component& RemoteConnection::client() const {
  return interposer_.delays == nullptr ? required_.owner() : *interposer_.delays;
}

RemoteConnection::Lanes RemoteConnection::wantedLanes() {
  laneReason_.clear();
  if (lane_ == Lane::Rpc) return {};
  laneReason_ = whyUnbounded(required_.info());
  if (!laneReason_.empty()) return {};
  // In shared memory nothing converts stamps, and in frames nothing converts hidden ones.
  if (!clock_.isOne() && (lane_ != Lane::Frame || hidesStamps(required_.info()))) {
    laneReason_ = "the two processes have different clocks";
    return {.frames = !hidesStamps(required_.info())};
  }
  if (lane_ == Lane::Frame) return {.frames = true};
  if (!sharesMachine_) laneReason_ = "the two processes are not reached by a Unix socket";
  return {.memory = sharesMachine_, .frames = true};
}

// If the peer agrees to a faster lane that then cannot be had, we ask for frames on a new link,
// and then for calls.
kj::Promise<void> RemoteConnection::ask() {
  const Lanes wanted = wantedLanes();
  return ask(wanted)
      .catch_([this, wanted, reason = laneReason_](kj::Exception&& failure) {
        if (!wanted.memory) laneReason_ = reason;
        return askAgain(kj::mv(failure), {.frames = wanted.frames});
      })
      .catch_([this](kj::Exception&& failure) { return askAgain(kj::mv(failure), {}); });
}

kj::Promise<void> RemoteConnection::askAgain(kj::Exception&& failure, Lanes lanes) {
  if (!std::exchange(fasterFailed_, false)) return kj::mv(failure);
  frames_.rename(to_.process);
  return ask(lanes);
}

kj::Promise<void> RemoteConnection::ask(Lanes lanes) {
  auto news = kj::refcounted<ProviderNews>();
  auto request = KJ_ASSERT_NONNULL(peer_).connectRequest();
  request.setFromProcess(textOf(from_.process));
  request.setFromComponent(textOf(from_.component));
  request.setRequired(textOf(from_.interface));
  request.setToComponent(textOf(to_.component));
  request.setProvided(textOf(to_.interface));
  request.setContract(required_.info().name);
  request.setHash(required_.info().hash);
  request.setDescription(required_.info().description);
  toWire(required_.frames(), request.initFrames());
  asked_ = required_.subscribed();
  request.setEvents(toWireNumbers(required_.info().wireEvents, asked_));
  request.setClockOffset(-clock_.offset().count());
  toldError_ = clockError();
  request.setClockError(toldError_.count());
  request.setEpoch(toNanoseconds(now()));
  request.setSilence(longestSilence_.count());
  request.setNotices(kj::heap<NoticesReceiver>(
      kj::addRef(*news), ledger_,
      [tell = told_.lost, name = name()](std::string why) { tell(name, std::move(why)); }));
  if (lanes.memory) {
    auto memory = request.initMemory();
    memory.setLayout(textOf(memoryLayout(required_.info())));
    memory.setBell(handOut(client().doorbell().share()));
  }
  if (lanes.frames) {
    const std::string client = frames_.client(to_.process, longestSilence_);
    auto frame = request.initFrame();
    frame.setLayout(textOf(memoryLayout(required_.info())));
    frame.setHandsOver(sharesMachine_);
    frame.setClient(kj::StringPtr(client.c_str(), client.size()).asBytes());
  }
  news_ = kj::mv(news);
  return request.send()
      .then([this](auto&& results) -> kj::Promise<void> {
        if (results.isRefused()) return refused(results.getRefused());
        return begin(results.getAccepted());
      })
      .attach(frames_.hold(to_.process));
}

kj::Promise<void> RemoteConnection::begin(wire::ConnectResults::Accepted::Reader accepted) {
  connection_ = accepted.getConnection();
  earlier_ = fromWire(accepted.getEarlier());
  if (accepted.hasLaneReason()) laneReason_ = stringOf(accepted.getLaneReason());
  if (!accepted.hasMemory() && !accepted.hasFrame()) {
    beginCalls(accepted);
    return kj::READY_NOW;
  }
  return beginFaster(accepted).catch_([this](kj::Exception&& failure) -> kj::Promise<void> {
    laneReason_ = rpc::describe(failure);
    fasterFailed_ = true;
    connection_ = nullptr;
    return kj::mv(failure);
  });
}

kj::Promise<void> RemoteConnection::beginFaster(wire::ConnectResults::Accepted::Reader accepted) {
  if (accepted.hasMemory()) {
    return receive(accepted.getMemory(), required_.info())
        .then([this](const shm::SharedParts& parts) { beginSharing(parts); });
  }
  const std::uint32_t number = accepted.getFrame().getConnection(), rows = accepted.getRows();
  return openLink(accepted.getFrame()).then([this, number, rows](const FrameLinks::Link& link) {
    beginFrames(link, number, rows);
  });
}

std::shared_ptr<Channel> RemoteConnection::mirroredChannel(Lane lane, rt::Doorbell& carrier,
                                                           std::uint32_t rows) {
  const Channel::Ends ends{
      .client = &client().doorbell(), .provider = &carrier, .watcher = &control_.doorbell()};
  auto channel = std::make_shared<Channel>(required_.info(), name(), toString(lane), ends,
                                           makeStateTable(required_.info()), asked_);
  channel->clientsBell = client().sharedDoorbell();
  channel->laneReason = laneReason_;
  channel->setClock(-clock_.offset(), clockError());
  mirrorRows(rows, *channel->state);
  return channel;
}

void RemoteConnection::beginCalls(wire::ConnectResults::Accepted::Reader accepted) {
  auto channel = mirroredChannel(Lane::Rpc, control_.doorbell(), accepted.getRows());
  for (const std::uint16_t command : accepted.getLacking()) channel->lacking.push_back(command);
  std::sort(channel->lacking.begin(), channel->lacking.end());
  auto port =
      kj::refcounted<rpc::ProxyPort>(control_, channel, KJ_ASSERT_NONNULL(link_)->counters());
  end_ = kj::addRef(*port);
  port->open(required_.info().binding().makeProxy(accepted.getContract(), *port));
  use(std::move(channel));
}

kj::Promise<FrameLinks::Link> RemoteConnection::openLink(wire::FrameOffer::Reader offer) {
  const std::uint32_t epoch = offer.getEpoch();
  if (offer.hasSocket() || offer.hasToken()) {
    return openSocket(offer).then([this, epoch](rpc::ByteStream bytes) {
      return frames_.open(to_.process, epoch, kj::mv(bytes));
    });
  }
  return rpc::within(control_.timer(), kDialLimit, frames_.find(to_.process, epoch),
                     "the socket that the provider says is on its way has not come");
}

kj::Promise<rpc::ByteStream> RemoteConnection::openSocket(wire::FrameOffer::Reader offer) {
  if (!offer.hasToken()) return receiveSocket(offer.getSocket());
  return manager_.reach(process_, kDialLimit)
      .then([this, token = kj::heapArray(offer.getToken().asConst())](rpc::ByteStream bytes) {
        rpc::breakWhenUnanswered(bytes.socket(), longestSilence_);
        return showToken(control_.port(), kj::mv(bytes), token);
      });
}

void RemoteConnection::beginFrames(const FrameLinks::Link& link, std::uint32_t number,
                                   std::uint32_t rows) {
  const std::shared_ptr<rt::Doorbell> bell = frames_.doorbell();
  auto channel = mirroredChannel(Lane::Frame, *bell, rows);
  channel->providersBell = bell;
  const auto connection = std::make_shared<frame::ClientSide>(channel, number);
  auto end = kj::refcounted<FrameEnd>(control_, channel, connection);
  framesBroken_ = end->whenBroken();
  end_ = kj::mv(end);
  link->join(connection);
  bell->ring();
  use(std::move(channel));
}

void RemoteConnection::beginSharing(const shm::SharedParts& parts) {
  auto channel = shm::takeShared(required_.info(), name(), client().sharedDoorbell(), parts);
  end_ = kj::refcounted<rpc::ClientEnd>(channel);
  use(std::move(channel));
}

void RemoteConnection::use(std::shared_ptr<Channel> channel) {
  channel->watch = watch_;
  KJ_ASSERT_NONNULL(news_)->passOnTo(kj::addRef(*KJ_ASSERT_NONNULL(end_)));
  if (interposer_.delays != nullptr) {
    channel = interposer_.delays->interpose(required_, std::move(channel), interposer_.delay);
  }
  channel->ledger = ledger_;
  ledger_->begin(channel, providersIncarnation_, earlier_);
  told_.made(channel);  // known before it is used
  required_.attach(std::move(channel));
}

kj::Promise<void> RemoteConnection::keep() {
  auto closed = KJ_ASSERT_NONNULL(link_)->onDisconnect().then(
      [] { return std::string("closed: its process has ended, or the link is broken"); });
  auto broken = std::exchange(framesBroken_, kj::NEVER_DONE);
  auto heartbeat = makeHeartbeat(longestSilence_);
  if (!clock_.isOne()) {
    heartbeat->onAnswer([this](Time asked, auto answer) { followClock(asked, answer); });
  }
  auto lost = heartbeat->whenLost();
  return closed.exclusiveJoin(lost.attach(kj::mv(heartbeat)))
      .exclusiveJoin(kj::mv(broken))
      .exclusiveJoin(KJ_ASSERT_NONNULL(news_)->whenLapsed())
      .then([this](std::string&& why) {
        told_.lost(name(), std::move(why));
        drop();
        return comeBack(kFirstRedialPause);
      })
      .then([this] { return keep(); });
}

// The error until the next comparison; without one, the connection is lost by then.
Duration RemoteConnection::clockError() const { return clock_.error(now() + longestSilence_); }

// Clocks drift apart, so the provider is told what is known better now, or much worse.
void RemoteConnection::followClock(Time asked, wire::Peer::PingResults::Reader answer) {
  const bool better = clock_.add(asked, answer.getReceived(), answer.getSent(), now());
  const Duration offset = clock_.offset(), error = clockError();
  KJ_IF_MAYBE (end, end_) (*end)->setClock(-offset, error);
  KJ_IF_MAYBE (connection, connection_) {
    if (!better && error < toldError_ + toldError_ / 2) return;
    toldError_ = error;
    auto request = connection->comparedRequest();
    request.setClockOffset(-offset.count());
    request.setClockError(error.count());
    telling_ = request.send().ignoreResult().eagerlyEvaluate([](kj::Exception&&) {});
  }
}

// A peer that is stopped, or behind a cable that was pulled, says nothing; so it is asked.
kj::Own<Heartbeat> RemoteConnection::makeHeartbeat(Duration silence) {
  return kj::heap<Heartbeat>(control_.timer(), KJ_ASSERT_NONNULL(peer_), to_.component,
                             Heartbeat::Bounds{.silence = silence, .hang = longestSilence_});
}

void RemoteConnection::drop() {
  KJ_IF_MAYBE (end, end_) (*end)->close(ChannelStatus::Lost);
  end_ = nullptr;
  news_ = nullptr;
  telling_ = kj::READY_NOW;
  connection_ = nullptr;
  peer_ = nullptr;
  link_ = nullptr;
}

kj::Promise<void> RemoteConnection::comeBack(Duration pause) {
  return control_.timer()
      .afterDelay(rpc::toKj(pause))
      .then([this] { return connect(kComeBackPatience, kTakeOverLimit); })
      .catch_([this, pause](kj::Exception&&) {
        drop();
        return comeBack(std::min(2 * pause, kLongestRedialPause));
      });
}

}  // namespace suture
