#include <suture/base/slots/shared_slot.h>
#include <suture/base/slots/used_parts.h>
#include <suture/rt/counter.h>
#include <suture/rt/queue/mailbox.h>
#include <suture/rt/queue/record_copy.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

namespace suture::rt {
namespace {

/// Returns a record that the consumer may change until it has popped it.
CommandRecord* ownRecord(const std::byte* memory) {
  return reinterpret_cast<CommandRecord*>(const_cast<std::byte*>(memory));
}

std::size_t recordBytes(const CommandLimits& limits) {
  return sizeof(CommandRecord) + limits.argumentsSize;
}

std::size_t largestRecord(std::span<const CommandLimits> commands) {
  std::size_t largest = 0;
  for (const CommandLimits& limits : commands) largest = std::max(largest, recordBytes(limits));
  return largest;
}

}  // namespace

std::size_t Mailbox::ringBytes(std::span<const CommandLimits> commands) {
  std::size_t bytes = 0;
  for (const auto& limits : commands)
    bytes += limits.depth * SpscRing::recordSize(recordBytes(limits));
  return bytes;
}

Mailbox::Mailbox(std::span<const CommandLimits> commands, Arena& arena)
    : counters_(arena.make<MailboxCounters>()),
      limits_(commands.begin(), commands.end()),
      cellOf_(commands.size(), -1),
      ring_(ringBytes(commands), largestRecord(commands), arena),
      taken_(commands.size(), 0),
      published_(arena.make<std::atomic<std::uint64_t>>()),
      returned_(arena.make<Credits>(commands.size())),
      roomAwaited_(arena.make<SharedFlag>()),
      foreign_(arena.foreign()) {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    mostWaiting_ += limits_[i].depth;
    if (!limits_[i].latest) continue;
    ++mostWaiting_;
    cellOf_[i] = static_cast<int>(cells_.size());
    cells_.push_back(std::make_unique<Cell>(recordBytes(limits_[i]), arena));
  }
}

// Releases what is left, except in foreign memory, where no argument owns memory.
Mailbox::~Mailbox() {
  if (foreign_) return;
  while (const std::byte* memory = ring_.front()) {
    releaseArguments(*ownRecord(memory));
    ring_.pop();
  }
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    if (!limits_[i].latest || !limits_[i].shared) continue;
    cells_[static_cast<std::size_t>(cellOf_[i])]->values.forEachBuffer(
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
    claimedCell_ = cells_[static_cast<std::size_t>(cellOf_[command])].get();
    memory = claimedCell_->values.claim();
    // The cell may still own the arguments of a command that has been replaced.
    if (limits.shared) releaseSharedSlot(memory + sizeof(CommandRecord));
  } else {
    claimedCell_ = nullptr;
    const std::uint32_t waiting = this->waiting(command);
    // The ring has room for the record of every credit. It still checks, because a provider may
    // give back more credits than were taken.
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

// Looks once more after it has raised the flag: credits that were returned before the flag was
// lowered are seen by then, and for later ones the consumer finds the flag up.
std::uint32_t Mailbox::room(std::uint16_t command) {
  const CommandLimits& limits = limits_[command];
  if (limits.latest) return kUnlimited;
  const auto left = [&] { return limits.depth - std::min(limits.depth, waiting(command)); };
  if (const std::uint32_t room = left(); room != 0) return room;
  roomAwaited_->raiseBehindTake();
  return left();
}

void Mailbox::abandon() { releaseArguments(*claimed_); }

std::size_t Mailbox::commit() {
  if (claimedCell_ != nullptr) {
    if (claimedCell_->values.commit()) increment(counters.replaced);
  } else {
    ++taken_[claimedCommand_];
    ring_.commit();
  }
  published_->store(nextSequence_++, std::memory_order_release);
  increment(counters.sent);
  return SpscRing::recordSize(recordBytes(limits_[claimedCommand_]));
}

// Looks only at its copy of the record, because the original may change.
void Mailbox::copyForeign(std::byte* to, const std::byte* from, std::size_t size) const {
  const auto record = copyHead<CommandRecord>(to, from, size);
  if (record.command >= limits_.size()) return;
  const CommandLimits& limits = limits_[record.command];
  if (recordBytes(limits) > size) return;
  copyUsed(to + sizeof(record), from + sizeof(record), limits.argumentsSize, limits.levels);
}

void Mailbox::fixCut() {
  // Take the cut before the cells, so that a cell holds its command up to the cut, or something
  // newer.
  cut_ = published_->load(std::memory_order_acquire);
  left_ = mostWaiting_;
  for (const auto& cell : cells_) {
    if (!cell->values.take(copier())) continue;
    // What the last drain had to leave, because it was newer than that drain's cut, makes way.
    if (std::exchange(cell->held, true)) increment(counters.overtaken);
  }
}

// Returns the command that was sent first among the front of the ring and the cells.
CommandRecord* Mailbox::earliest() {
  CommandRecord* earliest = ownRecord(ring_.front(copier()));
  nextCell_ = nullptr;
  for (const auto& cell : cells_) {
    if (!cell->held) continue;
    CommandRecord* const record = ownRecord(cell->values.front());
    if (earliest == nullptr || record->sequence < earliest->sequence) {
      earliest = record;
      nextCell_ = cell.get();
    }
  }
  return earliest;
}

// Returns true if the producer could have written it, because a foreign one may write anything.
bool Mailbox::isPossible(const CommandRecord& record) const {
  if (record.command >= limits_.size()) return false;
  if (nextCell_ == nullptr) return ring_.frontSize() == recordBytes(limits_[record.command]);
  const int cell = cellOf_[record.command];
  return cell >= 0 && nextCell_ == cells_[static_cast<std::size_t>(cell)].get();
}

const CommandRecord* Mailbox::next() {
  while (!broken_) {
    next_ = earliest();
    if (next_ == nullptr || next_->sequence > cut_) return nullptr;
    if (foreign_) {
      broken_ = !isPossible(*next_);
      if (broken_ || left_-- == 0) break;
      next_->stamp = std::clamp(next_->stamp, Time{}, now());
    }
    if (next_->sequence > lastReturned_.load(std::memory_order_relaxed)) {
      lastReturned_.store(next_->sequence, std::memory_order_relaxed);
      return next_;
    }
    const std::uint16_t command = next_->command;
    const bool fromRing = nextCell_ == nullptr;
    pop();
    if (fromRing) returnCredit(command);
    increment(counters.superseded);
  }
  return nullptr;
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
  Credits& credits = returned(command);
  credits.store(credits.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

bool Mailbox::pending() const {
  return published_->load(std::memory_order_acquire) >
         lastReturned_.load(std::memory_order_relaxed);
}

}  // namespace suture::rt
