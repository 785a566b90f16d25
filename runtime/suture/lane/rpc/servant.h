#pragma once
// The capability of a provided interface: what stands in its process for any client, ours or a
// plain one of Cap'n Proto.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/capability.h>
#include <suture/lane/rpc/servant_port.h>

namespace suture::rpc {

/// Passes calls of the contract, and of those that it derives from, to `port`. Belongs to the
/// control thread.
class Servant final : public capnp::Capability::Server {
 public:
  explicit Servant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

  DispatchCallResult dispatchCall(std::uint64_t interface, std::uint16_t method,
                                  AnyCall call) override;

 private:
  const InterfaceInfo* contractOf(std::uint64_t interface) const;
  void subscribe(const InterfaceInfo& contract, AnyCall call);

  kj::Own<ServantPort> port_;
};

}  // namespace suture::rpc
