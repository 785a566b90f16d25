#include <suture/codec/tallies.h>
#include <suture/loop/failure.h>
#include <suture/rt/state/state_table.h>
#include <suture/session/provider/acceptance.h>
#include <suture/session/provider/connections/notices_sender.h>
#include <suture/wiring/frames.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

using Kind = wire::Refusal::Kind;

// Bounds what a client may say, so that sums with it do not overflow.
Duration silenceIn(wire::ConnectRequest::Reader request) {
  constexpr Duration kLongest = std::chrono::hours(24 * 365);
  return std::clamp(Duration(request.getSilence()), Duration{0}, kLongest);
}

/// Ends the connection when the client drops it.
class ConnectionServer final : public wire::Connection::Server {
 public:
  explicit ConnectionServer(kj::Own<ProviderEnd> end) : end_(kj::mv(end)) {}
  ~ConnectionServer() noexcept(false) { end_->close(); }

 private:
  kj::Own<ProviderEnd> end_;
};

}  // namespace

Acceptance::Acceptance(ServedPeer& peer, HeldConnections& held, LaneServers& lanes, Context context)
    : peer_(peer),
      held_(held),
      lanes_(lanes),
      context_(context),
      asked_(context_.getParams()),
      endpoint_(peer.endpoint(asked_.getToComponent(), asked_.getProvided())) {}

kj::Promise<void> Acceptance::answer() {
  return peer_.serve(context_, whyWithheld(), [this] { return decide(); });
}

std::optional<Refusal> Acceptance::whyWithheld() {
  const Admission& admission = peer_.admission();
  auto withheld = admission.whyNotNames(
      {asked_.getFromProcess(), asked_.getFromComponent(), asked_.getRequired(),
       asked_.getToComponent(), asked_.getProvided(), asked_.getContract(), asked_.getHash()});
  if (!withheld) withheld = admission.whyNotProcess(codec::stringOf(asked_.getFromProcess()));
  if (!withheld) withheld = held_.whyNoPlace(endpoint_, room_);
  if (!withheld) withheld = admission.whyNotInterface(endpoint_);
  return withheld;
}

kj::Promise<void> Acceptance::decide() {
  ProvidedBase& provided = peer_.shared().directory.provided(endpoint_);
  try {
    compare(provided);
    if (!mayTakeOver()) return kj::READY_NOW;
    connection_.emplace(incoming(provided));
    return accept();
  } catch (const SetupError& error) {
    peer_.refuse({Kind::CONTRACT_MISMATCH, error.what()}, context_.getResults().initRefused());
    return kj::READY_NOW;
  }
}

void Acceptance::compare(ProvidedBase& provided) {
  const Endpoint client{codec::stringOf(asked_.getFromProcess()),
                        codec::stringOf(asked_.getFromComponent()),
                        codec::stringOf(asked_.getRequired())};
  name_ = connectionName(client, endpoint_);
  client_ = peer_.admission().proven(client.toString());
  const std::string contract = codec::stringOf(asked_.getContract()),
                    hash = codec::stringOf(asked_.getHash()),
                    description = codec::stringOf(asked_.getDescription());
  match_ =
      requireCompatibleContract(describedInfo(contract, hash, description), provided.info(), name_);
  requireSameFrames(fromWire(asked_.getFrames()), provided.frames(), name_);
}

// One required interface has one connection, the latest, unless its client numbers none.
bool Acceptance::mayTakeOver() {
  if (asked_.getEpoch() == 0) return true;
  const std::string why = peer_.shared().latest.whySuperseded(client_, name_, latest(nullptr));
  if (why.empty()) return true;
  peer_.refuse({Kind::ALREADY_CONNECTED, why}, context_.getResults().initRefused());
  return false;
}

IncomingConnection Acceptance::incoming(ProvidedBase& provided) const {
  SharedBySessions& shared = peer_.shared();
  return {.provided = provided,
          .contract = *match_.contract,
          .terms = {.name = name_,
                    .ledger = shared.ledgers.of(peer_.name(), name_, peer_.greeting().incarnation)},
          .events = fromWireNumbers(match_.contract->wireEvents, asked_.getEvents()),
          .provider = shared.threads.serverOf(provided),
          .readOnly = peer_.admission().mayOnlyRead(endpoint_),
          .peer = peer_.state(),
          .silence = silenceIn(asked_)};
}

kj::Promise<void> Acceptance::accept() {
  return lanes_.named(codec::stringOf(asked_.getLane()))
      .then([this](LaneServer* lane) { return make(*lane); })
      .then(
          [this](kj::Maybe<AcceptedEnd>&& made) {
            KJ_IF_MAYBE (end, made) accepted(kj::mv(*end));
          },
          [this](kj::Exception&& why) { decline(why); });
}

kj::Promise<kj::Maybe<AcceptedEnd>> Acceptance::make(LaneServer& lane) {
  if (const auto refusal = held_.whyNoMemory(endpoint_, room_, lane.bytesFor(*connection_))) {
    peer_.refuse(*refusal, context_.getResults().initRefused());
    return kj::Maybe<AcceptedEnd>();
  }
  auto answer = context_.getResults().initAccepted().initAnswer();
  return lane.accept(*connection_, asked_.getBrings(), answer).then([](AcceptedEnd&& end) {
    return kj::Maybe<AcceptedEnd>(kj::mv(end));
  });
}

// Another attempt of the same interface may have come while the lane was getting ready. Stores the
// end before it becomes the latest, because what the caller sent may be invalid and throw.
void Acceptance::accepted(AcceptedEnd made) {
  SharedBySessions& shared = peer_.shared();
  ProviderEnd& end = *made.end;
  if (!mayTakeOver()) return end.close();
  const bool counts = asked_.getEpoch() != 0;
  if (counts) shared.latest.end(client_);
  const std::shared_ptr<Ledger>& ledger = made.channel->terms.ledger;
  const std::uint64_t incarnation = peer_.greeting().incarnation;
  shared.ledgers.keep(peer_.name(), name_, incarnation, ledger);
  ledger->begin(made.channel, incarnation);
  end.setListener(kj::heap<NoticesSender>(shared.control, asked_.getNotices()));
  held_.keep(kj::addRef(end), made.channel, room_);
  if (counts) shared.latest.set(client_, latest(&end));
  auto out = context_.getResults().getAccepted();
  out.setLacking(kj::arrayPtr(match_.lacking.data(), match_.lacking.size()));
  out.setRows(static_cast<std::uint32_t>(connection_->provided.state()->capacity()));
  codec::toWire(end.earlier(), out.initEarlier());
  out.setConnection(kj::heap<ConnectionServer>(kj::addRef(end)));
  shared.channels.attach(connection_->provided, std::move(made.channel));
}

void Acceptance::decline(const kj::Exception& why) {
  const std::string text = loop::describe(why);
  context_.getResults().setDeclined(codec::textOf(text));
  if (why.getType() != kj::Exception::Type::OVERLOADED) return;
  context_.getResults().setFailed(true);
  peer_.note("use '" + endpoint_.toString() + "' by lane '" + codec::stringOf(asked_.getLane()) +
             "': " + text);
}

LatestConnections::Latest Acceptance::latest(ProviderEnd* end) const {
  const ServedPeer::Greeting& greeting = peer_.greeting();
  return {.bootId = greeting.bootId,
          .epoch = asked_.getEpoch(),
          .incarnation = greeting.incarnation,
          .greeting = greeting.number,
          .end = end};
}

}  // namespace suture
