#pragma once
// This capability receives events and rows in the client's process.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/capability.h>
#include <suture/lane/rpc/proxy_port.h>

namespace suture::rpc {

/// Belongs to the control thread. Passes them to `port`, as what `subscription` has asked for.
class Receiver final : public capnp::Capability::Server {
 public:
  Receiver(kj::Own<ProxyPort> port, std::uint32_t subscription)
      : port_(kj::mv(port)), subscription_(subscription) {}

  DispatchCallResult dispatchCall(
      std::uint64_t interface, std::uint16_t method,
      capnp::CallContext<capnp::AnyPointer, capnp::AnyPointer> call) override;

 private:
  kj::Own<ProxyPort> port_;
  const std::uint32_t subscription_;
};

}  // namespace suture::rpc
