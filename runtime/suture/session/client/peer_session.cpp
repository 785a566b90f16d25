#include <suture/framing/preamble.h>
#include <suture/loop/deadline.h>
#include <suture/net/socket.h>
#include <suture/session/boot_id.h>
#include <suture/session/client/peer_session.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace suture {
namespace {

// The best of so many answers counts. Over a long way fewer are awaited, because what they differ
// by is little beside the time that each takes, and the heartbeat asks on.
constexpr unsigned kClockQuestions = 8;
constexpr Duration kClockTime = std::chrono::milliseconds(100);

}  // namespace

PeerSession::PeerSession(loop::ControlThread& control, ManagerLink& manager, const Lanes& lanes,
                         ProcessRecord process, net::ByteStream bytes)
    : control_(control),
      manager_(manager),
      process_(std::move(process)),
      socket_(bytes.socket()),
      carriesDescriptors_(bytes.carriesDescriptors()),
      link_(kj::heap<framing::MessageStream>(control.port(), kj::mv(bytes)),
            capnp::rpc::twoparty::Side::CLIENT),
      peer_(link_.bootstrap<wire::Peer>()),
      heartbeat_(control.timer(), peer_),
      ending_(link_.onDisconnect()
                  .then([this] {
                    closed_ = true;
                    heartbeat_.end("closed: its process has ended, or the link is broken");
                  })
                  .eagerlyEvaluate(nullptr)) {
  for (const auto& kind : lanes) lanes_.push_back(kind->makeClient(*this));
}

PeerSession::~PeerSession() noexcept(false) = default;

kj::Promise<void> PeerSession::greet(const SessionIdentity& self) {
  auto request = peer_.helloRequest();
  request.setVersion(wire::PROTOCOL_VERSION);
  request.setProcess(codec::textOf(self.process));
  request.setBootId(codec::textOf(bootId()));
  request.setIncarnation(self.incarnation);
  const Time asked = now();
  return request.send().then([this, asked](auto&& results) -> kj::Promise<void> {
    if (results.isRefused()) return refused(results.getRefused());
    peersIncarnation_ = results.getIncarnation();
    heartbeat_.noteRoundTrip(now() - asked);
    if (codec::stringOf(results.getBootId()) == bootId()) {
      clock_ = ClockOffset::none();
      return kj::READY_NOW;
    }
    clock_.add(asked, results.getReceived(), results.getSent(), now());
    heartbeat_.onAnswer([this](Time when, auto answer) { follow(when, answer); });
    return kj::READY_NOW;
  });
}

kj::Promise<void> PeerSession::compareClocks() {
  if (clock_.isOne()) return kj::READY_NOW;
  return askForClock(now(), kClockQuestions);
}

kj::Promise<void> PeerSession::askForClock(Time begun, unsigned times) {
  if (times == 0 || now() - begun >= kClockTime) {
    noteClock();
    tellClock();
    return kj::READY_NOW;
  }
  const Time asked = now();
  return peer_.pingRequest().send().then([=, this](auto&& told) {
    clock_.add(asked, told.getReceived(), told.getSent(), now());
    return askForClock(begun, times - 1);
  });
}

// Clocks drift apart, so the peer is told when the estimate has become better, or much worse.
void PeerSession::follow(Time asked, wire::Peer::PingResults::Reader answer) {
  const bool better = clock_.add(asked, answer.getReceived(), answer.getSent(), now());
  noteClock();
  if (better || clock_.error(now()) >= toldError_ + toldError_ / 2) tellClock();
}

void PeerSession::noteClock() {
  state_->clockShift.store(-clock_.offset(), std::memory_order_relaxed);
  state_->clockError.store(clock_.error(now()), std::memory_order_relaxed);
}

void PeerSession::tellClock() {
  toldError_ = clock_.error(now());
  auto request = peer_.comparedRequest();
  request.setClockOffset(-clock_.offset().count());
  request.setClockError(toldError_.count());
  // Ignore a failure: other code learns of a broken link.
  telling_ = request.send().ignoreResult().eagerlyEvaluate([](kj::Exception&&) {});
}

void PeerSession::bear(Duration silence) {
  if (silence <= longest_) return;
  longest_ = silence;
  net::breakWhenUnanswered(socket_, silence);
  for (auto& lane : lanes_) lane->bear(silence);
}

template <class T>
kj::Promise<T> PeerSession::inTime(kj::Promise<T> step) {
  return loop::within(control_.timer(), kDialLimit, kj::mv(step),
                      "the provider gives no second connection in time");
}

kj::Promise<LaneSocket> PeerSession::openSocket(const char* lane) {
  auto request = peer_.socketRequest();
  request.setLane(lane);
  using Results = capnp::Response<wire::Peer::SocketResults>;
  return inTime<Results>(request.send()).then([this](Results&& results) -> kj::Promise<LaneSocket> {
    framing::Token token;
    const auto told = results.getToken();
    if (told.size() != token.size()) {
      return loop::failure(kj::Exception::Type::FAILED, "the token has an impossible size");
    }
    std::memcpy(token.data(), told.begin(), token.size());
    return manager_.reach(process_, kDialLimit)
        .then([this, token](net::ByteStream bytes) {
          return inTime(framing::exchangeToken(control_.port(), kj::mv(bytes), token));
        })
        .then([number = results.getNumber()](net::ByteStream bytes) {
          return LaneSocket{number, kj::mv(bytes)};
        });
  });
}

}  // namespace suture
