#pragma once
// This is the capability of a provided interface: it serves any client in its process, ours or a
// plain one of Cap'n Proto.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/capability.h>
#include <suture/lane/rpc/servant_port.h>

namespace suture::rpc {

/// Belongs to the control thread. Passes calls of the contract, and of those that it derives from,
/// to `port`. Ends the connection when the last client drops the capability, because without it a
/// connection carries nothing, and a plain client has nothing else to let go of.
class Servant final : public capnp::Capability::Server {
 public:
  explicit Servant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}
  ~Servant() noexcept(false) { port_->close(); }

  DispatchCallResult dispatchCall(std::uint64_t interface, std::uint16_t method,
                                  AnyCall call) override;

 private:
  const InterfaceInfo* contractOf(std::uint64_t interface) const;
  void subscribe(const InterfaceInfo& contract, AnyCall call);

  kj::Own<ServantPort> port_;
};

}  // namespace suture::rpc
