#pragma once
// These are the provider ends of all connections from other processes.

#include <suture/component/channel/channel.h>
#include <suture/session/ledgers.h>
#include <suture/wiring/directory.h>

#include <memory>
#include <mutex>
#include <vector>

namespace suture {

/// Belongs to the control thread except where noted.
class ServedChannels {
 public:
  /// Both outlive it.
  ServedChannels(const Directory& directory, Ledgers& ledgers)
      : directory_(directory), ledgers_(ledgers) {}

  /// Attaches a channel to its provider, and drops those that have been closed.
  void attach(ProvidedBase& provided, std::shared_ptr<Channel> channel);
  /// Drops the closed channels of a client that stays. The last ones of a client that leaves are
  /// kept for the reports until another client connects.
  void forgetClosed();
  /// Lets go of the channels of devices that have ended: a device has no cycle in which it would.
  void sweep();

  /// Any thread. Returns those that have not been dropped.
  std::vector<std::shared_ptr<Channel>> all() const;

 private:
  const Directory& directory_;
  Ledgers& ledgers_;
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<Channel>> all_;
};

}  // namespace suture
