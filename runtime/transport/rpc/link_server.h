#pragma once
// Serves Cap'n Proto RPC at an address: one link a connection.

#include <suture/transport/rpc/link.h>
#include <suture/transport/rpc/listener.h>

namespace suture::rpc {

/// Accepts until it is destroyed, which closes all its links. Belongs to the control thread.
class LinkServer final : private kj::TaskSet::ErrorHandler {
 public:
  /// `offer` makes the bootstrap capability of each new link; it learns the link's counters, for
  /// reports.
  using Offer = kj::Function<capnp::Capability::Client(std::shared_ptr<const LinkCounters>)>;

  /// Throws SetupError as Listener does. More than `maxLinks` connections at a time are closed
  /// unheard.
  LinkServer(EventPort& port, const Address& address, Offer offer, StreamLimits limits = {},
             std::size_t maxLinks = 1024);

  const Address& address() const { return listener_.address(); }

 private:
  void accept(kj::AutoCloseFd socket);
  void taskFailed(kj::Exception&& exception) override;

  EventPort& port_;
  Listener listener_;
  Offer offer_;
  StreamLimits limits_;
  std::size_t maxLinks_;
  std::size_t links_ = 0;
  kj::TaskSet tasks_;  // last: cancelled first
};

}  // namespace suture::rpc
