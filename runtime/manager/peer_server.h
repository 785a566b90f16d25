#pragma once
// One peer's view of this process.

#include <suture/manager/peer_host.h>
#include <suture/manager/records.h>

namespace suture {

/// The bootstrap capability of one link. When the link goes, so do the connections made through it.
class PeerServer final : public wire::Peer::Server {
 public:
  PeerServer(PeerHost& host, std::shared_ptr<const rpc::LinkCounters> counters);
  ~PeerServer() noexcept(false);

 protected:
  kj::Promise<void> hello(HelloContext context) override;
  kj::Promise<void> connect(ConnectContext context) override;
  kj::Promise<void> describe(DescribeContext context) override;
  kj::Promise<void> ping(PingContext context) override;
  kj::Promise<void> open(OpenContext context) override;

 private:
  /// Calls `answer(provided)`, after the process has published if the interface is not there yet;
  /// `refuse(refusal)` if it does not exist then.
  template <class Answer, class Refuse>
  kj::Promise<void> withInterface(const Endpoint& endpoint, Answer answer, Refuse refuse);

  void accept(ProvidedBase& provided, const Endpoint& endpoint, ConnectContext& context);
  kj::Own<rpc::ServantPort> serve(ProvidedBase& provided, const std::string& name, EventSet events,
                                  Duration shift);

  PeerHost& host_;
  std::shared_ptr<const rpc::LinkCounters> counters_;
  kj::Vector<kj::Own<rpc::ServantPort>> ports_;
};

}  // namespace suture
