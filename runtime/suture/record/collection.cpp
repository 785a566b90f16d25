#include <suture/base/errors.h>
#include <suture/base/nearest.h>
#include <suture/record/collection.h>
#include <suture/rt/counter.h>

#include <algorithm>

namespace suture {
namespace {

template <class Member, class Eligible>
std::vector<std::uint16_t> numbersOf(const char* contract, const char* kind,
                                     std::span<const Member> members,
                                     const std::vector<std::string>& names,
                                     const Eligible& eligible) {
  std::vector<std::uint16_t> numbers;
  std::vector<std::string> known;
  for (std::uint16_t i = 0; i < members.size(); ++i) {
    if (!eligible(members[i])) continue;
    known.emplace_back(members[i].name);
    if (names.empty() || std::find(names.begin(), names.end(), known.back()) != names.end()) {
      numbers.push_back(i);
    }
  }
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw SetupError(std::string("collecting ") + kind + " '" + name + "'",
                     std::string(contract) + " has " + listNames(known),
                     remedyForName(name, known));
  }
  return numbers;
}

}  // namespace

Collection::Collection(const CollectingInterval& interval, bool on) : wanted_(on) {
  if (setInterval(interval)) return;
  throw SetupError("a collector",
                   "it is to keep every " + std::to_string(interval.every) + "th, at least " +
                       std::to_string(interval.atLeast.count()) + " ns apart",
                   "Keep every one (1) or every n-th, with no negative time between");
}

bool Collection::setInterval(const CollectingInterval& interval) {
  if (interval.every == 0 || interval.atLeast < Duration{0}) return false;
  interval_ = interval;
  untilNext_ = 0;
  return true;
}

CollectedCounts Collection::counts() const {
  return {.collected = collected_.load(std::memory_order_relaxed),
          .passedOver = passedOver_.load(std::memory_order_relaxed),
          .missed = missed_.load(std::memory_order_relaxed)};
}

void Collection::setActive(bool active) {
  if (active) {
    for (auto* counter : {&collected_, &passedOver_, &missed_}) counter->store(0);
    untilNext_ = 0;
    last_ = Time{};
  }
  active_.store(active, std::memory_order_release);
}

bool Collection::keep(Time stamp) {
  const bool due = untilNext_ == 0;
  untilNext_ = due ? interval_.every - 1 : untilNext_ - 1;
  if (!due || (last_ != Time{} && stamp - last_ < interval_.atLeast)) {
    rt::increment(passedOver_);
    return false;
  }
  last_ = stamp;
  rt::increment(collected_);
  return true;
}

void Collection::countMissed(std::uint64_t count) { rt::increment(missed_, count); }

void Collection::settle(Sink& sink, const CollectedInterface& from, std::uint64_t& unreported) {
  try {
    sink.settle(from);
  } catch (const NotKept& why) {
    countNotKept(why.collected());
    unreported += why.collected() + why.missed();
    throw;
  }
}

// It may be told of what it has lost after a new count has begun.
void Collection::countNotKept(std::uint64_t count) {
  const std::uint64_t collected = collected_.load(std::memory_order_relaxed);
  const std::uint64_t counted = std::min(count, collected);
  collected_.store(collected - counted, std::memory_order_relaxed);
  rt::increment(missed_, counted);
}

std::vector<std::uint16_t> readsOf(const InterfaceInfo& contract,
                                   const std::vector<std::string>& names) {
  return numbersOf(contract.name, "the read", contract.commands, names,
                   [](const CommandInfo& command) { return command.kind == CommandKind::Read; });
}

std::vector<std::uint16_t> eventsOf(const InterfaceInfo& contract,
                                    const std::vector<std::string>& names) {
  return numbersOf(contract.name, "the event", contract.events, names,
                   [](const EventInfo&) { return true; });
}

}  // namespace suture
