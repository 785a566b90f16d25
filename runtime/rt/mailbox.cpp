#include <suture/base/shared_slot.h>
#include <suture/rt/mailbox.h>

#include <algorithm>
#include <new>

namespace suture::rt {
namespace {

void increment(std::atomic<std::uint64_t>& counter) {
  // Single writer: no read-modify-write needed.
  counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

/// What the consumer has not popped yet is its own.
CommandRecord* ownRecord(const std::byte* memory) {
  return reinterpret_cast<CommandRecord*>(const_cast<std::byte*>(memory));
}

std::size_t recordBytes(const CommandLimits& limits) {
  return sizeof(CommandRecord) + limits.argumentsSize;
}

}  // namespace

std::size_t Mailbox::ringBytes(std::span<const CommandLimits> commands) {
  std::size_t bytes = 0;
  for (const auto& limits : commands)
    bytes += limits.depth * SpscRing::recordSize(recordBytes(limits));
  return bytes;
}

Mailbox::Mailbox(std::span<const CommandLimits> commands)
    : limits_(commands.begin(), commands.end()),
      cellOf_(commands.size(), -1),
      ring_(ringBytes(commands)),
      taken_(commands.size(), 0),
      returned_(commands.size()) {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    if (!limits_[i].latest) continue;
    cellOf_[i] = static_cast<int>(cells_.size());
    cells_.emplace_back(recordBytes(limits_[i]));
  }
}

Mailbox::~Mailbox() {
  while (const std::byte* memory = ring_.front()) {
    releaseArguments(*ownRecord(memory));
    ring_.pop();
  }
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    if (!limits_[i].latest || !limits_[i].shared) continue;
    cells_[static_cast<std::size_t>(cellOf_[i])].values.forEachBuffer(
        [](std::byte* memory) { releaseSharedSlot(memory + sizeof(CommandRecord)); });
  }
}

void Mailbox::releaseArguments(CommandRecord& record) const {
  if (limits_[record.command].shared) releaseSharedSlot(record.arguments());
}

Result<std::byte*> Mailbox::claim(std::uint16_t command, Time stamp, std::uint32_t call) {
  const CommandLimits& limits = limits_[command];
  claimedCommand_ = command;
  std::byte* memory;
  if (limits.latest && call == 0) {
    claimedCell_ = &cells_[static_cast<std::size_t>(cellOf_[command])];
    memory = claimedCell_->values.claim();
    // Of a command that has been replaced.
    if (limits.shared) releaseSharedSlot(memory + sizeof(CommandRecord));
  } else {
    claimedCell_ = nullptr;
    const std::uint32_t waiting =
        taken_[command] - returned_[command].load(std::memory_order_acquire);
    // The ring holds every credit's record; a provider that gives back more than it took cannot
    // overrun it.
    memory = waiting < limits.depth ? ring_.claim(recordBytes(limits)) : nullptr;
    if (memory == nullptr) {
      increment(counters.full);
      return tl::unexpected(Errc::Full);
    }
    if (limits.shared) putSharedSlot(memory + sizeof(CommandRecord), nullptr);
  }
  claimed_ = new (memory) CommandRecord{nextSequence_, stamp, call, command, 0};
  return claimed_->arguments();
}

void Mailbox::abandon() { releaseArguments(*claimed_); }

void Mailbox::commit() {
  if (claimedCell_ != nullptr) {
    if (claimedCell_->values.commit()) increment(counters.replaced);
  } else {
    ++taken_[claimedCommand_];
    ring_.commit();
  }
  published_.store(nextSequence_++, std::memory_order_release);
  increment(counters.sent);
}

void Mailbox::fixCut() {
  // The cut first, the cells after it: a cell then holds its command up to the cut or something
  // newer.
  cut_ = published_.load(std::memory_order_acquire);
  for (Cell& cell : cells_) cell.held = cell.values.take() || cell.held;
}

const CommandRecord* Mailbox::next() {
  while (true) {
    CommandRecord* earliest = ownRecord(ring_.front());
    nextCell_ = nullptr;
    for (Cell& cell : cells_) {
      if (!cell.held) continue;
      CommandRecord* const record = ownRecord(cell.values.front());
      if (earliest == nullptr || record->sequence < earliest->sequence) {
        earliest = record;
        nextCell_ = &cell;
      }
    }
    if (earliest == nullptr || earliest->sequence > cut_) return nullptr;
    next_ = earliest;
    if (earliest->sequence > lastReturned_.load(std::memory_order_relaxed)) {
      lastReturned_.store(earliest->sequence, std::memory_order_relaxed);
      return earliest;
    }
    const std::uint16_t command = earliest->command;
    const bool fromRing = nextCell_ == nullptr;
    pop();
    if (fromRing) returnCredit(command);
    increment(counters.superseded);
  }
}

void Mailbox::pop() {
  releaseArguments(*next_);
  if (nextCell_ != nullptr) {
    nextCell_->held = false;
  } else {
    ring_.pop();
  }
}

void Mailbox::returnCredit(std::uint16_t command) {
  auto& returned = returned_[command];
  returned.store(returned.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

bool Mailbox::pending() const {
  return published_.load(std::memory_order_acquire) > lastReturned_.load(std::memory_order_relaxed);
}

}  // namespace suture::rt
