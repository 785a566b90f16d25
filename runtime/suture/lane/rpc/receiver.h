#pragma once
// The capability that receives events and rows in the client's process.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/capability.h>
#include <suture/lane/rpc/proxy_port.h>

namespace suture::rpc {

/// Passes them to `port`. Belongs to the control thread.
class Receiver final : public capnp::Capability::Server {
 public:
  explicit Receiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

  DispatchCallResult dispatchCall(
      std::uint64_t interface, std::uint16_t method,
      capnp::CallContext<capnp::AnyPointer, capnp::AnyPointer> call) override;

 private:
  kj::Own<ProxyPort> port_;
};

}  // namespace suture::rpc
