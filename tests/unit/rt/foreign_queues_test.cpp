// These are mailboxes and queues of events between two processes.
#include <suture/base/errors.h>
#include <suture/rt/queue/event_queue.h>
#include <suture/rt/queue/mailbox.h>

#include <array>
#include <vector>

#include "foreign_queue.h"

namespace suture::rt::foreign_queues {
namespace {

using foreign_memory::Shared;
using foreign_memory::survivesAnything;

/// Describes a list of bytes, behind 4 bytes and with 4 behind it.
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

TEST(ForeignMailbox, CopiesTheUsedPartOfLargeLists) {
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

TEST(ForeignMailbox, SurvivesWhateverItsMemoryHolds) {
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
          EXPECT_LE(mailbox.producer->room(0), kCommands[0].depth);
          send(*mailbox.producer, 0, 1);
        }
      },
      std::span<const CommandLimits>{kCommands});
}

// This producer says that it has sent without end, and sends while it is drained.
TEST(ForeignMailbox, ADrainEndsBeforeItsProducer) {
  Shared<Mailbox> mailbox(std::span<const CommandLimits>{kCommands});
  send(*mailbox.producer, 0, 0);
  mailbox.consumer->fixCut();
  int taken = 0;
  while (mailbox.consumer->next() != nullptr) {
    mailbox.consumer->pop();
    mailbox.consumer->returnCredit(0);
    const Result<std::byte*> arguments = mailbox.producer->claim(0, now(), 0);
    ASSERT_TRUE(arguments);
    // The other process makes it look as if it had been sent before the cut.
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

TEST(ForeignEventQueue, CopiesTheUsedPartOfLargeLists) {
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

TEST(ForeignEventQueue, SurvivesWhateverItsMemoryHolds) {
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

}  // namespace
}  // namespace suture::rt::foreign_queues
