#pragma once
// What a client hears of its provider in another process, also before the connection stands.

#include <suture/lane/client_end.h>
#include <suture/loop/kj_comparisons.h>  // first
#include <suture/peer.capnp.h>

#include <suture/component/channel/counts/ledger.h>
#include <functional>
#include <string>

namespace suture {

/// Passes what befalls the provider on to the client's end, as soon as there is one. Belongs to the
/// control thread.
class ProviderNews final : public kj::Refcounted {
 public:
  void tell(ChannelStatus status);
  void close();
  /// The provider has given this client up.
  void lapse();

  void passOnTo(kj::Own<rpc::ClientEnd> end);

 private:
  ChannelStatus status_ = ChannelStatus::Connected;
  bool closed_ = false;
  bool lapsed_ = false;
  kj::Maybe<kj::Own<rpc::ClientEnd>> end_;
};

/// What the provider's process calls.
class NoticesReceiver final : public wire::Notices::Server {
 public:
  /// `lost` is told in words why the provider has closed the connection, before the client is.
  NoticesReceiver(kj::Own<ProviderNews> news, std::shared_ptr<Ledger> ledger,
                  std::function<void(std::string)> lost)
      : news_(kj::mv(news)), ledger_(std::move(ledger)), lost_(std::move(lost)) {}

 protected:
  kj::Promise<void> faulted(FaultedContext context) override;
  kj::Promise<void> suspended(SuspendedContext context) override;
  kj::Promise<void> resumed(ResumedContext context) override;
  kj::Promise<void> lapsed(LapsedContext context) override;
  kj::Promise<void> earlier(EarlierContext context) override;
  kj::Promise<void> closed(ClosedContext context) override;

 private:
  kj::Own<ProviderNews> news_;
  const std::shared_ptr<Ledger> ledger_;  // of the connection
  std::function<void(std::string)> lost_;
};

}  // namespace suture
