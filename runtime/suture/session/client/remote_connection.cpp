#include <suture/base/plain.h>
#include <suture/codec/tallies.h>
#include <suture/lane/delay/delay_thread.h>
#include <suture/lane/lane_refusals.h>
#include <suture/loop/deadline.h>
#include <suture/loop/failure.h>
#include <suture/session/client/notices_receiver.h>
#include <suture/session/client/remote_connection.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

using Type = kj::Exception::Type;

constexpr Duration kFirstRedialPause = std::chrono::milliseconds(50);
// Attempts begin at least so long after each other, however fast they fail.
constexpr Duration kLongestRedialPause = std::chrono::milliseconds(250);
// After a short fault another attempt comes soon. Later ones wait as long for an answer as a first
// connection does, because the way to the peer may have become longer. Each begins when its
// predecessor has ended, so that the kernel knocks once in a second at least.
constexpr Duration kFirstAnswerLimit = std::chrono::milliseconds(500);
constexpr Duration kComeBackPatience = std::chrono::seconds(5);
// An attempt whose answers all come in time may take this long. Network::connect() waits longer.
constexpr Duration kAttemptLimit = std::chrono::seconds(9);

/// Returns what two texts have in common that differ by how long or how wrong something is.
std::string withoutNumbers(std::string text) {
  std::erase_if(text, [](char one) { return one >= '0' && one <= '9'; });
  return text;
}

bool mayPass(const kj::Exception& failure) {
  return failure.getType() == Type::DISCONNECTED || failure.getType() == Type::OVERLOADED;
}

std::string microseconds(Duration duration) {
  return std::to_string(std::chrono::duration_cast<std::chrono::microseconds>(duration).count()) +
         " us";
}

}  // namespace

RemoteConnection::RemoteConnection(Sessions& sessions, PlannedConnection planned, Listener listener,
                                   std::shared_ptr<Ledger> ledger)
    : sessions_(sessions),
      planned_(std::move(planned)),
      listener_(std::move(listener)),
      ledger_(std::move(ledger)),
      longestSilence_(planned_.watch == nullptr ? ConnectionContract::kDefaultSilence
                                                : planned_.watch->contract.longestSilence()),
      firstLane_(firstLane()) {}

RemoteConnection::~RemoteConnection() noexcept(false) {
  letGo();
  KJ_IF_MAYBE (end, end_) (*end)->close(ChannelStatus::Lost);
}

kj::Promise<void> RemoteConnection::open() {
  return connect(planned_.options.patience, planned_.options.patience + kDialLimit).then([this] {
    keep();
  });
}

void RemoteConnection::letGo() {
  losing_ = nullptr;
  comingBack_ = nullptr;
}

void RemoteConnection::end() {
  letGo();
  KJ_IF_MAYBE (end, end_) (*end)->close(ChannelStatus::Closed);
}

kj::Promise<void> RemoteConnection::connect(Duration patience, Duration limit) {
  limit_ = limit;
  auto connected = sessions_.open(planned_.to.process, patience, limit)
                       .then([this](std::shared_ptr<PeerSession> session) {
                         session_ = std::move(session);
                         return introduce();
                       });
  // The manager itself answers in time, so only the peer can be late.
  return inTime(patience + kAttemptLimit, kj::mv(connected));
}

template <class T>
kj::Promise<T> RemoteConnection::inTime(Duration limit, kj::Promise<T> answer) {
  return loop::within(sessions_.control().timer(), limit, kj::mv(answer),
                      noAnswerOf(planned_.to.process));
}

// Does not connect to a provider that hangs, because the connection would be lost at once.
kj::Promise<void> RemoteConnection::introduce() {
  auto lost = kj::newPromiseAndFulfiller<void>();
  auto watch =
      session_->watch(planned_.to.component, {.silence = Heartbeat::kEver, .hang = longestSilence_},
                      [this, out = kj::mv(lost.fulfiller)](const std::string& why) mutable {
                        out->reject(whyNotIntroduced(why));
                      });
  auto asked = inTime(limit_, watch->whenItWorks())
                   .then([this] { return requireClocksThatCanTell(); })
                   .then([this] {
                     laneReason_.clear();
                     return ask(firstLane_);
                   });
  return lost.promise.exclusiveJoin(kj::mv(asked)).attach(kj::mv(watch));
}

// A question that was lost with its link is never answered.
kj::Exception RemoteConnection::whyNotIntroduced(const std::string& why) const {
  const std::string what = "connecting " + name() + ": ";
  return session_->closed() ? loop::disconnected(what + "the link was " + why + ". Try again.")
                            : loop::failure(Type::FAILED, what + "the provider is " + why +
                                                              ". Look at what it is doing.");
}

