#pragma once
// This is an event-driven task that subscribes many times to one event, in a process of its own.

#include <suture/lane/lane.h>
#include <CLI/CLI.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace bench {

/// The flags of the values that count have this bit.
inline constexpr std::uint32_t kMeasured = 2;

struct SubscriberSetup {
  std::string process;  ///< the name of the subscriber's process
  std::string manager;
  suture::Lane lane = suture::Lane::Auto;
  std::size_t interfaces = 1;
  std::size_t samples = 0;  ///< it has room for
};

/// Adds the hidden subcommand: connects to "sender:Sender/Samples", keeps the age of each kMeasured
/// echo in its handler until it is told to end, then writes them, ns, std::int64_t.
void addSubscriberProcess(CLI::App& program);
/// Says how this program is called to be that process.
std::vector<std::string> subscriberProcessArguments(const SubscriberSetup& setup);

}  // namespace bench
