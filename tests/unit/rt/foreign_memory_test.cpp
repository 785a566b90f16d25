// Queues between two processes, whose other end may write anything at any time.
#include <gtest/gtest.h>
#include <suture/base/arena.h>
#include <suture/base/errors.h>
#include <suture/rt/queue/event_queue.h>
#include <suture/rt/queue/latest_cell.h>
#include <suture/rt/queue/mailbox.h>
#include <suture/rt/queue/mpsc_ring.h>
#include <suture/rt/queue/spsc_ring.h>
#include <suture/rt/state/state_table.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

namespace suture::rt::foreign_memory {
namespace {

constexpr std::size_t kBytes = 1u << 16;

/// One block, and what each of two processes makes of it.
template <class Queue>
class Shared {
 public:
  template <class... Arguments>
  explicit Shared(const Arguments&... arguments) {
    Arena here(block, Arena::Content::Zeros), there(block, Arena::Content::Made);
    producer = std::make_unique<Queue>(arguments..., here);
    consumer = std::make_unique<Queue>(arguments..., there);
    used = here.used();
  }

  std::span<std::byte> bytes() { return {block->data(), used}; }

  std::shared_ptr<MemoryBlock> block = std::make_shared<MemoryBlock>("test", kBytes);
  std::unique_ptr<Queue> producer, consumer;
  std::size_t used = 0;
};

void put(SpscRing& ring, std::uint64_t value) {
  std::byte* const memory = ring.claim(sizeof(value));
  ASSERT_NE(memory, nullptr);
  std::memcpy(memory, &value, sizeof(value));
  ring.commit();
}

std::uint64_t valueAt(const std::byte* memory) {
  std::uint64_t value;
  std::memcpy(&value, memory, sizeof(value));
  return value;
}

TEST(Arena, CountsWhatABlockHasToHave) {
  Arena asked = Arena::measuring();
  const SpscRing ring(256, 8, asked);
  Arena block(std::make_shared<MemoryBlock>("test", asked.used()), Arena::Content::Zeros);
  const SpscRing other(256, 8, block);
  EXPECT_EQ(block.used(), asked.used());
  EXPECT_THROW(block.take(1), SetupError);
}

TEST(Arena, MeasuresWithoutTouchingWhatItMeasures) {
  constexpr std::size_t kCells = 1 << 14;
  const auto faults = [] {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_minflt;
  };
  const auto before = faults();
  Arena asked = Arena::measuring();
  const MpscRing cells(kCells, 1024, asked);
  EXPECT_GT(asked.used(), kCells * 1024);
  EXPECT_LT(faults() - before, 100);  // it has 4,096 pages at least
}

TEST(ForeignSpscRing, CarriesRecordsRoundAndRound) {
  Shared<SpscRing> ring(std::size_t{100}, std::size_t{8});
  for (std::uint64_t i = 0; i < 1000; ++i) {
    put(*ring.producer, i);
    const std::byte* const front = ring.consumer->front();
    ASSERT_NE(front, nullptr);
    EXPECT_EQ(front, ring.consumer->front());  // until pop()
    EXPECT_EQ(valueAt(front), i);
    EXPECT_EQ(ring.consumer->frontSize(), sizeof(i));
    ring.consumer->pop();
    EXPECT_EQ(ring.consumer->front(), nullptr);
  }
}

TEST(ForeignSpscRing, AFrontIsACopy) {
  Shared<SpscRing> ring(std::size_t{100}, std::size_t{8});
  put(*ring.producer, 7);
  const std::byte* const front = ring.consumer->front();
  std::ranges::fill(ring.bytes(), std::byte{0xff});
  EXPECT_EQ(valueAt(front), 7u);
  ring.consumer->pop();
}

TEST(ForeignSpscRing, AProducerBelievesNobodysPositionsButItsOwn) {
  Shared<SpscRing> ring(std::size_t{100}, std::size_t{8});
  put(*ring.producer, 1);
  std::ranges::fill(ring.bytes().first(128), std::byte{0xee});  // both positions
  for (int i = 0; i < 100; ++i) {
    std::byte* const memory = ring.producer->claim(8);
    if (memory == nullptr) break;
    EXPECT_GE(memory, ring.block->data());
    EXPECT_LE(memory + 8, ring.block->data() + ring.used);
    ring.producer->commit();
  }
}

// Whatever lies there: each read stays within the copy and every loop ends.
template <class Queue, class Use, class... Arguments>
void survivesAnything(const Use& use, const Arguments&... arguments) {
  std::mt19937_64 random(20260722);
  for (int round = 0; round < 2000; ++round) {
    Shared<Queue> queue(arguments...);
    use(queue, [&] {
      const auto bytes = queue.bytes();
      const int writes = 1 + static_cast<int>(random() % 8);
      for (int i = 0; i < writes; ++i) {
        const std::uint64_t values[] = {0,          1,          0xff,     ~std::uint64_t{0},
                                        1ull << 63, 0xdeadbeef, random(), random() % 512};
        const std::uint64_t value = values[random() % std::size(values)];
        const std::size_t at = random() % (bytes.size() / 8) * 8;
        std::memcpy(bytes.data() + (random() % 3 == 0 ? at % 256 : at), &value, 8);
      }
    });
  }
}

TEST(ForeignSpscRing, SurvivesAnything) {
  survivesAnything<SpscRing>(
      [](Shared<SpscRing>& ring, const auto& scramble) {
        for (std::uint64_t i = 0; i < 5; ++i) put(*ring.producer, i);
        scramble();
        for (int i = 0; i < 100; ++i) {
          const std::byte* const front = ring.consumer->front();
          if (front == nullptr) break;
          EXPECT_LE(ring.consumer->frontSize(), 8u);
          std::vector<std::byte> copy(front, front + ring.consumer->frontSize());
          ring.consumer->pop();
        }
      },
      std::size_t{200}, std::size_t{8});
}

TEST(ForeignMpscRing, SurvivesAnything) {
  survivesAnything<MpscRing>(
      [](Shared<MpscRing>& ring, const auto& scramble) {
        for (int i = 0; i < 3; ++i) ring.producer->commit(ring.producer->claim());
        scramble();
        for (int i = 0; i < 20; ++i) {
          if (std::byte* const cell = ring.producer->claim()) ring.producer->commit(cell);
          if (ring.consumer->front() != nullptr) ring.consumer->pop();
        }
      },
      std::size_t{8}, std::size_t{24});
}

TEST(ForeignLatestCell, SurvivesAnything) {
  survivesAnything<LatestCell>(
      [](Shared<LatestCell>& cell, const auto& scramble) {
        for (int i = 0; i < 10; ++i) {
          std::memset(cell.producer->claim(), i, 40);
          cell.producer->commit();
          scramble();
          if (cell.consumer->take()) {
            std::vector<std::byte> copy(cell.consumer->front(), cell.consumer->front() + 40);
          }
        }
      },
      std::size_t{40});
}

/// A list of bytes, behind 4 bytes and with 4 behind it.
constexpr BoundedLevel listOf(std::uint32_t capacity) {
  return {.size = 4, .data = 8, .stride = 1, .capacity = capacity};
}
constexpr BoundedLevel kList48[] = {listOf(48)}, kList12[] = {listOf(12)}, kList28[] = {listOf(28)};

const std::array<CommandLimits, 3> kCommands = {
    CommandLimits{.argumentsSize = 8, .depth = 4, .latest = false},
    CommandLimits{.argumentsSize = 60, .depth = 4, .latest = true, .levels = kList48},
    CommandLimits{.argumentsSize = 24, .depth = 2, .latest = false, .levels = kList12}};

void send(Mailbox& mailbox, std::uint16_t command, std::uint8_t byte) {
  const Result<std::byte*> arguments = mailbox.claim(command, now(), 0);
  if (!arguments) return;
  std::memset(*arguments, byte, kCommands[command].argumentsSize);
  mailbox.commit();
}

TEST(ForeignMailbox, KeepsOrderAndCredits) {
  Shared<Mailbox> mailbox(std::span<const CommandLimits>{kCommands});
  for (std::uint8_t lap = 0; lap < 50; ++lap) {
    send(*mailbox.producer, 0, lap);
    send(*mailbox.producer, 1, lap);
    send(*mailbox.producer, 2, lap);
    EXPECT_TRUE(mailbox.consumer->pending());
    mailbox.consumer->fixCut();
    for (std::uint16_t expected : {0, 1, 2}) {
      const CommandRecord* const record = mailbox.consumer->next();
      ASSERT_NE(record, nullptr);
      EXPECT_EQ(record->command, expected);
      EXPECT_EQ(record->arguments()[0], std::byte{lap});
      mailbox.consumer->pop();
      if (expected != 1) mailbox.consumer->returnCredit(expected);
    }
    EXPECT_EQ(mailbox.consumer->next(), nullptr);
    EXPECT_EQ(mailbox.producer->waiting(0), 0u);
  }
}

/// `used` of the bytes, and nothing else, are those of the list.
void expectUsed(const std::byte* slot, std::size_t size, std::uint32_t used) {
  for (std::size_t i = 0; i < size; ++i) {
    if (i >= 4 && i < 8) continue;  // how many they are
    const bool copied = i < 8 + used || i >= size - 4;
    EXPECT_EQ(slot[i], copied ? std::byte{0xee} : std::byte{0}) << i << " of " << size;
  }
}

TEST(ForeignMailbox, CopiesWhatIsUsedOfALargeList) {
  Shared<Mailbox> mailbox(std::span<const CommandLimits>{kCommands});
  for (const std::uint16_t command : {1, 2}) {
    const std::uint32_t used = 5;
    std::byte* const arguments = *mailbox.producer->claim(command, now(), 0);
    std::memset(arguments, 0xee, kCommands[command].argumentsSize);
    std::memcpy(arguments + 4, &used, sizeof(used));
    mailbox.producer->commit();
    mailbox.consumer->fixCut();
    const CommandRecord* const record = mailbox.consumer->next();
    ASSERT_NE(record, nullptr);
    expectUsed(record->arguments(), kCommands[command].argumentsSize, used);
    mailbox.consumer->pop();
  }
}

TEST(ForeignMailbox, SurvivesAnything) {
  survivesAnything<Mailbox>(
      [](Shared<Mailbox>& mailbox, const auto& scramble) {
        for (std::uint8_t i = 0; i < 4; ++i) send(*mailbox.producer, i % 3, i);
        scramble();
        for (int drain = 0; drain < 4; ++drain) {
          mailbox.consumer->fixCut();
          int taken = 0;
          while (const CommandRecord* const record = mailbox.consumer->next()) {
            ASSERT_LT(record->command, kCommands.size());
            EXPECT_GE(record->stamp, Time{});
            EXPECT_LE(record->stamp, now());
            const auto size = kCommands[record->command].argumentsSize;
            std::vector<std::byte> copy(record->arguments(), record->arguments() + size);
            const std::uint16_t command = record->command;
            mailbox.consumer->pop();
            mailbox.consumer->returnCredit(command);
            ASSERT_LE(++taken, 11);  // as many as the credits allow
          }
          scramble();
          send(*mailbox.producer, 0, 1);
        }
      },
      std::span<const CommandLimits>{kCommands});
}

// A producer that says it has sent without end, and sends while it is drained.
TEST(ForeignMailbox, ADrainEndsThoughTheProducerDoesNot) {
  Shared<Mailbox> mailbox(std::span<const CommandLimits>{kCommands});
  send(*mailbox.producer, 0, 0);
  mailbox.consumer->fixCut();
  int taken = 0;
  while (mailbox.consumer->next() != nullptr) {
    mailbox.consumer->pop();
    mailbox.consumer->returnCredit(0);
    const Result<std::byte*> arguments = mailbox.producer->claim(0, now(), 0);
    ASSERT_TRUE(arguments);
    // As if it had been sent before the cut.
    reinterpret_cast<CommandRecord*>(*arguments - sizeof(CommandRecord))->sequence = 0;
    mailbox.producer->commit();
    ASSERT_LT(++taken, 100);
  }
}

constexpr std::uint32_t kLarge = EventRing::kMostShared + 88;
constexpr BoundedLevel kListOfLarge[] = {listOf(kLarge - 12)};
const std::array<EventLimits, 5> kEvents = {
    EventLimits{.payloadSize = 16, .depth = 4, .latest = false},
    EventLimits{.payloadSize = 40, .depth = 1, .latest = true, .levels = kList28},
    EventLimits{.payloadSize = 0, .depth = 2, .latest = false},
    EventLimits{.payloadSize = 24, .depth = 1, .latest = false, .latched = true, .levels = kList12},
    EventLimits{.payloadSize = kLarge, .depth = 2, .latest = false, .levels = kListOfLarge}};

TEST(ForeignEventQueue, CopiesWhatIsUsedOfALargeList) {
  Shared<EventQueue> queue(std::span<const EventLimits>{kEvents}, Producers::One);
  for (const std::uint16_t event : {1, 3, 4}) {
    const std::uint32_t used = 7;
    std::array<std::byte, kLarge> payload;
    payload.fill(std::byte{0xee});
    std::memcpy(&payload[4], &used, sizeof(used));
    queue.producer->push(event, now(), std::span(payload).first(kEvents[event].payloadSize));
    const EventRecord* const record = queue.consumer->next();
    ASSERT_NE(record, nullptr);
    expectUsed(record->payload(), kEvents[event].payloadSize, used);
    queue.consumer->pop();
  }
}

TEST(ForeignEventQueue, SurvivesAnything) {
  for (const Producers producers : {Producers::One, Producers::Any}) {
    survivesAnything<EventQueue>(
        [](Shared<EventQueue>& queue, const auto& scramble) {
          const std::array<std::byte, kLarge> payload{};
          for (int lap = 0; lap < 4; ++lap) {
            for (std::uint16_t event = 0; event < kEvents.size(); ++event) {
              queue.producer->push(event, now(),
                                   std::span(payload).first(kEvents[event].payloadSize));
            }
            scramble();
            for (std::size_t i = 0; i < 2 * queue.consumer->capacity(); ++i) {
              const EventRecord* const record = queue.consumer->next();
              if (record == nullptr) break;
              ASSERT_LT(record->event, kEvents.size());
              EXPECT_LE(record->stamp, now());
              const auto size = kEvents[record->event].payloadSize;
              std::vector<std::byte> copy(record->payload(), record->payload() + size);
              queue.consumer->pop();
            }
          }
        },
        std::span<const EventLimits>{kEvents}, producers);
  }
}

TEST(ForeignStateTable, IsReadInAnotherProcessAndAskedThere) {
  const std::array<std::uint32_t, 2> sizes = {8, 24};
  StateTable table(sizes, 4);
  const auto asked = std::make_shared<std::atomic<ColumnSet>>(0);
  StateTable view(sizes, 4,
                  MemoryBlock::open(table.memory()->descriptor(), StateTable::bytesFor(sizes, 4),
                                    MemoryBlock::Others::Read),
                  asked);
  EXPECT_TRUE(view.ask(1));
  EXPECT_EQ(*asked, 2u);
  std::array<std::byte, 24> slot{};
  EXPECT_EQ(view.read(1, slot.data()).error(), Errc::NotYet);
  for (int row = 1; row <= 10; ++row) {
    std::memset(table.draft(1), row, 24);
    const Time stamp = now();
    table.publish(stamp, {.valid = 2});
    EXPECT_EQ(view.read(1, slot.data()).value(), stamp);
    EXPECT_EQ(slot[23], static_cast<std::byte>(row));
  }
  EXPECT_EQ(view.rows(), 10u);
}

TEST(ForeignStateTable, CopiesWhatIsUsedOfALargeList) {
  const std::array<std::uint32_t, 2> sizes = {12, kLarge};
  const std::array<BoundedLevels, 2> levels = {BoundedLevels{}, kListOfLarge};
  StateTable table(sizes, 4, 0, StateTable::Readers::Elsewhere, levels);
  const StateTable view(sizes, 4, table.memory(), std::make_shared<std::atomic<ColumnSet>>(),
                        levels);
  constexpr std::uint32_t kFull = kLarge - 12;  // in each row, before there is less
  for (const std::uint32_t used : {kFull, kFull, kFull, kFull, 0u, 1u, 5u, kLarge / 2}) {
    std::memset(table.draft(0), 0xdd, sizes[0]);
    std::memset(table.draft(1), 0xee, kLarge);
    std::memcpy(table.draft(1) + 4, &used, sizeof(used));
    table.publish(now(), {.valid = 3});
    std::array<std::byte, 12> small{};
    std::array<std::byte, kLarge> large{};
    const std::array<std::byte*, 2> slots = {small.data(), large.data()};
    EXPECT_EQ(view.readRow(slots).valid, 3u);
    EXPECT_EQ(small[11], std::byte{0xdd});
    for (std::size_t i = 0; i < kLarge; ++i) {
      if (i >= 4 && i < 8) continue;  // how many they are
      const bool fixed = i < 8 || i >= kLarge - 4;
      if (fixed || i < 8 + used) {
        EXPECT_EQ(large[i], std::byte{0xee}) << i;
      } else if (i >= 16 + used && i < kLarge - 12) {  // beyond the words that it shares
        EXPECT_EQ(large[i], std::byte{0}) << i;
      }
    }
  }
}

// As many rows as there cannot be: the search for a time ends all the same.
TEST(ForeignStateTable, IsReadWhateverItsNumberOfRows) {
  const std::array<std::uint32_t, 1> columns = {8};
  StateTable provider(columns, 4);
  const StateTable client(columns, 4, provider.memory(),
                          std::make_shared<std::atomic<ColumnSet>>());
  std::uint64_t value = 0;
  const std::array<std::byte*, 1> slots = {reinterpret_cast<std::byte*>(&value)};
  for (const std::uint64_t rows : {~std::uint64_t{0}, ~std::uint64_t{0} - 1, StateTable::kMostRows,
                                   StateTable::kMostRows + 1, std::uint64_t{1} << 63}) {
    std::memcpy(provider.memory()->data(), &rows, sizeof(rows));
    EXPECT_TRUE(client.readRowAt(now(), slots).tooOld);
    EXPECT_EQ(client.readAt(now(), 0, slots[0]).error(), Errc::TooOld);
    EXPECT_EQ(client.readRow(slots).valid, 0u);
  }
}

TEST(ForeignStateTable, StampsHaveAnAge) {
  const std::array<std::uint32_t, 1> columns = {8};
  StateTable provider(columns, 4);
  const StateTable client(columns, 4, provider.memory(),
                          std::make_shared<std::atomic<ColumnSet>>());
  provider.publish(now(), {.valid = 1});
  std::vector<std::uint64_t> words(provider.memory()->size() / 8);
  std::memcpy(words.data(), provider.memory()->data(), words.size() * 8);
  for (std::uint64_t& word : words) {
    if (word > 1) word = std::uint64_t{1} << 63;  // the stamp is the only number beyond 1
  }
  std::memcpy(provider.memory()->data(), words.data(), words.size() * 8);
  const auto stamp = client.read(0, reinterpret_cast<std::byte*>(words.data()));
  ASSERT_TRUE(stamp);
  EXPECT_GE(*stamp, Time{});
}

TEST(MemoryBlock, OthersMayOnlyReadWhereItSaysSo) {
  const MemoryBlock readable("test", 4096, MemoryBlock::Others::Read);
  EXPECT_THROW(MemoryBlock::open(readable.descriptor(), 4096, MemoryBlock::Others::Write),
               SetupError);
  readable.data()[0] = std::byte{1};
  const auto other = MemoryBlock::open(readable.descriptor(), 4096, MemoryBlock::Others::Read);
  EXPECT_EQ(other->data()[0], std::byte{1});
}

TEST(MemoryBlock, OfAnotherProcessMustBeSealedAndLargeEnough) {
  const MemoryBlock small("test", 4096);
  EXPECT_THROW(MemoryBlock::open(small.descriptor(), 4097, MemoryBlock::Others::Read), SetupError);
  const int loose = memfd_create("test", MFD_ALLOW_SEALING);
  ASSERT_EQ(ftruncate(loose, 8192), 0);
  EXPECT_THROW(MemoryBlock::open(loose, 4096, MemoryBlock::Others::Read), SetupError);
  close(loose);
  EXPECT_THROW(MemoryBlock::open(0, 1, MemoryBlock::Others::Read), SetupError);
}

}  // namespace
}  // namespace suture::rt::foreign_memory
