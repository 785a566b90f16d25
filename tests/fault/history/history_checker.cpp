#include <map>
#include <utility>

#include "fault/history/history.h"

namespace suture {
namespace {

using Kind = HistoryEntry::Kind;

// runtime/suture/base/errors.h says which.
bool saysNotExecuted(Errc error) {
  switch (error) {
    case Errc::NotConnected:
    case Errc::Lost:
    case Errc::Full:
    case Errc::TooLarge:
    case Errc::Late:
    case Errc::Superseded:
    case Errc::Invalid:
    case Errc::TooManyCalls:
    case Errc::NotImplemented:
    case Errc::Suspended:
    case Errc::AwaitingOperator:
    case Errc::OnLoan:
    case Errc::Cancelled: return true;
    default: return false;
  }
}

std::string milliseconds(Duration duration) {
  return std::to_string(std::chrono::duration<double, std::milli>(duration).count()) + " ms";
}

class Checker {
 public:
  explicit Checker(const Tolerance& tolerance) : tolerance_(tolerance) {}

  void take(const HistoryEntry& entry) {
    switch (entry.kind) {
      case Kind::Sent: sent(entry); break;
      case Kind::Ended: ended(entry); break;
      case Kind::Executed: executed(entry); break;
      case Kind::Heard: heard(entry); break;
      case Kind::Killed: killed_[entry.client] = entry.at; break;
      case Kind::Connected: break;
      case Kind::Counted: counted_[entry.client] = entry; break;
      case Kind::Served: served_[{entry.client, entry.sums.process}] = entry; break;
      case Kind::Awaits: awaits_[entry.client] = true; break;
      case Kind::Resumed: awaits_[entry.client] = false; break;
      case Kind::Told: told_.try_emplace({entry.client, entry.epoch}, entry.at); break;
    }
  }

  std::vector<std::string> finish() {
    for (const auto& [which, command] : commands_) {
      if (command.executions > 0 && command.isEnded && saysNotExecuted(command.error)) {
        say(which,
            "was executed, and its sender was told: " + std::string(toString(command.error)));
      }
      if (command.awaitsOperator && command.isEnded && !saysNotExecuted(command.error)) {
        say(which, "was let through while its operator was awaited");
      }
      requireEnd(which, command);
      forbidExecutionAfterLoss(which, command);
    }
    for (const auto& [client, ledger] : counted_) compareWith(ledger);
    for (const auto& [which, ledger] : served_) requireExecutions(ledger);
    return std::move(found_);
  }

 private:
  using Key = std::pair<std::uint32_t, std::uint64_t>;
  struct Command {
    HistoryEntry sent;
    bool isEnded = false;
    bool awaitsOperator = false;  // its client did when it was sent
    Errc error{};
    int executions = 0;
    Time lastExecuted{};
    std::uint64_t epoch = 0;  // its connection
  };

  static Key key(const HistoryEntry& entry) { return {entry.client, entry.id}; }

  void say(const Key& which, const std::string& what) {
    found_.push_back("command " + std::to_string(which.second) + " of client " +
                     std::to_string(which.first) + " " + what);
  }

  void requireEnd(const Key& which, const Command& command) {
    const Duration limit = command.sent.limit;
    if (limit == Duration{0} || command.isEnded) return;
    const auto end = killed_.find(which.first);
    const Time latest = command.sent.at + limit + tolerance_.lateness;
    if (end == killed_.end() || end->second > latest) say(which, "never ended");
  }

  void forbidExecutionAfterLoss(const Key& which, const Command& command) {
    const auto told = told_.find({which.first, command.epoch});
    if (told == told_.end() || command.lastExecuted <= told->second + tolerance_.unheard) return;
    if (++afterLoss_[told->first] <= tolerance_.justJudged) return;
    say(which, "was executed " + milliseconds(command.lastExecuted - told->second) +
                   " after its sender was told that connection " + std::to_string(command.epoch) +
                   " is lost");
  }

  void compareWith(const HistoryEntry& ledger) {
    std::uint64_t executed = ledger.id;
    for (const auto& [which, command] : commands_) {
      if (which.first == ledger.client) executed += static_cast<unsigned>(command.executions);
    }
    const HistorySums& sums = ledger.sums;
    const std::uint64_t possible = sums.unknown + sums.underWay;
    const std::string owner = "the ledger of client " + std::to_string(ledger.client);
    requireBalance(owner, sums);
    if (executed < sums.executed || executed > sums.executed + possible) {
      found_.push_back(owner + " says that " + std::to_string(sums.executed) +
                       " commands were executed, and " + std::to_string(possible) +
                       " may have been; " + std::to_string(executed) + " were");
    }
    const auto served = served_.find({ledger.client, sums.other});
    if (served == served_.end() || served->second.sums.other != sums.process) return;
    const HistorySums& provider = served->second.sums;
    if (sums.heard <= provider.executed + provider.others) return;
    found_.push_back(owner + " has heard of " + std::to_string(sums.heard) +
                     " outcomes, and its provider has counted " +
                     std::to_string(provider.executed + provider.others));
  }

