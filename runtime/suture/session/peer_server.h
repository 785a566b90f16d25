#pragma once
// One peer's view of this process.

#include <suture/names/records.h>
#include <suture/session/client_leases.h>
#include <suture/session/peer_host.h>

#include <optional>

namespace suture {

/// The bootstrap capability of one link. When the link goes, so do the connections made through it.
class PeerServer final : public wire::Peer::Server {
 public:
  PeerServer(PeerHost& host, std::shared_ptr<rpc::Caller> caller);
  ~PeerServer() noexcept(false);

 protected:
  kj::Promise<void> hello(HelloContext context) override;
  kj::Promise<void> connect(ConnectContext context) override;
  kj::Promise<void> describe(DescribeContext context) override;
  kj::Promise<void> ping(PingContext context) override;
  kj::Promise<void> open(OpenContext context) override;
  kj::Promise<void> explain(ExplainContext context) override;

 private:
  struct Asked;

  /// Returns what `attempt()` does. If that throws SetupError, calls it once more when the process
  /// has published, and `refuse(refusal)` if it throws again.
  template <class Attempt, class Refuse>
  kj::Promise<void> whenThere(Attempt attempt, Refuse refuse);

  Endpoint endpointOf(capnp::Text::Reader component, capnp::Text::Reader interface) const;
  kj::Promise<void> decide(ProvidedBase& provided, const Endpoint& endpoint,
                           ConnectContext& context);
  bool takesOver(const std::string& client, const std::string& name, ConnectContext& context);
  kj::Promise<void> accept(Asked asked);
  /// Keeps `end`, and answers what every lane does.
  wire::ConnectResults::Accepted::Builder accepted(Asked& asked, rpc::ProviderEnd& end);
  /// Accepts on another lane than shared memory; if that was asked for, `laneReason` says why.
  kj::Promise<void> acceptSlower(Asked& asked, const std::string& laneReason);
  void sendFrames(Asked& asked, const InterfaceInfo& contract, const std::string& laneReason);
  kj::Promise<void> serveCalls(Asked& asked, const std::string& laneReason);
  void shareMemory(Asked& asked, const InterfaceInfo& contract, std::shared_ptr<MemoryBlock> bell);
  void putTasks(wire::Peer::PingResults::Builder results) const;
  std::shared_ptr<Channel> callsChannel(ProvidedBase& provided, const std::string& name,
                                        EventSet events) const;
  kj::Own<rpc::ServantPort> serve(ProvidedBase& provided, const Endpoint& endpoint,
                                  std::shared_ptr<Channel> channel);
  void attach(ProvidedBase& provided, std::shared_ptr<Channel> channel);
  /// Enters it into the sums of its name.
  void enter(const std::shared_ptr<Channel>& channel);
  /// Why the caller is not the process that it says it is, or is not to have that interface.
  std::optional<Refusal> whyNotProcess(const std::string& name) const;
  std::optional<Refusal> whyNotGiven(const Endpoint& endpoint) const;
  /// Tells the caller and, here, whoever runs this process.
  void refuse(const Refusal& refusal, wire::Refusal::Builder out);
  bool mayOnlyRead(const Endpoint& endpoint) const;

  PeerHost& host_;
  const std::shared_ptr<rpc::Caller> caller_;
  std::string bootId_;             // the peer's, as it said in hello
  std::uint64_t incarnation_ = 0;  // likewise
  kj::Vector<kj::Own<rpc::ProviderEnd>> ends_;
  ClientLeases leases_;
};

}  // namespace suture