// Within the clocks' error a ttl means nothing: late commands would run, or timely ones be late.
kj::Promise<void> RemoteConnection::requireClocksThatCanTell() {
  const Duration error = session_->clock().error(now());
  for (const CommandInfo& one : planned_.required.info().commands) {
    if (one.ttl == Duration{0} || one.ttl > error) continue;
    return loop::failure(Type::FAILED,
                         "connecting " + name() + ": '" + one.name + "' has a ttl of " +
                             microseconds(one.ttl) + ", and the two clocks can be compared to " +
                             microseconds(error) + " only. Use a faster link, or a longer ttl.");
  }
  return kj::READY_NOW;
}

OutgoingConnection RemoteConnection::outgoing() const {
  Component& client = planned_.delays == nullptr ? planned_.required.owner() : *planned_.delays;
  return {.contract = planned_.required.info(),
          .terms = {.name = name(),
                    .watch = planned_.watch,
                    .ledger = ledger_,
                    .laneReason = laneReason_},
          .events = asked_,
          .client = client.sharedDoorbell(),
          .peer = session_->state(),
          .silence = longestSilence_};
}

std::size_t RemoteConnection::firstLane() const {
  if (planned_.options.lane == Lane::Auto) return 0;
  const auto asked = findLane(sessions_.lanes(), planned_.options.lane.name);
  if (asked != sessions_.lanes().end())
    return static_cast<std::size_t>(asked - sessions_.lanes().begin());
  throw laneUnknown(name(), planned_.options.lane, laneNames(sessions_.lanes()));
}

kj::Promise<void> RemoteConnection::ask(std::size_t lane) {
  return attempt(session_->lane(lane), sessions_.lanes()[lane]->name())
      .then([this, lane](kj::Maybe<std::string>&& why) -> kj::Promise<void> {
        KJ_IF_MAYBE (reason, why) {
          laneReason_ = std::move(*reason);
          return askNext(lane + 1);
        }
        return kj::READY_NOW;
      });
}

kj::Promise<void> RemoteConnection::askNext(std::size_t lane) {
  if (!planned_.options.laneRequired && lane < sessions_.lanes().size()) return ask(lane);
  if (planned_.options.laneRequired) {
    return loop::failure(Type::FAILED,
                         laneRefused(name(), planned_.options.lane, laneReason_).what());
  }
  return loop::failure(Type::FAILED, "connecting " + name() +
                                         ": no lane can carry it. The last says: " + laneReason_ +
                                         ". Remove the reason, or add a lane that can.");
}

kj::Promise<kj::Maybe<std::string>> RemoteConnection::attempt(LaneClient& lane, const char* name) {
  using Reason = kj::Maybe<std::string>;
  asked_ = planned_.required.subscribed();
  if (std::string why = lane.whyNot(outgoing()); !why.empty()) return Reason(std::move(why));
  return lane.attempt(outgoing())
      .then(
          [this, name](kj::Own<LaneAttempt>&& attempt) {
            LaneAttempt& made = *attempt;
            return request(made, name).attach(kj::mv(attempt));
          },
          [this, name](kj::Exception&& failure) -> kj::Promise<Reason> {
            if (comesBack() && mayPass(failure)) return kj::mv(failure);
            return Reason(failed(name, loop::describe(failure)));
          });
}

kj::Promise<kj::Maybe<std::string>> RemoteConnection::request(LaneAttempt& attempt,
                                                              const char* name) {
  auto request = session_->peer().connectRequest();
  fillIn(request, name);
  attempt.request(request.initBrings());
  return inTime<Results>(limit_, request.send()).then([this, &attempt, name](Results&& results) {
    return begin(attempt, name, kj::mv(results));
  });
}

void RemoteConnection::fillIn(wire::ConnectRequest::Builder request, const char* lane) {
  request.setFromProcess(codec::textOf(planned_.from.process));
  request.setFromComponent(codec::textOf(planned_.from.component));
  request.setRequired(codec::textOf(planned_.from.interface));
  request.setToComponent(codec::textOf(planned_.to.component));
  request.setProvided(codec::textOf(planned_.to.interface));
  request.setContract(planned_.required.info().name);
  request.setHash(planned_.required.info().hash);
  request.setDescription(planned_.required.info().description);
  toWire(planned_.required.frames(), request.initFrames());
  request.setEvents(toWireNumbers(planned_.required.info().wireEvents, asked_));
  request.setEpoch(toNanoseconds(now()));
  request.setSilence(longestSilence_.count());
  request.setLane(lane);
  auto news = kj::refcounted<ProviderNews>();
  request.setNotices(kj::heap<NoticesReceiver>(
      kj::addRef(*news), ledger_,
      [tell = listener_.lost, name = name()](std::string why) { tell(name, std::move(why)); }));
  news_ = kj::mv(news);
}