  void requireExecutions(const HistoryEntry& ledger) {
    const std::string owner = "the provider's ledger of client " + std::to_string(ledger.client);
    requireBalance(owner, ledger.sums);
    if (ledger.sums.executed == ledger.id) return;
    found_.push_back(owner + " says that " + std::to_string(ledger.sums.executed) +
                     " commands were executed; " + std::to_string(ledger.id) + " were");
  }

  void requireBalance(const std::string& owner, const HistorySums& sums) {
    const std::uint64_t places =
        sums.executed + sums.others + sums.lost + sums.unknown + sums.underWay;
    if (places == sums.accepted) return;
    found_.push_back(owner + " has places for " + std::to_string(places) + " of " +
                     std::to_string(sums.accepted) + " commands");
  }

  void sent(const HistoryEntry& entry) {
    Command& command = commands_[key(entry)];
    command.sent = entry;
    command.awaitsOperator = awaits_[entry.client];
    command.epoch = entry.epoch;
  }

  void ended(const HistoryEntry& entry) {
    Command& command = commands_[key(entry)];
    command.isEnded = true;
    command.error = entry.error;
    command.epoch = entry.epoch;  // a new connection may have come just before it was sent
    const Duration limit = command.sent.limit, took = entry.at - command.sent.at;
    if (limit != Duration{0} && took > limit + tolerance_.lateness) {
      say(key(entry),
          "ended after " + milliseconds(took) + ", its deadline is " + milliseconds(limit));
    }
  }

  void executed(const HistoryEntry& entry) {
    Command& command = commands_[key(entry)];
    if (command.sent.at == Time{}) return say(key(entry), "was executed, and nobody sent it");
    if (++command.executions > 1) say(key(entry), "was executed twice");
    command.lastExecuted = entry.at;
    if (entry.limit != Duration{0} && entry.age > entry.limit) {
      say(key(entry), "was executed " + milliseconds(entry.age) + " old, its ttl is " +
                          milliseconds(entry.limit));
    }
    HistoryEntry& newest = newest_[entry.client];
    if (entry.epoch < newest.epoch) {
      say(key(entry), "of connection " + std::to_string(entry.epoch) +
                          " was executed after one of connection " + std::to_string(newest.epoch));
    } else if (entry.id < newest.id) {
      say(key(entry), "was executed after command " + std::to_string(newest.id));
    } else {
      newest = entry;
    }
  }

  void heard(const HistoryEntry& entry) {
    const auto [newest, first] = heard_.try_emplace(entry.client, entry);
    if (first) return;
    HistoryEntry& before = newest->second;
    const auto number = [](const HistoryEntry& one) {
      return std::to_string(one.id) + " of provider " + std::to_string(one.epoch);
    };
    if (std::pair(entry.epoch, entry.id) <= std::pair(before.epoch, before.id)) {
      found_.push_back("client " + std::to_string(entry.client) + " heard event " + number(entry) +
                       " after " + number(before));
    } else {
      before = entry;
    }
  }

  const Tolerance tolerance_;
  std::map<Key, Command> commands_;
  std::map<std::uint32_t, HistoryEntry> newest_;   // executed, by client
  std::map<std::uint32_t, HistoryEntry> heard_;    // the newest, by client
  std::map<std::uint32_t, HistoryEntry> counted_;  // the last word, by client
  // This is the last word of providers, by client and incarnation.
  std::map<std::pair<std::uint32_t, std::uint64_t>, HistoryEntry> served_;
  std::map<std::uint32_t, Time> killed_;
  std::map<std::uint32_t, bool> awaits_;                              // by client
  std::map<std::pair<std::uint32_t, std::uint64_t>, Time> told_;      // by client and connection
  std::map<std::pair<std::uint32_t, std::uint64_t>, int> afterLoss_;  // commands, likewise
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> violations(const std::vector<HistoryEntry>& history,
                                    const Tolerance& tolerance) {
  Checker checker(tolerance);
  for (const HistoryEntry& entry : history) checker.take(entry);
  return checker.finish();
}

}  // namespace suture
