#pragma once
// This is a process, as it looks to a program that is none of its peers.

#include <capnp/dynamic.h>
#include <suture/names/records.h>
#include <suture/peer.capnp.h>
#include <suture/session/clock_offset.h>
#include "cli/command_line/options.h"
#include "cli/command_line/target.h"
#include "cli/contract/contract.h"
#include "cli/peer/link.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace suture::cli {

/// A ConnectionRecord is how a required interface of a process is connected, or was.
struct ConnectionRecord {
  std::string component, required;
  std::string provided;  ///< "psm-host:PSM/Arm"
  std::string lane;
  std::string status;  ///< "connected"
  Duration age{0};     ///< how long it has had that status
  bool awaitsOperator = false;
};

/// A Description is what a process says of itself.
struct Description {
  std::vector<ComponentRecord> components;
  /// There are none if its Suture was built before it told them.
  std::optional<std::vector<ConnectionRecord>> connections;
};

/// The thread that serves a component does this.
struct Cycle {
  bool running = false;      ///< it is in a cycle, and not asleep
  std::uint64_t cycles = 0;  ///< so far
};

/// Holds one link. Call these in their order; each throws SetupError, which says what was asked,
/// what was found and what to do.
class Peer {
 public:
  /// `manager` is the address of the one that knows the process.
  Peer(loop::EventPort& loop, ProcessRecord process, const net::Address& manager,
       const Options& options);

  const ProcessRecord& process() const { return process_; }
  /// Returns the address at which it is dialled.
  const net::Address& address() const { return address_; }

  /// Makes sure that something listens there.
  void knock();
  /// Links to it, and makes sure that it is that process, as far as its address can prove it.
  void dial();
  /// Returns when the certificate that it has shown ends, as tls::ending() does.
  const std::string& certificatesEnd() const { return certificatesEnd_; }
  /// Makes sure that both speak the same version of the protocol.
  void greet();

  Description describe();
  std::vector<ComponentRecord> components() { return describe().components; }
  Cycle cycleOf(const std::string& component);
  std::shared_ptr<const Contract> explain(const Target& target, wire::Peer::Side side);
  /// Returns the provided interface itself.
  capnp::DynamicCapability::Client open(const Target& target, const Contract& contract);

  /// Returns how far its clock is from ours, once it has been greeted: as exact as the greeting was
  /// fast.
  const ClockOffset& clock() const { return clock_; }
  /// Returns a stamp of its clock as a time of ours, as exact as clock() is.
  Time here(std::int64_t stamp) const;
  /// Rejects when it has not answered within the patience; asks as often.
  kj::Promise<void> whenSilent();
  /// Resolves when it is gone.
  kj::Promise<void> onDisconnect() { return link_->onDisconnect(); }

 private:
  loop::EventPort& loop_;
  const ProcessRecord process_;
  const Duration patience_;
  const net::Trust trust_;
  const net::Address address_;
  kj::Own<framing::Link> link_;
  std::string certificatesEnd_;
  wire::Peer::Client peer_ = nullptr;
  ClockOffset clock_;
};

}  // namespace suture::cli