// The next lane is asked for, so only this tells what is wrong.
std::string RemoteConnection::failed(const char* lane, std::string why) {
  std::string& told = whyFailed_[lane];
  if (withoutNumbers(why) != withoutNumbers(told)) listener_.failed(name(), lane, why);
  told = why;
  return why;
}

kj::Promise<kj::Maybe<std::string>> RemoteConnection::begin(LaneAttempt& attempt, const char* lane,
                                                            Results&& results) {
  using Reason = kj::Maybe<std::string>;
  if (results.isRefused()) return refused(results.getRefused());
  if (results.isDeclined()) {
    std::string why = codec::stringOf(results.getDeclined());
    return Reason(results.getFailed() ? failed(lane, std::move(why)) : why);
  }
  const auto accepted = results.getAccepted();
  connection_ = accepted.getConnection();
  OutgoingConnection connection = outgoing();
  connection.rows = accepted.getRows();
  std::vector<std::uint16_t>& lacking = connection.terms.lacking;
  for (const std::uint16_t command : accepted.getLacking()) lacking.push_back(command);
  std::sort(lacking.begin(), lacking.end());
  return attempt.open(std::move(connection), accepted.getAnswer())
      .then(
          [this, lane, results = kj::mv(results)](OpenedEnd&& opened) -> Reason {
            whyFailed_.erase(lane);
            use(kj::mv(opened), results.getAccepted());
            return nullptr;
          },
          [this, lane](kj::Exception&& failure) -> Reason {
            connection_ = nullptr;
            return failed(lane, loop::describe(failure));
          });
}

void RemoteConnection::use(OpenedEnd opened, wire::ConnectResults::Accepted::Reader accepted) {
  std::shared_ptr<Channel> channel = std::move(opened.channel);
  KJ_ASSERT_NONNULL(news_)->passOnTo(kj::addRef(*opened.end));
  end_ = kj::mv(opened.end);
  if (planned_.delays != nullptr) {
    channel =
        planned_.delays->interpose(planned_.required, std::move(channel), planned_.options.delay);
  }
  ledger_->begin(channel, session_->peersIncarnation(), codec::fromWire(accepted.getEarlier()));
  listener_.made(channel);  // known before it is used
  planned_.required.attach(std::move(channel));
}

// A peer that is stopped, or behind a cable that was pulled, sends nothing, so it is asked.
void RemoteConnection::keep() {
  session_->bear(longestSilence_);
  watching_ =
      session_->watch(planned_.to.component, {.silence = longestSilence_, .hang = longestSilence_},
                      [this](std::string why) { lose(std::move(why)); });
  KJ_ASSERT_NONNULL(end_)->onBroken([this](std::string why) { lose(std::move(why)); });
}

// This runs later, since what it drops is what reports the loss.
void RemoteConnection::lose(std::string why) {
  losing_ = kj::evalLater([this, why = std::move(why)]() mutable {
              listener_.lost(name(), std::move(why));
              whyNotBack_.clear();
              drop();
              comingBack_ =
                  comeBack(fromNow(kFirstRedialPause), kFirstRedialPause, kFirstAnswerLimit)
                      .then([this] { keep(); })
                      .eagerlyEvaluate(nullptr);
            }).eagerlyEvaluate(nullptr);
}

void RemoteConnection::drop() {
  KJ_IF_MAYBE (end, end_) (*end)->close(ChannelStatus::Lost);
  end_ = nullptr;
  news_ = nullptr;
  connection_ = nullptr;
  watching_ = nullptr;
  session_ = nullptr;
}

// That the process is not there, or that the link broke, is what the loss has told already.
void RemoteConnection::tellWhyNotBack(const kj::Exception& failure) {
  if (failure.getType() == Type::DISCONNECTED) return;
  std::string why = plain(loop::describe(failure));
  if (withoutNumbers(why) == withoutNumbers(whyNotBack_)) return;
  whyNotBack_ = why;
  listener_.notBack(name(), std::move(why));
}

kj::Promise<void> RemoteConnection::comeBack(Time next, Duration pause, Duration limit) {
  return sessions_.control()
      .timer()
      .afterDelay(loop::toKj(std::max(next - now(), Duration{0})))
      .then([this, limit] { return connect(kComeBackPatience, limit); })
      .catch_([=, this](kj::Exception&& failure) {
        tellWhyNotBack(failure);
        drop();
        const Duration longer = std::min(2 * pause, kLongestRedialPause);
        return comeBack(next + longer, longer, std::min(2 * limit, kDialLimit));
      });
}

}  // namespace suture
