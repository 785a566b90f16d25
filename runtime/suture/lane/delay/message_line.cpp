#include <suture/lane/delay/message_line.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace suture {
namespace {

// Marks have their own faults, since their time must not decide those of messages, and a test does
// not count them.
constexpr std::uint64_t kOfMarks = 0x100;

FaultPlan uncounted(FaultPlan plan) {
  plan.counts = nullptr;
  return plan;
}

DelayLine::Order orderOf(const Fate& fate) {
  return fate.overtakable ? DelayLine::Order::Overtakable : DelayLine::Order::Kept;
}

}  // namespace

MessageLine::MessageLine(std::size_t largest, std::size_t records, const FaultPlan& plan,
                         std::uint64_t stream, DeliveryCounters& counters)
    : line_(sizeof(Header) + largest, records),
      faults_(plan, stream),
      markFaults_(uncounted(plan), stream | kOfMarks),
      check_(counters) {}

std::byte* MessageLine::claim(Time due, std::size_t size) {
  if (!hasRoom()) return nullptr;
  return claim(due, size, {.sequence = ++sent_, .mark = false}, faults_.next());
}

std::byte* MessageLine::claimMark(Time due, std::size_t size, std::uint64_t sequence) {
  if (!hasRoom()) return nullptr;
  const Fate fate = markFaults_.next();
  const Fate applied{.lost = fate.lost, .duplicated = fate.duplicated};  // a mark never overtakes
  return claim(due, size, {.sequence = sequence, .mark = true}, applied);
}

std::byte* MessageLine::claim(Time due, std::size_t size, const Header& header, const Fate& fate) {
  fate_ = fate;
  claimedSize_ = sizeof(Header) + size;
  claimed_ = line_.claim(std::max(due, now()) + fate.later, claimedSize_, orderOf(fate));
  new (claimed_) Header(header);
  return claimed_ + sizeof(Header);
}

void MessageLine::commit() {
  if (fate_.lost) return;
  line_.commit();
  if (fate_.duplicated) duplicate();
  if (fate_.stall > Duration{0}) stalledUntil_ = std::max(stalledUntil_, now() + fate_.stall);
}

// The duplicate is due later than the message itself. So it comes later than all that the message
// waits behind, too.
void MessageLine::duplicate() {
  std::byte* const again = line_.claim(line_.claimedDue() + fate_.duplicateLater, claimedSize_,
                                       DelayLine::Order::Overtakable);
  std::memcpy(again, claimed_, claimedSize_);
  line_.commit();
}

const std::byte* MessageLine::due(Time now) {
  if (now < stalledUntil_) return nullptr;
  while (const std::byte* const memory = line_.due(now)) {
    const auto& header = *reinterpret_cast<const Header*>(memory);
    mark_ = header.mark;
    if (mark_) check_.passOver(header.sequence);
    if (mark_ || check_.accepts(header.sequence)) return memory + sizeof(Header);
    line_.pop();
  }
  return nullptr;
}

std::size_t MessageLine::size() const { return line_.size() - sizeof(Header); }

Time MessageLine::next() const { return std::max(line_.next(), stalledUntil_); }

}  // namespace suture
