#include "cli/peer/provider.h"
#include <suture/base/errors.h>
#include <suture/codec/json/annotations.h>
#include <suture/framing/remote_error.h>
#include "cli/contract/from_json.h"
#include "cli/contract/limits.h"
#include "cli/peer/lookup.h"
#include "cli/peer/wait.h"

namespace suture::cli {
namespace {

std::string remedyFor(Errc error, const Target& target) {
  const std::string component = target.process + ":" + target.component + "/component";
  switch (error) {
    case Errc::Faulted:
      return "`suture watch " + component + " state_changed --count 1` tells what became of it";
    case Errc::Suspended: return "`suture read " + component + " component_state` tells how it is";
    case Errc::Full: return "Send less, or again when it has taken some";
    case Errc::OutcomeUnknown: return "`suture doctor " + target.toString() + "` looks for it";
    case Errc::TooLarge:
    case Errc::Invalid:
    case Errc::NotImplemented:
      return "`suture describe " + target.toString() + "` tells what it takes and answers";
    default: return std::string("`suture why \"") + toString(error) + "\"` explains it";
  }
}

class Receiver final : public capnp::DynamicCapability::Server {
 public:
  Receiver(std::shared_ptr<const Contract> contract, codec::Labels labels, Provider::Heard heard)
      : Server(contract->eventsInterface()),
        contract_(std::move(contract)),
        labels_(labels),
        heard_(std::move(heard)) {}

  kj::Promise<void> call(
      capnp::InterfaceSchema::Method method,
      capnp::CallContext<capnp::DynamicStruct, capnp::DynamicStruct> context) override {
    for (const Member& event : contract_->events()) {
      if (event.method != method) continue;
      heard_(event, codec::payloadToJson(context.getParams(), labels_));
    }
    return kj::READY_NOW;
  }

 private:
  const std::shared_ptr<const Contract> contract_;
  const codec::Labels labels_;
  const Provider::Heard heard_;
};

}  // namespace

Provider::Provider(loop::EventPort& loop, const Options& options, const Target& target)
    : loop_(loop),
      options_(options),
      patience_(options.patience),
      process_(target.process),
      component_(target.component),
      peer_(meet(loop, options, target.process)),
      contract_(peer_.explain(target, wire::Peer::Side::PROVIDED)),
      capability_(peer_.open(target, *contract_)) {}

Answer Provider::call(const Member& command, const Json& arguments, codec::Labels labels) {
  try {
    return wait(loop_, start(command, arguments, labels));
  } catch (const SetupError&) {
    const std::string why = refusal_ == Errc::Faulted ? whyFaulted() : "";
    if (why.empty()) throw;
    throw SetupError(
        "call " + command.name + " of " + contract_->title(),
        std::string(toString(refusal_)) + "; component '" + component_ + "' is faulted: " + why,
        "Correct the cause, and start process '" + process_ + "' anew");
  }
}

// Returns "" if the component has been restarted meanwhile, or does not say why.
std::string Provider::whyFaulted() const {
  try {
    Provider life(loop_, options_, {process_, component_, "component"});
    auto heard = kj::newPromiseAndFulfiller<std::string>();
    const Member* const changed = life.contract().findEvent("state_changed");
    if (changed == nullptr) return "";
    wait(loop_, life.subscribe(life.contract().bitOf(*changed), codec::Labels::Names,
                               [&](const Member&, const Json& change) {
                                 heard.fulfiller->fulfill(textAt(change, "fault"));
                               }));
    return wait(loop_, patience_, kj::mv(heard.promise), "it does not say why");
  } catch (const SetupError&) {
    return "";
  }
}

kj::Promise<Answer> Provider::start(const Member& command, const Json& arguments,
                                    codec::Labels labels) {
  auto request = capability_.newRequest(command.method);
  fill(request, arguments, "");
  for (const auto field : request.getSchema().getFields()) {
    if (codec::isSent(field)) request.init(field).as<capnp::DynamicStruct>().set("answer", true);
  }
  const std::string title = "call " + command.name + " of " + contract_->title();
  const Target target = Target::parse(contract_->title());
  auto answer = request.send().then(
      [this, labels](auto&& results) -> kj::Promise<Answer> {
        return Answer{codec::payloadToJson(results, labels), ageIn(results),
                      peer_.clock().error(now())};
      },
      [this, title, target, arguments, &command](kj::Exception&& failure) -> kj::Promise<Answer> {
        const Errc error = framing::errcOf(failure);
        refusal_ = error;
        const std::string beyond = beyondLimit(*contract_, command, arguments, error);
        const std::string found =
            framing::reasonOf(failure) + (beyond.empty() ? "" : "; " + beyond);
        return loop::failure(kj::Exception::Type::FAILED,
                             SetupError(title, found, remedyFor(error, target)).what());
      });
  return loop::within(loop_.getTimer(), patience_, kj::mv(answer),
                      title + ": no answer in time; whether it ran is not known. `suture doctor " +
                          contract_->title() + "` looks for the reason.");
}

std::optional<Duration> Provider::ageIn(capnp::DynamicStruct::Reader results) const {
  KJ_IF_MAYBE (stamp, results.getSchema().findFieldByName("stamp")) {
    return now() - peer_.here(results.get(*stamp).as<std::int64_t>());
  }
  return std::nullopt;
}

kj::Promise<void> Provider::subscribe(std::uint64_t events, codec::Labels labels, Heard heard) {
  auto request = capability_.newRequest("subscribe");
  request.set("events", capnp::DynamicCapability::Client(
                            kj::heap<Receiver>(contract_, labels, std::move(heard))));
  request.set("eventMask", events);
  return loop::within(
      loop_.getTimer(), patience_, request.send().ignoreResult(),
      "subscribe to events of " + contract_->title() + ": no answer. Look at what it is doing.");
}

void Provider::awaitCycleEnd() {
  const Time latest = now() + patience_;
  const Cycle answered = peer_.cycleOf(component_);
  for (Cycle seen = answered; seen.running && seen.cycles == answered.cycles && now() < latest;) {
    wait(loop_, loop_.getTimer().afterDelay(1 * kj::MILLISECONDS));
    seen = peer_.cycleOf(component_);
  }
}

kj::Promise<void> Provider::whenGone() {
  return peer_.onDisconnect().then([this]() -> kj::Promise<void> {
    return loop::disconnected("watch " + contract_->title() + ": process '" + peer_.process().name +
                              "' is gone. Start it again.");
  });
}

}  // namespace suture::cli
