#pragma once
// These are the ways on which a client reaches its provider.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace suture {

struct Way {
  std::optional<Lane> lane;  ///< if there is none, both are in one process
  bool delayed = false;

  ConnectOptions options(const ConnectionContract& contract = {}) const {
    const std::chrono::milliseconds each(delayed ? 5 : 0);
    return {.lane = lane.value_or(Lane::Auto),
            .delay = {.commands = each, .answers = each},
            .contract = contract};
  }
  /// Returns what a report calls the lane of such a connection.
  std::string laneName() const {
    return std::string(lane ? toString(*lane) : "local") + (delayed ? "+delay" : "");
  }
  /// Returns it as a part of a test's name.
  std::string name() const {
    return std::string(lane ? toString(*lane) : "local") + (delayed ? "Delayed" : "");
  }
  friend std::ostream& operator<<(std::ostream& out, const Way& way) { return out << way.name(); }
};

/// Returns those between two processes, each without a delay and with one.
inline std::vector<Way> waysBetweenProcesses() {
  std::vector<Way> ways;
  for (const bool delayed : {false, true}) {
    for (const Lane& lane : {Lane::Shm, Lane::Frame, Lane::Rpc}) ways.push_back({lane, delayed});
  }
  return ways;
}

/// Returns all: also those within one process.
inline std::vector<Way> allWays() {
  std::vector<Way> ways = waysBetweenProcesses();
  for (const bool delayed : {false, true}) ways.push_back({std::nullopt, delayed});
  return ways;
}

/// Returns the channel of a manager's only provider; nullptr while it has none. A delay in the same
/// process has another channel, which is its client's.
inline std::shared_ptr<Channel> providersChannel(const Manager& manager) {
  for (auto& one : manager.channels()) {
    if (one->ends.components != ConnectionEnd::Client) return one;
  }
  return nullptr;
}

inline std::string nameOfWay(const testing::TestParamInfo<Way>& row) { return row.param.name(); }

}  // namespace suture
