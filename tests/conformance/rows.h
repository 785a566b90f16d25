#pragma once
// Says which lanes, providers and clients there are, and which of them a scenario meets.

#include <suture/lane/lane_kind.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace conformance {

enum class BaseLane { Local, Shm, Frame, Rpc, Added };

/// An AddedLane is a lane that the runtime does not have.
struct AddedLane {
  const char* name = nullptr;
  std::function<std::unique_ptr<suture::LaneKind>()> make;
};

/// It lies on the way of each message.
enum class Filter {
  None,
  Delay,
  Faults,  ///< delayed, and messages come twice or late, but none is lost
  // These are lossy: only the rules of a history hold.
  Loss,
  BurstLoss,
  Duplicates,
  Reordering,
};

/// Says by what the two processes reach each other.
enum class Transport { None, Unix, Tcp, Tls };

enum class ProviderKind { Periodic, EventDriven, Device };
enum class ClientKind { Task, Device };

/// Says where the client and its provider live.
enum class Where { OneProcess, TwoProcesses, TwoNamespaces };

struct Row {
  BaseLane lane;
  Filter filter;
  Transport transport;
  ProviderKind provider;
  ClientKind client;
  Where where;

  /// Returns true if both ends have one manager: then nothing crosses a wire.
  bool sharesManager() const { return lane == BaseLane::Local; }
  /// The ends share a process, and nothing lies between them: one may run what is the other's.
  bool isDirect() const { return sharesManager() && filter == Filter::None; }
  bool providerIsDevice() const { return provider == ProviderKind::Device; }
  /// The provider's commands are executed before the call of the client returns.
  bool runsInCallersThread() const { return isDirect() && providerIsDevice(); }
  /// The provider can end while the client lives.
  bool providerCanEnd() const { return !(sharesManager() && providerIsDevice()); }
  /// A message may be lost, or be dropped because it came behind a newer one.
  bool isLossy() const { return filter >= Filter::Loss; }

  /// Returns true if nothing of it follows the kernel's time: it runs on a stepped clock.
  bool isStepped() const {
    return where == Where::OneProcess &&
           (transport == Transport::None || transport == Transport::Unix);
  }

  /// Names the filter, the lane and the transport, as in "FrameTcp" and "DelayedRpc".
  std::string laneName() const;
  /// Names the lane, or the filter if there is one.
  std::string laneKind() const;
  std::string providerName() const;
  std::string clientName() const;
  std::string placeName() const;
  std::string name() const;
  friend std::ostream& operator<<(std::ostream& out, const Row& row) { return out << row.name(); }
};

using Keep = std::function<bool(const Row&)>;
/// Commands wait for the provider's thread.
inline bool isQueued(const Row& row) { return !row.runsInCallersThread(); }

/// Returns the rows that a scenario which concerns the lane runs on: in one process, by Unix
/// sockets. They are the fewest that a simple search finds in which every pair of lane kind and
/// provider, lane kind and client, and provider and client occurs, of those that `keep` leaves
/// possible.
std::vector<Row> laneRows(const Keep& keep = {});
/// Returns the rows for a scenario that also concerns what is below the lane: besides, each lane
/// occurs on each transport, in one process, two processes and two namespaces; and each transport
/// and place with each kind of provider.
std::vector<Row> wireRows(const Keep& keep = {});
/// Returns the rows for a scenario of which only the history is judged: each lane with each lossy
/// filter, in one process and in two.
std::vector<Row> lossyRows();

/// Call it before the tests are known: all scenarios run over this lane, and over no other.
void runOverAdded(AddedLane lane);
/// Returns that lane; it has no name if there is none.
const AddedLane& addedLane();

// These are all that is possible.
std::vector<Row> everyRow();
std::vector<Row> everyLaneRow();  ///< those of laneRows()
std::vector<Row> everyLossyRow();
/// SUTURE_CONFORMANCE=full in the environment asks for it: then every scenario runs on all rows
/// that are possible for it, those of the wire included.
bool fullCrossIsAsked();

}  // namespace conformance
