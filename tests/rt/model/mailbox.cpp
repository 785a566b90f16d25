// The mailbox keeps its promises: what runs, runs in the order of sending, whichever of ring and
// cells it travelled in; nothing queued is lost; "full" is the truth.
#include <suture/rt/queue/mailbox.h>

#include "rt/model/scenarios.h"

namespace model {
namespace {

namespace rt = suture::rt;

constexpr std::uint16_t kServo = 0, kJoints = 1, kHold = 2;
constexpr rt::CommandLimits kCommands[] = {{8, 1, true}, {8, 1, true}, {8, 1, false}};

struct Connection {
  rt::Mailbox mailbox{kCommands};
  std::uint64_t sent = 0, queued = 0;
  std::uint64_t run = 0, runs = 0, queuedRun = 0;

  void send(std::uint16_t command) {
    const auto memory = mailbox.claim(command, suture::Time{}, 0);
    if (!memory) return;
    write(*memory, ++sent);
    mailbox.commit();
    queued += command == kHold ? 1 : 0;
    require(queued - queuedRun <= kCommands[kHold].depth, "more wait than the depth allows");
  }
  void drain() {
    mailbox.fixCut();
    while (const rt::CommandRecord* record = mailbox.next()) {
      const std::uint64_t serial = read(record->arguments());
      require(serial > run, "a command runs after one that was sent later");
      run = serial;
      ++runs;
      const bool wasQueued = record->command == kHold;
      mailbox.pop();
      if (!wasQueued) continue;
      ++queuedRun;
      mailbox.returnCredit(kHold);
    }
  }
  void finish() {
    drain();
    drain();
    require(run == sent, "the last command is lost");
    require(queuedRun == queued, "a queued command is lost");
    require(mailbox.waiting(kHold) == 0, "a credit is lost");
    const auto& counters = mailbox.counters;
    require(counters.superseded == 0, "a command was dropped though none had overtaken it");
    require(runs + counters.replaced + counters.overtaken == sent,
            "a command is not accounted for");
  }
};

}  // namespace

Run mailboxOrder() {
  const auto it = std::make_shared<Connection>();
  return {.threads = {[it] {
                        for (const auto command : {kServo, kHold, kJoints, kServo}) {
                          it->send(command);
                        }
                      },
                      [it] {
                        it->drain();
                        it->drain();
                      }},
          .atEnd = [it] { it->finish(); }};
}

Run mailboxCredits() {
  const auto it = std::make_shared<Connection>();
  return {.threads = {[it] {
                        for (int i = 0; i < 4; ++i) it->send(kHold);
                        require(it->queued >= 1, "a command was refused though it had a credit");
                      },
                      [it] {
                        for (int i = 0; i < 3; ++i) it->drain();
                      }},
          .atEnd = [it] {
            it->finish();
            it->send(kHold);
            require(it->sent > it->run, "refused though nothing waits");
          }};
}

// A producer that has found no room sleeps until it is rung, and the consumer until something is
// sent.
Run mailboxRoom() {
  struct Awaited : Connection {
    bool waits = false, rung = false;
    void drainIfRung() {
      if (!mailbox.pending()) return;
      drain();
      if (mailbox.pending()) return;  // another drain comes
      if (mailbox.roomAwaited().take(std::memory_order_acq_rel)) rung = true;
    }
  };
  const auto it = std::make_shared<Awaited>();
  return {.threads = {[it] {
                        for (int i = 0; i < 2; ++i) it->send(kHold);
                        it->waits = it->mailbox.room(kHold) == 0;
                      },
                      [it] {
                        for (int i = 0; i < 2; ++i) it->drainIfRung();
                      }},
          .atEnd = [it] {
            it->drainIfRung();
            require(!it->waits || it->rung, "it waits, there is room");
            it->finish();
          }};
}

}  // namespace model
