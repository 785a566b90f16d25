#pragma once
// The commands on their way from a client to its provider, in the order in which they were sent: a
// ring for queued commands, a newest-wins cell for each latest() command.

#include <suture/base/errors.h>
#include <suture/base/slots/bounded_level.h>
#include <suture/base/time.h>
#include <suture/rt/queue/latest_cell.h>
#include <suture/rt/queue/spsc_ring.h>
#include <suture/rt/shared_flag.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace suture::rt {

/// What the mailbox must know of each command of a contract.
struct CommandLimits {
  std::uint32_t argumentsSize;  ///< bytes of its arguments' slot
  std::uint32_t depth;  ///< how many may wait; for latest(): how many calls with an answer may
  bool latest;          ///< newest wins, unless an answer was asked for
  bool shared = false;  ///< the arguments are a counted pointer, see base/slots/shared_slot.h
  BoundedLevels levels = {};  ///< of the arguments
};

/// Precedes the arguments of every command.
struct CommandRecord {
  std::uint64_t sequence;  ///< position among all commands of this connection, from 1
  Time stamp;              ///< when it was sent, on this process's clock
  std::uint32_t call;      ///< 0: no answer wanted; else the number the answer must carry
  std::uint16_t command;
  std::uint16_t reserved;

  std::byte* arguments() { return reinterpret_cast<std::byte*>(this + 1); }
  const std::byte* arguments() const { return reinterpret_cast<const std::byte*>(this + 1); }
};

/// Counts of one connection; each is written by one side and may be read by any thread.
struct MailboxCounters {
  std::atomic<std::uint64_t> sent{0}, full{0}, tooLarge{0}, invalid{0}, replaced{0};  // producer
  std::atomic<std::uint64_t> executed{0}, late{0}, superseded{0}, failed{0};          // consumer
  std::atomic<std::uint64_t> refused{0}, cancelled{0};  // consumer: has not begun them
};

/// One producer thread, one consumer thread. No allocation after construction, no locks.
///
/// A drain first fixes a cut, the last sequence published so far, and then executes what is at or
/// before the cut in sequence order; what comes later waits for the next drain. So an old servo_cp
/// never runs after a newer hold(), whichever of ring and cell they travelled in.
///
/// In foreign memory each process has an object of its own and uses one end. The consumer takes
/// nothing any more after a record that the producer cannot have written.
class Mailbox {
  const std::shared_ptr<MailboxCounters> counters_;

 public:
  Mailbox(std::span<const CommandLimits> commands, Arena& arena);
  explicit Mailbox(std::span<const CommandLimits> commands, Arena&& arena = {})
      : Mailbox(commands, arena) {}
  ~Mailbox();
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  // --- producer ---

  /// Memory for the arguments of `command`, to be filled before commit(). `call` other than 0 asks
  /// for an answer. Errc::Full if as many of this command wait as its depth allows.
  Result<std::byte*> claim(std::uint16_t command, Time stamp, std::uint32_t call);
  /// Publishes the command of the last successful claim(), and tells what it takes up; or gives it
  /// up.
  std::size_t commit();
  void abandon();
  /// The next command that is committed gets this one.
  std::uint64_t nextSequence() const { return nextSequence_; }
  /// How many of `command` use a credit that the consumer has not returned yet.
  std::uint32_t waiting(std::uint16_t command) const {
    return taken_[command] - returned(command).load(std::memory_order_acquire);
  }

  /// Returns how many more of `command` may wait now; kUnlimited of a newest-wins one, of which one
  /// without an answer always may. If none may, roomAwaited() is up.
  std::uint32_t room(std::uint16_t command);
  static constexpr std::uint32_t kUnlimited = ~std::uint32_t{0};

  // --- consumer ---

  /// Starts a drain: what was published before now is in, what comes later is not.
  void fixCut();
  /// The next command up to the cut, in sequence order, or nullptr. Must be followed by pop().
  const CommandRecord* next();
  /// Lets go of the command that next() returned.
  void pop();
  /// Tells the producer that one more of `command` may wait. After pop(), at once or when a far end
  /// has taken the command.
  void returnCredit(std::uint16_t command);
  /// It is up if the producer has found no room. Whoever lowers it behind its returnCredit() rings
  /// the producer then.
  SharedFlag& roomAwaited() { return *roomAwaited_; }
  /// Any thread: true if something is waiting that next() has not returned.
  bool pending() const;

  /// Do not believe these in foreign memory, where both processes write them.
  MailboxCounters& counters = *counters_;
  std::shared_ptr<const MailboxCounters> sharedCounters() const { return counters_; }

 private:
  struct Cell {
    Cell(std::size_t size, Arena& arena) : values(size, arena) {}

    LatestCell values;
    bool held = false;  // taken from the producer, not yet returned by next()
  };

  using Credits = std::atomic<std::uint32_t>;

  static std::size_t ringBytes(std::span<const CommandLimits> commands);
  Credits& returned(std::uint16_t command) const { return returned_.get()[command]; }
  /// Copies a record out of foreign memory, unless it cannot be: isPossible() finds that out.
  void copyForeign(std::byte* to, const std::byte* from, std::size_t size) const;
  auto copier() const {
    return [this](std::byte* to, const std::byte* from, std::size_t size) {
      copyForeign(to, from, size);
    };
  }
  CommandRecord* earliest();
  bool isPossible(const CommandRecord& record) const;
  /// Releases the counted pointers that the record's arguments hold.
  void releaseArguments(CommandRecord& record) const;

  std::vector<CommandLimits> limits_;
  std::vector<int> cellOf_;  // by command; -1: none
  std::vector<std::unique_ptr<Cell>> cells_;
  SpscRing ring_;

  // Producer's side.
  std::vector<std::uint32_t> taken_;  // credits used so far, by command
  std::uint64_t nextSequence_ = 1;
  std::uint16_t claimedCommand_ = 0;
  CommandRecord* claimed_ = nullptr;
  Cell* claimedCell_ = nullptr;

  // The producer writes the first, the consumer the second; both read both.
  const std::shared_ptr<std::atomic<std::uint64_t>> published_;
  const std::shared_ptr<Credits> returned_;  // given back so far, by command
  const std::shared_ptr<SharedFlag> roomAwaited_;

  // Consumer's side.
  const bool foreign_;
  std::size_t mostWaiting_ = 0;  // as the credits allow
  std::size_t left_ = 0;  // of them, in this drain: it ends, whatever a foreign producer does
  bool broken_ = false;   // there has been a record that cannot be
  std::uint64_t cut_ = 0;
  std::atomic<std::uint64_t> lastReturned_{0};  // written by the consumer only
  CommandRecord* next_ = nullptr;               // what the last next() returned
  Cell* nextCell_ = nullptr;                    // where it lies; nullptr: in the ring
};

}  // namespace suture::rt
