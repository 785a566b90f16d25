#pragma once
// This is what the sessions with all peers share in the process that serves them.

#include <suture/lane/lanes.h>
#include <suture/loop/control_thread.h>
#include <suture/loop/milestone.h>
#include <suture/names/security.h>
#include <suture/net/refusals.h>
#include <suture/session/ledgers.h>
#include <suture/session/provider/limits/channel_memory.h>
#include <suture/session/provider/limits/shared_places.h>
#include <suture/session/provider/shared/awaited_sockets.h>
#include <suture/session/provider/shared/latest_connections.h>
#include <suture/session/provider/shared/served_channels.h>
#include <suture/session/service_threads.h>
#include <suture/wiring/directory.h>

#include <cstdint>
#include <utility>

namespace suture {

/// Says what a process serves its peers with. What it refers to outlives the sessions.
struct ServingProcess {
  loop::ControlThread& control;
  const Lanes& lanes;
  const Directory& directory;
  ServiceThreads& threads;
  std::uint64_t incarnation;
  Policy policy;
  framing::PeerBudget::Limits connectionMemory = Security::kConnectionMemory;
};

/// Belongs to the control thread except where noted.
struct SharedBySessions : ServingProcess {
  explicit SharedBySessions(ServingProcess process) : ServingProcess(std::move(process)) {}

  /// A session has one for each lane that needs it, and one for each connection of large values.
  /// All sessions of one peer leave half of them to others.
  static constexpr SharedPlaces::Limits kMostSecondSockets{.all = 1024, .ofOne = 512};

  loop::Milestone published{};  ///< what is not in the directory then does not exist
  Ledgers ledgers{ConnectionEnd::Provider};
  LatestConnections latest{};
  ChannelMemory memory{connectionMemory};
  ServedChannels channels{directory, ledgers};
  AwaitedSockets sockets{};
  SharedPlaces secondSockets{kMostSecondSockets};  ///< those that are awaited included
  net::Refusals refusals{directory.process()};     ///< any thread reads how many there were
};

}  // namespace suture
