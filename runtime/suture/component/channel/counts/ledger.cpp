#include <suture/component/channel/channel.h>
#include <suture/component/channel/counts/ledger.h>
#include <suture/rt/counter.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

std::uint64_t withoutDebt(std::uint64_t count, std::uint64_t others) {
  return count - std::min(count, others);
}

Tally larger(const Tally& one, const Tally& other) {
  return combined(one, other, [](std::uint64_t a, std::uint64_t b) { return std::max(a, b); });
}

}  // namespace

// What has been heard may be older than what was sent, but it is never newer.
std::uint64_t Ledger::Group::open() const {
  return withoutDebt(accepted, own.commands() + heard.commands() + lost);
}

Ledger::Group Ledger::Group::operator+(const Group& other) const {
  Group sum;
  sum.accepted = accepted + other.accepted;
  sum.lost = lost + other.lost;
  sum.eventsDelivered = eventsDelivered + other.eventsDelivered;
  sum.turnedDown = {turnedDown.full + other.turnedDown.full,
                    turnedDown.tooLarge + other.turnedDown.tooLarge,
                    turnedDown.invalid + other.turnedDown.invalid};
  sum.own = own + other.own;
  sum.heard = heard + other.heard;
  return sum;
}

// At the provider's end the lane is the sender, and what it puts in has been accepted.
Ledger::Group Ledger::groupOf(const Entry& entry) const {
  if (entry.counts == nullptr) return entry.last;
  const ChannelCounts& counts = *entry.counts;
  const rt::MailboxCounters& commands = *counts.commands;
  Group group;
  group.own = counts.own(end_);
  group.heard = counts.heard(end_);
  group.lost = rt::count(counts.lost);
  if (end_ != ConnectionEnd::Provider) {
    group.turnedDown = {rt::count(commands.full), rt::count(commands.tooLarge),
                        rt::count(commands.invalid)};
  }
  group.eventsDelivered = rt::count(counts.events->delivered) + rt::count(counts.eventsHeardHere);
  // Read this last, so that every command with an outcome is among those that were sent.
  group.accepted = rt::count(commands.sent) + rt::count(counts.turnedAway);
  return group;
}

void Ledger::fold() {
  std::vector<Entry> kept;
  for (Entry& entry : entries_) {
    if (!entry.channel.expired()) {
      kept.push_back(std::move(entry));
    } else if (&entry == &entries_.back()) {
      kept.push_back({{}, nullptr, entry.otherProcess, groupOf(entry)});
    } else {
      Group& group = entry.otherProcess == otherProcess_ ? ended_ : gone_;
      group = group + groupOf(entry);
    }
  }
  entries_ = std::move(kept);
}

void Ledger::begin(const std::shared_ptr<Channel>& channel, std::uint64_t otherProcess,
                   const Earlier& earlier) {
  const std::lock_guard lock(mutex_);
  fold();
  lostHere_ = lostOf(groups());
  if (otherProcess != otherProcess_) leaveProcess();
  otherProcess_ = otherProcess;
  earlier_ = earlier;
  entries_.push_back({channel, channel->counts, otherProcess});
}

// Lost commands stay lost, also while channels are added whose last counts are awaited.
std::uint64_t Ledger::lostOf(const Groups& all) const {
  if (!earlier_.ended) return lostHere_;
  Group earlier = all.earlier;
  earlier.heard = larger(earlier.heard, earlier_.tally);
  return earlier.open();
}

// Keeps what that process has told, also of channels that still exist.
void Ledger::leaveProcess() {
  const Groups all = groups();
  const Tally told = larger(all.earlier.heard, earlier_.tally);
  lostThere_ += std::exchange(lostHere_, 0);
  ended_.heard = told - (all.earlier.heard - ended_.heard);
  gone_ = gone_ + ended_;
  ended_ = {};
}

void Ledger::tell(const Earlier& earlier) {
  const std::lock_guard lock(mutex_);
  fold();
  earlier_ = earlier;
}

Earlier Ledger::before(const Channel& latest) {
  const std::lock_guard lock(mutex_);
  fold();
  Group group = ended_;
  bool ended = history_ == History::Whole;
  for (const Entry& entry : entries_) {
    if (entry.channel.lock().get() == &latest) continue;
    group = group + groupOf(entry);
    ended = ended && entry.channel.expired();
  }
  return {group.own, ended};
}

Ledger::Groups Ledger::groups() const {
  Groups all{.gone = gone_, .earlier = ended_, .latest = {}};
  for (const Entry& entry : entries_) {
    const bool latest = &entry == &entries_.back();
    const bool gone = entry.otherProcess != otherProcess_;
    Group& group = gone ? all.gone : latest ? all.latest : all.earlier;
    group = group + groupOf(entry);
  }
  return all;
}

Sums Ledger::sums() const {
  const std::lock_guard lock(mutex_);
  Groups all = groups();
  all.earlier.heard = larger(all.earlier.heard, earlier_.tally);
  const Group whole = all.gone + all.earlier + all.latest;
  Sums sums;
  sums.accepted = whole.accepted;
  sums.turnedDown = whole.turnedDown;
  sums.eventsDelivered = whole.eventsDelivered;
  sums.tally = whole.own + whole.heard;
  sums.heard = all.earlier.heard + all.latest.heard;
  sums.lost = whole.lost;
  sums.otherProcess = otherProcess_;
  const std::shared_ptr<Channel> latest =
      entries_.empty() ? nullptr : entries_.back().channel.lock();
  divideOpen(all, latest.get(), sums);
  return sums;
}

void Ledger::divideOpen(const Groups& all, const Channel* latest, Sums& sums) const {
  if (end_ == ConnectionEnd::Client) {
    const bool over = latest == nullptr || isOver(latest->status.load(std::memory_order_acquire));
    (over ? sums.unknown : sums.underWay) += all.latest.open();
    const std::uint64_t lost = lostOf(all);
    sums.lost += lost + lostThere_;
    sums.unknown += withoutDebt(all.earlier.open(), lost);
    sums.unknown += withoutDebt(all.gone.open(), lostThere_);
  } else {
    // A thread may still be executing a command of a channel that is over: that one is under way.
    const std::uint64_t ended = ended_.open() + (latest == nullptr ? all.latest.open() : 0);
    sums.lost += ended;
    sums.underWay = withoutDebt(all.earlier.open() + all.latest.open(), ended);
  }
}

bool Ledger::isLatest(const Channel& channel) const {
  const std::lock_guard lock(mutex_);
  return !entries_.empty() && entries_.back().channel.lock().get() == &channel;
}

void Ledger::letGo() {
  const std::lock_guard lock(mutex_);
  fold();
}

}  // namespace suture
