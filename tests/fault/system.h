#pragma once
// These are a manager, a provider and a client, each a process of its own, whose histories are
// checked.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fault/history/history.h"
#include "paths.h"
#include "support/child.h"
#include "support/eventually.h"
#include "support/temporary_directory.h"

namespace suture {

/// This run draws everything from it; SUTURE_FAULT_SEED replays one.
inline unsigned faultSeed() {
  const char* asked = std::getenv("SUTURE_FAULT_SEED");
  static const unsigned kSeed =
      asked == nullptr ? std::random_device()() : static_cast<unsigned>(std::atoi(asked));
  return kSeed;
}

/// SUTURE_FAULT_ROUNDS says how often each fault strikes in each test.
inline int faultRounds() {
  const char* asked = std::getenv("SUTURE_FAULT_ROUNDS");
  return asked == nullptr ? 1 : std::atoi(asked);
}

/// A machine that does something else may add so much to the time that a call takes.
inline constexpr Duration kBusyMachine = std::chrono::seconds(2);

/// Fails for each rule that is broken, by processes that the machine may hold up at any moment.
inline void expectSoundHistory(const std::vector<HistoryEntry>& history,
                               Tolerance tolerance = {.lateness = kBusyMachine}) {
  tolerance.justJudged = 1;
  for (const std::string& one : violations(history, tolerance)) ADD_FAILURE() << one;
}

class System {
 public:
  using Arguments = std::vector<std::string>;
  using Prepare = std::function<void()>;  ///< runs in a child before the program

  /// `address`: where provider and client look for the manager; "": a Unix socket of the test's.
  explicit System(std::string address = "")
      : address_(address.empty() ? "unix:" + file("m.sock") : std::move(address)) {}

  std::unique_ptr<Child> manager(const Prepare& prepare = {}) {
    return managerAt(address(), prepare);
  }
  std::unique_ptr<Child> managerAt(const std::string& address, const Prepare& prepare = {}) {
    auto child =
        std::make_unique<Child>(Arguments{paths::kSutureManager, "--listen", address}, prepare);
    EXPECT_EQ(child->line(), "suture-manager: ready on " + address);
    return child;
  }
  /// `name` is what it registers as, and `more` has arguments of history_provider.
  std::unique_ptr<Child> provider(const std::string& name = "robot", const Prepare& prepare = {},
                                  const Arguments& more = {}) {
    ++providers_;
    Arguments all{paths::kHistoryProvider, address(), name, newLog("p", providers_),
                  std::to_string(providers_)};
    all.insert(all.end(), more.begin(), more.end());
    return std::make_unique<Child>(all, prepare);
  }
  std::unique_ptr<Child> client(const char* mode, int silenceMilliseconds = 500,
                                const std::string& lane = "auto", const Prepare& prepare = {}) {
    ++clients_;
    return std::make_unique<Child>(
        Arguments{paths::kHistoryClient, address(), "client" + std::to_string(clients_),
                  newLog("c", clients_), std::to_string(clients_), "robot", mode,
                  std::to_string(silenceMilliseconds), lane},
        prepare);
  }

  const std::string& address() const { return address_; }
  /// Returns a path in the folder of this system.
  std::string file(const std::string& name) const { return directory_.file(name); }
  /// Returns where a process of that name listens.
  std::string socketOf(const std::string& name, const Child& child) const {
    return directory_.file(name + "." + std::to_string(child.pid()) + ".sock");
  }
  std::vector<HistoryEntry> history() const {
    auto all = readHistory(logs_);
    all.insert(all.end(), killed_.begin(), killed_.end());
    return all;
  }
  /// The latest client has been killed by now.
  void noteKilledClient() {
    killed_.push_back({.kind = HistoryEntry::Kind::Killed,
                       .at = now(),
                       .client = static_cast<std::uint32_t>(clients_)});
  }
  /// Reads what the latest client has written down.
  std::vector<HistoryEntry> clientsHistory() const {
    return readHistory({directory_.file("c" + std::to_string(clients_))});
  }

  /// Reads what the latest provider has written down.
  std::vector<HistoryEntry> providersHistory() const {
    return readHistory({directory_.file("p" + std::to_string(providers_))});
  }

  /// Returns how much the latest client has written down, in bytes, so that no test has to read it.
  std::uintmax_t clientsHistorySize() const {
    return std::filesystem::file_size(directory_.file("c" + std::to_string(clients_)));
  }

  /// Returns true once the latest client has, from now on, been heard and answered; if it is idle,
  /// once it has heard something.
  bool works(bool busy) const {
    const Time asked = now();
    return clientNotes(asked, HistoryEntry::Kind::Heard) &&
           (!busy || eventually([&] { return answered(asked); }));
  }
  /// Returns true once the latest client has written down something of that kind since then.
  bool clientNotes(Time since, HistoryEntry::Kind kind) const {
    return eventually([&] { return clientHasNoted(since, kind); });
  }
  /// Returns true once the latest client has no connection: it has been told that the last one is
  /// lost.
  bool clientIsCutOff() const {
    return eventually([&] {
      auto last = HistoryEntry::Kind::Told;
      for (const HistoryEntry& entry : clientsHistory()) {
        const bool tells =
            entry.kind == HistoryEntry::Kind::Connected || entry.kind == HistoryEntry::Kind::Told;
        if (tells) last = entry.kind;
      }
      return last == HistoryEntry::Kind::Told;
    });
  }
  bool clientHasNoted(Time since, HistoryEntry::Kind kind) const {
    return has(clientsHistory(), since,
               [kind](const HistoryEntry& entry) { return entry.kind == kind; });
  }
  /// A call of the latest client has been answered since then.
  bool answered(Time since) const { return callEnded(since, Errc{}); }
  /// A call of the latest client has ended so since then.
  bool callEnded(Time since, Errc error) const {
    return has(clientsHistory(), since, [error](const HistoryEntry& entry) {
      return entry.kind == HistoryEntry::Kind::Ended && entry.error == error &&
             entry.limit != Duration{0};
    });
  }
  /// Returns true if the latest client and the latest provider have written down what they counted.
  bool haveReported() const {
    const auto reported = [](const std::vector<HistoryEntry>& history, HistoryEntry::Kind kind) {
      return has(history, Time{}, [kind](const HistoryEntry& one) { return one.kind == kind; });
    };
    return reported(clientsHistory(), HistoryEntry::Kind::Counted) &&
           reported(providersHistory(), HistoryEntry::Kind::Served);
  }
  /// Clients have been connected over these, by their names.
  using Lanes = std::set<std::string>;
  Lanes lanes() const {
    Lanes lanes;
    for (const HistoryEntry& entry : history()) {
      if (entry.kind == HistoryEntry::Kind::Connected) lanes.insert(entry.lane);
    }
    return lanes;
  }

 private:
  template <class Wanted>
  static bool has(const std::vector<HistoryEntry>& history, Time since, const Wanted& wanted) {
    return std::any_of(history.begin(), history.end(), [&](const HistoryEntry& entry) {
      return entry.at >= since && wanted(entry);
    });
  }
  std::string newLog(const char* prefix, int number) {
    logs_.push_back(directory_.file(prefix + std::to_string(number)));
    std::ofstream created(logs_.back());
    return logs_.back();
  }

  const TemporaryDirectory directory_;
  const std::string address_;
  std::vector<std::string> logs_;
  std::vector<HistoryEntry> killed_;
  int providers_ = 0, clients_ = 0;
};

}  // namespace suture
