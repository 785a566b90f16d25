#pragma once
// This gets the outcomes of a client's commands.

#include <suture/calls.capnp.h>
#include <suture/codec/tallies.h>
#include <suture/lane/rpc/proxy_port.h>

namespace suture::rpc {

/// Belongs to the control thread. Passes them to `port`.
class CountsReceiver final : public wire::CommandCounts::Server {
 public:
  explicit CountsReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> tell(TellContext context) override {
    port_->tally(codec::fromWire(context.getParams().getTally()));
    return kj::READY_NOW;
  }

 private:
  kj::Own<ProxyPort> port_;
};

}  // namespace suture::rpc
