// This fuzzes the readers of memory that another process writes: mailbox, event queue and state
// table. The other process writes as it should, and between that any value at any place; what a
// reader hands out must be a record of the contract, and must not change while it is in use.

#include <suture/rt/queue/event_queue.h>
#include <suture/rt/queue/mailbox.h>
#include <suture/rt/state/state_table.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <vector>

#include "tests/fuzz/input.h"
#include "tests/fuzz/require.h"

namespace {

using namespace suture;
using fuzz::Input;
using fuzz::require;

constexpr BoundedLevel kLevelsOf24[] = {{.size = 0, .data = 8, .stride = 2, .capacity = 6}},
                       kLevelsOf136[] = {
                           {.size = 4, .data = 8, .stride = 8, .capacity = 3},
                           {.size = 40, .data = 48, .stride = 4, .capacity = 4, .mostColumns = 5}};
constexpr std::array<rt::CommandLimits, 3> kCommands = {
    {{.argumentsSize = 24, .depth = 3, .latest = false, .levels = kLevelsOf24},
     {.argumentsSize = 136, .depth = 2, .latest = true, .levels = kLevelsOf136},
     {.argumentsSize = 0, .depth = 1, .latest = false}}};
constexpr std::array<rt::EventLimits, 5> kEvents = {
    {{.payloadSize = 40, .depth = 3, .latest = false},
     {.payloadSize = 8, .depth = 2, .latest = true},
     {.payloadSize = 0, .depth = 4, .latest = false},
     {.payloadSize = 24, .depth = 1, .latest = false, .latched = true, .levels = kLevelsOf24},
     {.payloadSize = 600, .depth = 2, .latest = false, .levels = kLevelsOf136}}};
constexpr std::array<std::uint32_t, 2> kColumns = {48, 8};
constexpr BoundedLevel kLevelsOf48[] = {{.size = 4, .data = 8, .stride = 4, .capacity = 9}};
constexpr std::array<BoundedLevels, 1> kColumnLevels = {kLevelsOf48};
constexpr unsigned kRows = 4;

/// Holds both queues, in the order in which each process makes them.
struct Queues {
  explicit Queues(Arena arena)
      : commands(kCommands, arena), events(kEvents, rt::Producers::One, arena) {}
  rt::Mailbox commands;
  rt::EventQueue events;
};

std::shared_ptr<MemoryBlock> blockForQueues() {
  Arena asked = Arena::measuring();
  rt::Mailbox commands(kCommands, asked);
  rt::EventQueue events(kEvents, rt::Producers::One, asked);
  return std::make_shared<MemoryBlock>("fuzz", asked.used());
}

/// Requires that what was handed out is all there, and does not change with the memory.
class Held {
 public:
  template <class Record>
  Held(const Record* record, std::size_t behind)
      : bytes_(reinterpret_cast<const std::byte*>(record)),
        copy_(bytes_, bytes_ + sizeof(Record) + behind) {}
  void requireUnchanged() const { require(std::equal(copy_.begin(), copy_.end(), bytes_)); }

 private:
  const std::byte* const bytes_;
  const std::vector<std::byte> copy_;
};

class Processes {
 public:
  explicit Processes(Input& input) : input_(input) {}

  void step() {
    switch (input_.byte() % 8) {
      case 0: return send();
      case 1: return emit();
      case 2: return publish();
      case 3: return scribble(*shared_);
      case 4: return scribble(*table_.memory());
      case 5: return takeCommands();
      case 6: return takeEvents();
      case 7: return readRows();
    }
  }

 private:
  // ---- the other process

  void send() {
    const auto command = static_cast<std::uint16_t>(input_.byte() % kCommands.size());
    const auto slot =
        other_.commands.claim(command, now(), static_cast<std::uint32_t>(input_.byte()));
    if (!slot) return;
    std::memset(*slot, static_cast<int>(input_.byte()), kCommands[command].argumentsSize);
    other_.commands.commit();
  }
  void emit() {
    const auto event = static_cast<std::uint16_t>(input_.byte() % kEvents.size());
    const std::vector<std::byte> payload(kEvents[event].payloadSize,
                                         static_cast<std::byte>(input_.byte()));
    other_.events.push(event, now(), payload);
  }
  void publish() {
    std::memset(table_.draft(0), static_cast<int>(input_.byte()), kColumns[0]);
    const std::uint64_t valid = input_.byte(), tooLarge = input_.byte();
    table_.publish(now(), {.valid = valid, .tooLarge = tooLarge});
  }
  /// Writes, more often than chance would, a value that means something to a reader.
  void scribble(const MemoryBlock& block) {
    const std::uint64_t values[] = {
        0, 1, 7, ~std::uint64_t{0}, std::uint64_t{1} << 63, input_.eight()};
    const std::uint64_t value = values[input_.byte() % std::size(values)];
    std::memcpy(block.data() + input_.two() % (block.size() / 8) * 8, &value, sizeof value);
  }
  void scribbleAll() {
    std::memset(shared_->data(), static_cast<int>(input_.byte()), shared_->size());
  }

  // ---- this one

  void takeCommands() {
    own_.commands.fixCut();
    std::size_t count = 0;
    while (const rt::CommandRecord* const record = own_.commands.next()) {
      require(record->command < kCommands.size() && record->stamp <= now() && ++count <= 16);
      const Held whole(record, kCommands[record->command].argumentsSize);
      if (input_.byte() % 16 == 1) scribbleAll();
      whole.requireUnchanged();
      own_.commands.pop();
    }
  }
  void takeEvents() {
    for (std::size_t count = 0; count < 64; ++count) {
      const rt::EventRecord* const record = own_.events.next();
      if (record == nullptr) return;
      require(record->event < kEvents.size() && record->stamp <= now());
      const Held whole(record, kEvents[record->event].payloadSize);
      if (input_.byte() % 16 == 1) scribbleAll();
      whole.requireUnchanged();
      own_.events.pop();
    }
  }
  void readRows() {
    std::vector<std::byte> first(kColumns[0]), second(kColumns[1]);
    const std::array<std::byte*, 2> slots = {first.data(), second.data()};
    (void)reader_.readRow(slots);
    (void)reader_.readRowAt(now(), slots);
    (void)reader_.readRowNumber(input_.eight(), slots);
    (void)reader_.read(static_cast<unsigned>(input_.byte() % 2), first.data());
    (void)reader_.readAt(fromNanoseconds(static_cast<std::int64_t>(input_.eight())), 0,
                         first.data());
  }

  Input& input_;
  const std::shared_ptr<MemoryBlock> shared_ = blockForQueues();
  Queues other_{Arena(shared_, Arena::Content::Zeros)}, own_{Arena(shared_, Arena::Content::Made)};
  rt::StateTable table_{kColumns, kRows, 0, rt::StateTable::Readers::Elsewhere, kColumnLevels};
  rt::StateTable reader_{kColumns, kRows, table_.memory(),
                         std::make_shared<std::atomic<rt::ColumnSet>>(), kColumnLevels};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  Processes processes(input);
  while (!input.ended()) processes.step();
  return 0;
}
