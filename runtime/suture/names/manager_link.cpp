#include <suture/loop/deadline.h>
#include <suture/names/manager_link.h>
#include <suture/names/peer_address.h>
#include <suture/names/start_hint.h>

#include <algorithm>
#include <optional>

namespace suture {
namespace {

using Type = kj::Exception::Type;

// Two attempts are this far apart while no manager answers.
constexpr Duration kPause = std::chrono::milliseconds(50);

}  // namespace

/// Holds the failures of several attempts, in their order.
struct ManagerLink::Failures {
  explicit Failures(std::size_t attempts) : all(attempts) {}

  bool complete() const {
    return std::all_of(all.begin(), all.end(), [](const auto& one) { return one.has_value(); });
  }
  /// Once complete: returns the first of that type, or null.
  const kj::Exception* first(Type type) const {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const auto& one) { return one->getType() == type; });
    return found == all.end() ? nullptr : &**found;
  }

  std::vector<std::optional<kj::Exception>> all;
};

ManagerLink::ManagerLink(loop::ControlThread& control, const std::vector<net::Address>& managers,
                         const std::string& program, const net::Trust& trust,
                         const ManagerLease::News& news)
    : control_(control), trust_(trust) {
  for (const net::Address& manager : managers) {
    leases_.push_back(std::make_unique<ManagerLease>(control, manager, program, trust, news));
  }
}

ManagerLease& ManagerLink::nearest() const {
  const auto open = std::find_if(leases_.begin(), leases_.end(),
                                 [](const auto& lease) { return lease->isOpen(); });
  return open == leases_.end() ? *leases_.front() : **open;
}

// Awaits the slow ones too, because a process whose name is taken at one of them must be told.
kj::Promise<void> ManagerLink::open(Duration patience) {
  const Time deadline = fromNow(patience);
  auto failures = std::make_shared<Failures>(leases_.size());
  kj::Vector<kj::Promise<void>> attempts;
  for (std::size_t i = 0; i < leases_.size(); ++i) {
    attempts.add(leases_[i]->open().catch_(
        [failures, i](kj::Exception&& failure) { failures->all[i].emplace(kj::mv(failure)); }));
  }
  return kj::joinPromises(attempts.releaseAsArray())
      .then([this, deadline, failures]() -> kj::Promise<void> {
        if (!failures->complete()) return kj::READY_NOW;
        const Duration left = deadline - now();
        // One that accepts a link and does not answer is stopped, perhaps for a moment only.
        const bool mayHelp = failures->first(Type::DISCONNECTED) != nullptr ||
                             failures->first(Type::OVERLOADED) != nullptr;
        if (!mayHelp || left <= Duration{0}) return notOpen(*failures);
        return control_.timer()
            .afterDelay(loop::toKj(std::min(left, kPause)))
            .then([this, deadline] { return open(deadline - now()); });
      });
}

kj::Exception ManagerLink::notOpen(const Failures& failures) const {
  const kj::Exception& first = *failures.all.front();
  if (first.getType() != Type::DISCONNECTED) return kj::cp(first);
  const net::Address& address = leases_.front()->address();
  std::string text =
      "reach the global manager: " + loop::describe(first) + " " + howToStartManager(address);
  if (leases_.size() > 1) text += ". None of " + missing() + " answers";
  return loop::failure(Type::FAILED, text);
}

kj::Promise<void> ManagerLink::enrol(const ProcessRecord& process) {
  return enrolFrom(leases_.begin(), process).then([this] {
    const bool enrolled = std::any_of(leases_.begin(), leases_.end(),
                                      [](const auto& lease) { return lease->trouble().empty(); });
    if (!enrolled) kj::throwFatalException(gone("register this process"));
  });
}

// Registers at one after the other, so that of two processes with one name all refuse the same.
kj::Promise<void> ManagerLink::enrolFrom(Leases::const_iterator first,
                                         const ProcessRecord& process) {
  if (first == leases_.end()) return kj::READY_NOW;
  return (*first)->enrol(process).then(
      [this, first, process] { return enrolFrom(first + 1, process); });
}

void ManagerLink::update(const std::vector<ComponentRecord>& components) {
  for (const auto& lease : leases_) lease->update(components);
}

// A manager lets a question wait for so long only, and is asked again by who has more patience.
kj::Promise<ProcessRecord> ManagerLink::resolve(const std::string& process, Duration wait) {
  const Time deadline = fromNow(wait),
             answered = fromNow(std::min(wait, ManagerLease::kLongestWait));
  return askAll(process, wait)
      .catch_([=, this](kj::Exception&& failure) -> kj::Promise<ProcessRecord> {
        const Duration left = deadline - now();
        if (failure.getType() != Type::DISCONNECTED) {
          const bool mayAskAgain = now() >= answered && left > Duration{0};
          if (!mayAskAgain) return kj::mv(failure);
          return resolve(process, left);
        }
        if (left <= Duration{0}) return gone("find process '" + process + "'");
        return control_.timer()
            .afterDelay(loop::toKj(std::min(left, kPause)))
            .then([this, process, deadline] { return resolve(process, deadline - now()); });
      });
}

// Resolves to the first that is found; else rejects with the answer of a manager that could be
// asked.
kj::Promise<ProcessRecord> ManagerLink::askAll(const std::string& process, Duration wait) {
  auto failures = std::make_shared<Failures>(leases_.size());
  kj::Promise<ProcessRecord> first = kj::NEVER_DONE;
  for (std::size_t i = 0; i < leases_.size(); ++i) {
    first = first.exclusiveJoin(
        leases_[i]
            ->resolve(process, wait)
            .catch_([failures, i](kj::Exception&& failure) -> kj::Promise<ProcessRecord> {
              failures->all[i].emplace(kj::mv(failure));
              if (!failures->complete()) return kj::NEVER_DONE;
              const kj::Exception* const refusal = failures->first(Type::FAILED);
              return kj::cp(refusal != nullptr ? *refusal : *failures->all.front());
            }));
  }
  return first;
}

kj::Promise<net::ByteStream> ManagerLink::reach(const ProcessRecord& process, Duration limit) {
  try {
    const net::Address address = addressOf(process, nearest().address());  // all are of one kind
    return net::reach(control_.port(), address, trust_, process.name, limit);
  } catch (const SetupError& error) {
    return loop::failure(Type::FAILED, error.what());
  }
}

kj::Promise<std::vector<ProcessRecord>> ManagerLink::list() {
  if (!nearest().isOpen()) return gone("list processes");
  return nearest().list();
}

std::string ManagerLink::missing() const {
  std::string text;
  for (const auto& lease : leases_) {
    if (lease->trouble().empty()) continue;
    text += (text.empty() ? "" : ",") + lease->address().text();
  }
  return text;
}

std::map<std::string, std::string> ManagerLink::troubles() const {
  std::map<std::string, std::string> all;
  for (const auto& lease : leases_) all[lease->address().text()] = lease->trouble();
  std::erase_if(all, [](const auto& one) { return one.second.empty(); });
  return all;
}

kj::Exception ManagerLink::gone(const std::string& asked) const {
  return loop::disconnected(asked + ": the global manager at " + missing() +
                            " is gone. Start it again.");
}

}  // namespace suture
