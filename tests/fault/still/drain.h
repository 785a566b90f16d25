#pragma once
// This stops a provider in the middle of a drain.

#include <gtest/gtest.h>

#include <algorithm>

#include "fault/history/history_caller.h"
#include "fault/system.h"

namespace suture {

/// The provider's latest command is the one that tells that it runs, and those behind it wait.
inline bool standsInADrain(const System& system) {
  const auto executed = system.providersHistory();
  if (executed.empty() || executed.back().id % HistoryCaller::kBurst != 2) return false;
  const std::uint64_t last = executed.back().id + HistoryCaller::kBurst - 2;
  const auto sent = system.clientsHistory();
  return std::any_of(sent.begin(), sent.end(), [last](const HistoryEntry& entry) {
    return entry.kind == HistoryEntry::Kind::Sent && entry.id == last;
  });
}

/// Lets the system's latest provider stand still (SIGSTOP) while it drains what a client in the
/// mode "bursts" has sent. A command may have ended by the time that the test hears that it runs.
inline void stopInADrain(const System& system, Child& provider) {
  do {
    provider.signal(SIGCONT);
    ASSERT_EQ(provider.line(), reference::kTellsThatItRuns);
    provider.signal(SIGSTOP);
  } while (!standsInADrain(system));
}

}  // namespace suture
