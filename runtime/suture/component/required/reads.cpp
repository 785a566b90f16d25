#include <suture/component/channel/channel.h>
#include <suture/component/component.h>
#include <suture/component/required/reads.h>

#include <array>
#include <chrono>
#include <cstring>
#include <string>

namespace suture {
namespace {

// Only the client's thread counts what its reads copy, so no read has to pay for an atomic
// addition.
void countRead(Channel& channel, unsigned column) {
  if (!channel.foreign) return;
  const std::uint64_t before = channel.bytesReceived.load(std::memory_order_relaxed);
  channel.bytesReceived.store(before + channel.state->columnSize(column),
                              std::memory_order_relaxed);
}

}  // namespace

unsigned Reads::columnOf(std::uint16_t command) const {
  return static_cast<unsigned>(attachment_.info().commands[command].column);
}

bool Reads::admits(std::uint16_t command, const std::byte* copy) const {
  return attachment_.channel()->admitsCopy(attachment_.info().commands[command], copy);
}

Errc Reads::ask(std::uint16_t command, bool& device) {
  if (const Errc error = attachment_.unusable(command); error != Errc{}) return error;
  const Channel& channel = *attachment_.channel();
  device = channel.ends.device != nullptr;
  if (device) return Errc{};
  if (channel.state->ask(columnOf(command))) attachment_.owner().ringLater(*channel.ends.provider);
  return Errc{};
}

Sample<void> Reads::read(std::uint16_t command, std::byte* slot, bool& device) {
  const Errc error = ask(command, device);
  if (device) return error;
  if (error != Errc{}) return judgeLoss(error, command, slot);
  Channel& channel = *attachment_.channel();
  const unsigned column = columnOf(command);
  const Result<Time> stamp = channel.state->read(column, slot);
  if (!stamp) return stamp.error();
  if (!admits(command, slot)) return Errc::Invalid;
  countRead(channel, column);
  noteRead(*stamp);
  return judgeAge(*stamp);
}

Sample<void> Reads::readAt(Time at, std::uint16_t command, std::byte* slot, bool& device) {
  if (const Errc error = ask(command, device); error != Errc{}) return error;
  if (device && at < now()) {
    device = false;
    return Errc::TooOld;
  }
  if (device) return Errc{};
  Channel& channel = *attachment_.channel();
  const unsigned column = columnOf(command);
  const Result<Time> stamp = channel.state->readAt(at, column, slot);
  if (!stamp) return stamp.error();
  if (!admits(command, slot)) return Errc::Invalid;
  countRead(channel, column);
  return Sample<void>(*stamp);
}

Sample<void> Reads::readRow(const Time* at, std::span<const std::uint16_t> commands,
                            std::span<std::byte* const> slots, bool& device) {
  std::array<std::byte*, 64> byColumn{};  // a contract has no more reads
  Errc loss{};
  const auto whyNot = [&loss](Errc error) { return loss == Errc{} ? error : loss; };
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const Errc error = ask(commands[i], device);
    if (device) return error;
    if (error != Errc{} && (at != nullptr || !ruledByContract(error))) return error;
    if (error != Errc{}) loss = error;
    byColumn[columnOf(commands[i])] = slots[i];
  }
  Channel& channel = *attachment_.channel();
  const rt::StateTable& state = *channel.state;
  const std::span<std::byte* const> wanted = std::span(byColumn).first(state.columns());
  const rt::StateTable::Row row =
      at == nullptr ? state.readRow(wanted) : state.readRowAt(*at, wanted);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const unsigned column = columnOf(commands[i]);
    if (const Errc error = row.missing(column); error != Errc{}) return whyNot(error);
    if (slots[i] != byColumn[column]) {  // it is asked for twice
      std::memcpy(slots[i], byColumn[column], state.columnSize(column));
    }
    if (!admits(commands[i], slots[i])) return whyNot(Errc::Invalid);
    countRead(channel, column);
  }
  if (loss != Errc{}) return fallBack(channel.terms.watch->contract.onLoss, loss, row.stamp);
  if (at != nullptr) return Sample<void>(row.stamp);
  noteRead(row.stamp);
  return judgeAge(row.stamp);
}

// Looks at the clock when a row is first read, and then at every 16th read of a row that was read
// before, because the clock takes longer than the read itself.
void Reads::noteRead(Time stamp) {
  if (stamp == lastRead_ && ++repeatedReads_ % 16 != 0) return;
  lastRead_ = stamp;
  attachment_.channel()->client.readAge->record(now() - stamp);
}

Sample<void> Reads::judgeAge(Time stamp) {
  ConnectionWatch* const watch = attachment_.channel()->terms.watch.get();
  if (watch == nullptr || watch->contract.maxAge == Duration{0}) return Sample<void>(stamp);
  if (now() - stamp <= watch->contract.maxAge) return Sample<void>(stamp);
  watch->staleReads.fetch_add(1, std::memory_order_relaxed);
  if (watch->contract.resume == Resume::Operator) watch->awaitsOperator = true;
  return fallBack(watch->contract.onStale, Errc::Stale, stamp);
}

bool Reads::ruledByContract(Errc error) const {
  return (error == Errc::Lost || error == Errc::Faulted) &&
         attachment_.channel()->terms.watch != nullptr;
}

Sample<void> Reads::judgeLoss(Errc error, std::uint16_t command, std::byte* slot) {
  if (!ruledByContract(error)) return error;
  const Channel& channel = *attachment_.channel();
  const Result<Time> stamp = channel.state->read(columnOf(command), slot);
  if (!stamp || !admits(command, slot)) return error;
  return fallBack(channel.terms.watch->contract.onLoss, error, *stamp);
}

Sample<void> Reads::fallBack(Fallback fallback, Errc error, Time stamp) {
  if (fallback == Fallback::Fault && error == Errc::Stale) {
    attachment_.owner().park("connection '" + attachment_.channel()->name() + "': a value was " +
                                 std::to_string((now() - stamp) / std::chrono::milliseconds(1)) +
                                 " ms old, beyond its max_age, and its on_stale is fault",
                             FaultCause::Connection);
  }
  const bool usable = fallback == Fallback::Zero || fallback == Fallback::Last;
  return {error, stamp, usable};
}

bool Reads::zeroes(const Sample<void>& answer) const {
  if (!answer || answer.error() == Errc{}) return false;
  const ConnectionContract& contract = attachment_.channel()->terms.watch->contract;
  return (answer.error() == Errc::Stale ? contract.onStale : contract.onLoss) == Fallback::Zero;
}

}  // namespace suture
