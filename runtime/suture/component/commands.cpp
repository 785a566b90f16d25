// What a required interface does for its commands.
#include <suture/base/virtual_time.h>
#include <suture/component/channel/channel.h>
#include <suture/component/required.h>

#include <array>
#include <chrono>
#include <string>

namespace suture {
namespace {

// The client's thread alone counts what arrives there, so a read need not pay for an addition that
// others could join.
void countRead(Channel& channel, unsigned column) {
  if (!channel.foreign) return;
  const std::uint64_t before = channel.bytesReceived.load(std::memory_order_relaxed);
  channel.bytesReceived.store(before + channel.state->columnSize(column),
                              std::memory_order_relaxed);
}

}  // namespace

Duration RequiredBase::deadlineOf(std::uint16_t command) const {
  const ConnectionWatch* const watch = channel_->watch.get();
  const bool agreed = watch != nullptr && watch->contract.deadline > Duration{0};
  return agreed ? watch->contract.deadline : info_.commands[command].deadline;
}

Sample<void> RequiredBase::judgeAge(Time stamp) {
  ConnectionWatch* const watch = channel_->watch.get();
  if (watch == nullptr || watch->contract.maxAge == Duration{0}) return Sample<void>(stamp);
  if (now() - stamp <= watch->contract.maxAge) return Sample<void>(stamp);
  watch->staleReads.fetch_add(1, std::memory_order_relaxed);
  if (watch->contract.resume == Resume::Operator) watch->awaitsOperator = true;
  return fallBack(watch->contract.onStale, Errc::Stale, stamp);
}

bool RequiredBase::ruledByContract(Errc error) const {
  return (error == Errc::Lost || error == Errc::Faulted) && channel_->watch != nullptr;
}

Sample<void> RequiredBase::judgeLoss(Errc error, std::uint16_t command, std::byte* slot) {
  if (!ruledByContract(error)) return error;
  const auto column = static_cast<unsigned>(info_.commands[command].column);
  const Result<Time> stamp = channel_->state->read(column, slot);
  if (!stamp || !admitsCopy(command, slot)) return error;
  return fallBack(channel_->watch->contract.onLoss, error, *stamp);
}

Sample<void> RequiredBase::fallBack(Fallback fallback, Errc error, Time stamp) {
  if (fallback == Fallback::Fault && error == Errc::Stale) {
    owner_.park("connection '" + channel_->name + "': a value was " +
                    std::to_string((now() - stamp) / std::chrono::milliseconds(1)) +
                    " ms old, beyond its max_age, and its on_stale is fault",
                FaultCause::Connection);
  }
  const bool usable = fallback == Fallback::Zero || fallback == Fallback::Last;
  return {error, stamp, usable};
}

bool RequiredBase::zeroes(const Sample<void>& answer) const {
  if (!answer || answer.error() == Errc{}) return false;
  const ConnectionContract& contract = channel_->watch->contract;
  return (answer.error() == Errc::Stale ? contract.onStale : contract.onLoss) == Fallback::Zero;
}

ProvidedBase* RequiredBase::callee(std::uint16_t command) const {
  const Channel::Ends& ends = channel_->ends;
  return info_.commands[command].inCallersThread ? ends.here : ends.device;
}

Errc RequiredBase::claim(std::uint16_t command, std::uint32_t call, std::byte*& arguments) {
  const Result<std::byte*> claimed = channel_->commands.claim(command, now(), call);
  if (!claimed) return claimed.error();
  if (VirtualTime* const time = virtualTime(); time != nullptr) {
    time->note(VirtualTime::Kind::Send, name_.c_str(), info_.commands[command].name,
               channel_->commands.nextSequence());
  }
  arguments = *claimed;
  return Errc{};
}

Errc RequiredBase::judge(std::uint16_t command, const std::byte* arguments, bool fits) {
  rt::MailboxCounters& counters = channel_->commands.counters;
  if (!fits) {
    counters.tooLarge.fetch_add(1, std::memory_order_relaxed);
    return Errc::TooLarge;
  }
  if (channel_->admits(info_.commands[command], arguments)) return Errc{};
  counters.invalid.fetch_add(1, std::memory_order_relaxed);
  return Errc::Invalid;
}

Errc RequiredBase::commit(std::uint16_t command, const std::byte* arguments, bool fits) {
  if (const Errc error = judge(command, arguments, fits); error != Errc{}) {
    channel_->commands.abandon();
    return error;
  }
  channel_->countSent(channel_->commands.commit());
  owner_.ringLater(*channel_->ends.provider);
  return Errc{};
}

bool RequiredBase::admitsResult(std::uint16_t command, const std::byte* result) const {
  return channel_->admitsResult(info_.commands[command], result);
}

// A provider in this process was judged when it produced the value; the build of another process
// may admit more than this one, and no thread before the reader's looks at what it sent.
bool RequiredBase::admitsCopy(std::uint16_t command, const std::byte* result) const {
  if (channel_->ends.here != nullptr || info_.commands[command].admitsResult(result)) return true;
  return admitsResult(command, result);  // once more, to note where
}

FieldPath RequiredBase::lastInvalid() const {
  return channel_ == nullptr ? FieldPath() : channel_->lastInvalid.read();
}

Errc RequiredBase::ask(std::uint16_t command, bool& device) {
  if (const Errc error = unusable(command); error != Errc{}) return error;
  device = channel_->ends.device != nullptr;
  if (device) return Errc{};
  const auto column = static_cast<unsigned>(info_.commands[command].column);
  if (channel_->state->ask(column)) owner_.ringLater(*channel_->ends.provider);
  return Errc{};
}

Sample<void> RequiredBase::read(std::uint16_t command, std::byte* slot, bool& device) {
  const Errc error = ask(command, device);
  if (device) return error;
  if (error != Errc{}) return judgeLoss(error, command, slot);
  const auto column = static_cast<unsigned>(info_.commands[command].column);
  const Result<Time> stamp = channel_->state->read(column, slot);
  if (!stamp) return stamp.error();
  if (!admitsCopy(command, slot)) return Errc::Invalid;
  countRead(*channel_, column);
  channel_->noteRead(*stamp);
  return judgeAge(*stamp);
}

Sample<void> RequiredBase::readAt(Time at, std::uint16_t command, std::byte* slot, bool& device) {
  if (const Errc error = ask(command, device); error != Errc{}) return error;
  if (device && at < now()) {
    device = false;
    return Errc::TooOld;
  }
  if (device) return Errc{};
  const auto column = static_cast<unsigned>(info_.commands[command].column);
  const Result<Time> stamp = channel_->state->readAt(at, column, slot);
  if (!stamp) return stamp.error();
  if (!admitsCopy(command, slot)) return Errc::Invalid;
  countRead(*channel_, column);
  return Sample<void>(*stamp);
}

Sample<void> RequiredBase::readRow(const Time* at, std::span<const std::uint16_t> commands,
                                   std::span<std::byte* const> slots, bool& device) {
  std::array<std::byte*, 64> byColumn{};  // a contract has no more reads
  Errc loss{};
  const auto whyNot = [&loss](Errc error) { return loss == Errc{} ? error : loss; };
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const Errc error = ask(commands[i], device);
    if (device) return error;
    if (error != Errc{} && (at != nullptr || !ruledByContract(error))) return error;
    loss = error;
    byColumn[static_cast<std::size_t>(info_.commands[commands[i]].column)] = slots[i];
  }
  const rt::StateTable& state = *channel_->state;
  const std::span<std::byte* const> wanted = std::span(byColumn).first(state.columns());
  const rt::StateTable::Row row =
      at == nullptr ? state.readRow(wanted) : state.readRowAt(*at, wanted);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const auto column = static_cast<unsigned>(info_.commands[commands[i]].column);
    if (const Errc error = row.missing(column); error != Errc{}) return whyNot(error);
    if (!admitsCopy(commands[i], slots[i])) return whyNot(Errc::Invalid);
  }
  if (loss != Errc{}) return fallBack(channel_->watch->contract.onLoss, loss, row.stamp);
  if (at != nullptr) return Sample<void>(row.stamp);
  channel_->noteRead(row.stamp);
  return judgeAge(row.stamp);
}

}  // namespace suture
