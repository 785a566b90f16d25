#pragma once
// These are the commands on their way from a client to its provider, in the order in which they
// were sent: a ring for queued commands, and a newest-wins cell for each latest() command.

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

/// Tells the mailbox what it must know of each command of a contract.
struct CommandLimits {
  std::uint32_t argumentsSize;  ///< bytes of its arguments' slot
  std::uint32_t depth;  ///< how many may wait; for latest(): how many calls with an answer may
  bool latest;          ///< newest wins, unless an answer was asked for
  bool shared = false;  ///< the arguments are a counted pointer, see base/slots/shared_slot.h
  BoundedLevels levels = {};  ///< those of the arguments' slot
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

/// Counts the commands of one connection. Each counter is written by one side and may be read by
/// any thread.
struct MailboxCounters {
  std::atomic<std::uint64_t> sent{0}, full{0}, tooLarge{0}, invalid{0}, replaced{0};  // producer
  std::atomic<std::uint64_t> executed{0}, late{0}, superseded{0}, failed{0};          // consumer
  std::atomic<std::uint64_t> refused{0}, cancelled{0};  // consumer: has not begun them
  std::atomic<std::uint64_t> overtaken{0};  // consumer: replaced when it had been taken already
};

/// One producer thread, one consumer thread. Never locks, and never allocates after construction.
///
/// A drain first fixes a cut, which is the last sequence published so far. It then executes what is
/// at or before the cut in the order of sequence; what comes later waits for the next drain. So an
/// old servo_cp never runs after a newer hold(), whether they travelled in the ring or in a cell.
///
/// In foreign memory each process has an object of its own and uses one end. After a record that
/// the producer cannot have written, the consumer takes nothing any more.
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

  /// Returns memory for the arguments of `command`, to be filled before commit(). A `call` other
  /// than 0 asks for an answer. Returns Errc::Full if as many of this command wait as its depth
  /// allows.
  Result<std::byte*> claim(std::uint16_t command, Time stamp, std::uint32_t call);
  /// After a successful claim() one of these is called: commit() publishes the command and returns
  /// how many bytes it takes up; abandon() gives it up.
  std::size_t commit();
  void abandon();
  /// Returns the sequence that the next committed command gets.
  std::uint64_t nextSequence() const { return nextSequence_; }
  /// Returns how many of `command` use a credit that the consumer has not returned yet.
  std::uint32_t waiting(std::uint16_t command) const {
    return taken_[command] - returned(command).load(std::memory_order_acquire);
  }

  /// Returns how many more of `command` may wait now. For a newest-wins command it is kUnlimited,
  /// because one without an answer may always wait. If it is 0, roomAwaited() has been raised.
  std::uint32_t room(std::uint16_t command);
  static constexpr std::uint32_t kUnlimited = ~std::uint32_t{0};

  // --- consumer ---

  /// Starts a drain of all that was published before now; what comes later waits for the next one.
  void fixCut();
  /// Returns the next command up to the cut, in the order of sequence, or nullptr. It must be
  /// followed by pop().
  const CommandRecord* next();
  /// Lets go of the command that next() returned.
  void pop();
  /// Tells the producer that one more of `command` may wait. Call it after pop(), either at once or
  /// when a far end has taken the command.
  void returnCredit(std::uint16_t command);
  /// Returns the flag that is up if the producer has found no room. A thread that lowers it, after
  /// its returnCredit(), must then ring the producer.
  SharedFlag& roomAwaited() { return *roomAwaited_; }
  /// Any thread. Returns true if a command is waiting that next() has not returned.
  bool pending() const;

  /// Do not rely on these in foreign memory, because both processes can write them.
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
  /// Copies a record out of foreign memory. Copies less of an impossible one, which isPossible()
  /// then finds out.
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

  // The producer writes published_, the consumer returned_; both read both.
  const std::shared_ptr<std::atomic<std::uint64_t>> published_;
  const std::shared_ptr<Credits> returned_;  // given back so far, by command
  const std::shared_ptr<SharedFlag> roomAwaited_;

  // Consumer's side.
  const bool foreign_;
  std::size_t mostWaiting_ = 0;  // as the credits allow
  std::size_t left_ = 0;         // in this drain, so that it ends whatever a foreign producer does
  bool broken_ = false;          // a record was found that the producer cannot have written
  std::uint64_t cut_ = 0;
  std::atomic<std::uint64_t> lastReturned_{0};  // written by the consumer only
  CommandRecord* next_ = nullptr;               // what the last next() returned
  Cell* nextCell_ = nullptr;                    // where it lies; nullptr: in the ring
};

}  // namespace suture::rt
