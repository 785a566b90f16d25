#pragma once
// This receives the news of a provider in another process for its client. News may come before the
// connection is made.

#include <suture/lane/client_end.h>
#include <suture/loop/kj_comparisons.h>  // first
#include <suture/peer.capnp.h>

#include <suture/component/channel/counts/ledger.h>
#include <functional>
#include <string>

namespace suture {

/// Belongs to the control thread. Passes news of the provider on to the client's end, as soon as
/// there is one.
class ProviderNews final : public kj::Refcounted {
 public:
  void tell(ChannelStatus status);
  void close();
  /// Tells the client that the provider has given the connection up, and why.
  void giveUp(std::string why);

  void passOnTo(kj::Own<ClientEnd> end);

 private:
  ChannelStatus status_ = ChannelStatus::Connected;
  bool closed_ = false;
  std::string givenUp_;  // why; "": it is not
  kj::Maybe<kj::Own<ClientEnd>> end_;
};

/// The provider's process calls this.
class NoticesReceiver final : public wire::Notices::Server {
 public:
  /// `lost` gets in words why the provider has closed or refused the connection, also after its end
  /// has been noticed.
  NoticesReceiver(kj::Own<ProviderNews> news, std::shared_ptr<Ledger> ledger,
                  std::function<void(std::string)> lost)
      : news_(kj::mv(news)), ledger_(std::move(ledger)), lost_(std::move(lost)) {}

 protected:
  kj::Promise<void> faulted(FaultedContext context) override;
  kj::Promise<void> suspended(SuspendedContext context) override;
  kj::Promise<void> resumed(ResumedContext context) override;
  kj::Promise<void> lapsed(LapsedContext context) override;
  kj::Promise<void> refused(RefusedContext context) override;
  kj::Promise<void> earlier(EarlierContext context) override;
  kj::Promise<void> closed(ClosedContext context) override;

 private:
  kj::Own<ProviderNews> news_;
  const std::shared_ptr<Ledger> ledger_;  // the connection's
  std::function<void(std::string)> lost_;
};

}  // namespace suture
