#include <suture/base/plain.h>
#include <suture/loop/deadline.h>
#include <suture/loop/failure.h>
#include <suture/names/listing.h>
#include <suture/names/manager_lease.h>
#include <suture/names/start_hint.h>
#include <suture/net/tls/keys.h>
#include <suture/rt/standard_error.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

using framing::Link;
using Type = kj::Exception::Type;

constexpr Duration kAnswerLimit = std::chrono::seconds(2);
constexpr Duration kRenewal = std::chrono::milliseconds(wire::RENEWAL_MILLISECONDS);
constexpr Duration kFirstPause = std::chrono::milliseconds(50);
constexpr Duration kLongestPause = std::chrono::milliseconds(250);

constexpr const char* kDoesNotAnswer =
    "does not answer: connections live on, new ones have to wait for one that does. Start it again";

}  // namespace

ManagerLease::ManagerLease(loop::ControlThread& control, const net::Address& manager,
                           std::string program, net::Trust trust, News news)
    : control_(control),
      manager_(manager),
      program_(std::move(program)),
      trust_(std::move(trust)),
      news_(std::move(news)),
      lookup_(control.port(), manager),
      here_(manager),
      trouble_(kDoesNotAnswer) {}

kj::Promise<void> ManagerLease::open() {
  auto reached = lookup_.places(kAnswerLimit).then([this](std::vector<net::Address> places) {
    return net::reachFirst(control_.port(), std::move(places), trust_, tls::kManagerName,
                           kAnswerLimit);
  });
  return reached.then([this](net::ByteStream bytes) {
    here_ = net::localAddress(manager_, bytes.socket());
    auto stream = kj::heap<framing::MessageStream>(control_.port(), kj::mv(bytes));
    auto link = kj::heap<Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT);
    auto greeted = greet(link->bootstrap<wire::GlobalManager>(), program_, manager_)
                       .then([this](wire::Session::Client session) { session_ = kj::mv(session); });
    link_ = kj::mv(link);
    return loop::within(control_.timer(), kAnswerLimit, kj::mv(greeted),
                        noManagerAnswers(manager_));
  });
}

// Rejects only if the manager refuses, which the caller must report; else it tries again.
kj::Promise<void> ManagerLease::enrol(ProcessRecord process) {
  process_ = std::move(process);
  auto enrolled = isOpen() ? enrolNow() : kj::Promise<void>(gone());
  return enrolled.then([this] { stay(kj::READY_NOW); },
                       [this](kj::Exception&& failure) {
                         if (failure.getType() == Type::FAILED)
                           kj::throwFatalException(kj::mv(failure));
                         stay(comeBack(kFirstPause));
                       });
}

void ManagerLease::stay(kj::Promise<void> enrolled) {
  keeping_ = enrolled.then([this] { return keep(); }).eagerlyEvaluate(nullptr);
}

kj::Promise<void> ManagerLease::enrolNow() {
  untold_ = false;
  auto request = KJ_REQUIRE_NONNULL(session_).registerRequest();
  toWire(process_, request.initProcess());
  auto registered = request.send().then([this](auto&& results) -> kj::Promise<void> {
    if (results.isRefused()) return refused(results.getRefused());
    process_.generation = results.getGeneration();
    lease_ = results.getLease();
    setTrouble("");
    if (untold_) update(std::vector(process_.components));
    return kj::READY_NOW;
  });
  return loop::within(control_.timer(), kAnswerLimit, kj::mv(registered),
                      "register at " + manager_.text() + ": no answer. Restart the manager.");
}

kj::Promise<void> ManagerLease::keep() {
  return KJ_REQUIRE_NONNULL(link_)
      ->onDisconnect()
      .then([this] { setTrouble(kDoesNotAnswer); })
      .exclusiveJoin(renew())
      .then([this] { return comeBack(kFirstPause); })
      .then([this] { return keep(); });
}

// Ends when the manager does not answer, since it is stopped or a cable was pulled, or when it has
// not heard of this process for as long, and may have given its name to another.
kj::Promise<void> ManagerLease::renew() {
  auto held = KJ_REQUIRE_NONNULL(lease_).renewRequest().send().then(
      [](auto&& results) { return results.getHeld(); },
      [](kj::Exception&&) { return true; });  // a broken link ends by itself
  const auto onLate = [this] {
    setTrouble(kDoesNotAnswer);
    return false;
  };
  return loop::unlessLate(control_.timer(), kAnswerLimit, kj::mv(held), onLate)
      .then([this](bool goesOn) -> kj::Promise<void> {
        if (!goesOn) return kj::READY_NOW;
        return control_.timer().afterDelay(loop::toKj(kRenewal)).then([this] { return renew(); });
      });
}

kj::Promise<void> ManagerLease::comeBack(Duration pause) {
  drop();
  return control_.timer()
      .afterDelay(loop::toKj(pause))
      .then([this] { return open(); })
      .then([this] { return enrolNow(); })
      .catch_([this, pause](kj::Exception&& failure) {
        const bool refused = failure.getType() == Type::FAILED;
        setTrouble(refused ? "cannot be used: " + loop::describe(failure) : kDoesNotAnswer);
        return comeBack(std::min(2 * pause, kLongestPause));
      });
}

// The name is free for the next attempt as soon as the manager has seen the end of this one.
void ManagerLease::drop() {
  lease_ = nullptr;
  session_ = nullptr;
  link_ = nullptr;
}

std::string ManagerLease::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

void ManagerLease::setTrouble(const std::string& trouble) {
  {
    const std::lock_guard lock(mutex_);
    if (trouble_ == trouble) return;
    trouble_ = trouble;
  }
  const bool wasTold = std::exchange(told_, !trouble.empty());
  if (wasTold || told_) news_(manager_, trouble);
}

void ManagerLease::update(std::vector<ComponentRecord> components) {
  process_.components = std::move(components);
  untold_ = lease_ == nullptr;  // a registration under way has told of the earlier ones
  KJ_IF_MAYBE (lease, lease_) {
    auto request = lease->updateRequest();
    toWire(process_.components,
           request.initComponents(static_cast<unsigned>(process_.components.size())));
    // If the link breaks, the next enrolment tells the manager everything again.
    control_.spawn(request.send().ignoreResult().catch_([program = program_](kj::Exception&& e) {
      if (e.getType() != Type::FAILED) return;
      rt::printUnlessFull(program + ": " + plain(loop::describe(e)));
    }));
  }
}

kj::Promise<ProcessRecord> ManagerLease::resolve(const std::string& process, Duration wait) {
  KJ_IF_MAYBE (session, session_) {
    auto request = session->resolveRequest();
    request.setProcess(codec::textOf(process));
    const Duration bounded = std::clamp(wait, Duration{0}, kLongestWait);
    request.setWaitMilliseconds(
        static_cast<std::uint32_t>(std::chrono::ceil<std::chrono::milliseconds>(bounded).count()));
    return request.send().then([](auto&& results) -> kj::Promise<ProcessRecord> {
      if (results.isRefused()) return refused(results.getRefused());
      return fromWire(results.getFound());
    });
  }
  return gone();
}

kj::Promise<std::vector<ProcessRecord>> ManagerLease::list() {
  KJ_IF_MAYBE (session, session_) {
    return listAll(*session);
  }
  return gone();
}

kj::Exception ManagerLease::gone() const {
  return loop::disconnected("the global manager at " + manager_.text() + " is gone");
}

}  // namespace suture
