#pragma once
// The provider's end of a connection to another process, on any lane.

#include <suture/loop/kj_comparisons.h>  // first

#include <kj/common.h>
#include <kj/refcount.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/counts/ledger.h>

#include <memory>

namespace suture::rpc {

/// Watches over a provider's channel for a client in another process. Belongs to the control
/// thread.
class ProviderEnd : public kj::Refcounted {
 public:
  /// Hears of each change of how it stands with the provider's component.
  struct Listener {
    virtual ~Listener() noexcept(false) = default;
    virtual void told(ChannelStatus status) = 0;
    /// Passes on what has become of the commands of the connections before.
    virtual void tells(const Earlier& earlier) = 0;
  };

  void setListener(kj::Own<Listener> listener) { listener_ = kj::mv(listener); }

  /// When it is too late to hear of the client; never, if the connection is over.
  BootTime endOfLease() const;
  /// What there is to tell the client of the connections of the same name before.
  Earlier earlier();
  /// Tells it the last word on them, as soon as there is one.
  void tellEarlier();
  /// Ends what may be executed, since nobody has heard of the client in time.
  void lapse();
  /// The connection is over: the provider lets go of the channel. May be called again.
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
  /// Tells what the status has become.
  void pumpStatus();

  const std::shared_ptr<Channel> channel_;
  kj::Maybe<kj::Own<Listener>> listener_;

 private:
  void passOn(ChannelStatus status);

  bool closed_ = false;
  ChannelStatus told_ = ChannelStatus::Connected;
  std::uint32_t faultsTold_ = 0;
  bool earlierTold_ = false;  // the last word
};

}  // namespace suture::rpc
