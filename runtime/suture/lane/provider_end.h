#pragma once
// This is the provider's end of a connection to another process, on any lane.

#include <suture/loop/kj_comparisons.h>  // first

#include <kj/common.h>
#include <kj/refcount.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/counts/ledger.h>

#include <memory>
#include <string>

namespace suture {

/// Belongs to the control thread. Watches a provider's channel for a client in another process.
class ProviderEnd : public kj::Refcounted {
 public:
  /// Hears of each change of the state of the provider's component.
  struct Listener {
    virtual ~Listener() noexcept(false) = default;
    virtual void told(ChannelStatus status) = 0;
    /// Passes on the outcomes of the commands of earlier connections.
    virtual void tells(const Earlier& earlier) = 0;
    /// Tells what of the client was refused, so that the connection ends.
    virtual void refuses(const std::string& why) = 0;
  };

  void setListener(kj::Own<Listener> listener) { listener_ = kj::mv(listener); }

  /// Returns when the lease ends; never, if the connection is over.
  BootTime endOfLease() const;
  /// Returns what there is to tell the client of earlier connections of the same name.
  Earlier earlier();
  /// Tells it the last counts of them, as soon as they are known.
  void tellEarlier();
  /// Ends what may be executed, because the client was silent for too long.
  void lapse();
  /// Ends the connection: the provider drops the channel. May be called again.
  void close();
  /// Does the same because of a later connection of the same interface, and tells the client, if it
  /// can still be told.
  void end();

 protected:
  explicit ProviderEnd(std::shared_ptr<Channel> channel) : channel_(std::move(channel)) {}

  bool isClosed() const { return closed_; }
  /// Called before the channel is closed.
  virtual void ending() {}
  /// Called before the listener is told.
  virtual void changed(ChannelStatus) {}
  /// Tells the listener of a new status.
  void pumpStatus();

  const std::shared_ptr<Channel> channel_;
  kj::Maybe<kj::Own<Listener>> listener_;

 private:
  void passOn(ChannelStatus status);

  bool closed_ = false;
  ChannelStatus told_ = ChannelStatus::Connected;
  std::uint32_t faultsTold_ = 0;
  bool earlierTold_ = false;  // the last counts
};

}  // namespace suture
