#include <suture/codec/codec.h>
#include <suture/lane/rpc/receiver.h>

#include <algorithm>

namespace suture::rpc {

capnp::Capability::Server::DispatchCallResult Receiver::dispatchCall(
    std::uint64_t interface, std::uint16_t method,
    capnp::CallContext<capnp::AnyPointer, capnp::AnyPointer> call) {
  const InterfaceInfo& contract = port_->info();
  const codec::Codec& codec = contract.codec();
  if (interface != codec.subscriber) return internalUnimplemented(contract.name, interface);
  if (method == 0) {
    port_->publish(call.getParams());
    return {kj::READY_NOW, false};
  }
  const auto found =
      std::find_if(codec.events.begin(), codec.events.end(),
                   [method](const codec::EventCodec& one) { return one.method == method; });
  if (found == codec.events.end()) {
    return internalUnimplemented(contract.name, interface, method);
  }
  const auto number = static_cast<std::uint16_t>(found - codec.events.begin());
  return {port_->event(number, subscription_, call.getParams()), false};
}

}  // namespace suture::rpc
