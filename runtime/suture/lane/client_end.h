#pragma once
// This is the client's end of a connection to another process, on any lane.

#include <suture/loop/kj_comparisons.h>  // first

#include <kj/function.h>
#include <kj/refcount.h>
#include <suture/component/channel/channel.h>

#include <memory>
#include <string>

namespace suture {

/// Belongs to the control thread. Tells a client's channel the news of its provider.
class ClientEnd : public kj::Refcounted {
 public:
  explicit ClientEnd(std::shared_ptr<Channel> channel) : channel_(std::move(channel)) {}

  /// Tells the client the state of the provider's component.
  void tell(ChannelStatus status) { channel_->tell(status); }
  /// Calls `broken` once, with the reason in words, when the connection carries nothing any more
  /// and is not closed. That may be before this returns, and `broken` must not destroy this.
  void onBroken(kj::Function<void(std::string why)> broken);
  /// Says that the connection carries nothing any more. May be called again: the first reason
  /// counts.
  void tellBroken(std::string why);
  /// Ends the connection: the client is told `why`, and calls under way end with their outcome
  /// unknown. May be called again.
  void close(ChannelStatus why);

 protected:
  bool isClosed() const { return closed_; }
  /// Called before the client is told.
  virtual void ending() {}

  const std::shared_ptr<Channel> channel_;

 private:
  kj::Maybe<kj::Function<void(std::string)>> broken_;  // null: no one listens
  std::string whyBroken_;                              // "" while it is not broken
  bool closed_ = false;
};

}  // namespace suture
