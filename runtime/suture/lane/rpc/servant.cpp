#include <suture/codec/codec.h>
#include <suture/lane/rpc/servant.h>

#include <algorithm>

namespace suture::rpc {

capnp::Capability::Server::DispatchCallResult Servant::dispatchCall(std::uint64_t interface,
                                                                    std::uint16_t method,
                                                                    AnyCall call) {
  const InterfaceInfo* const contract = contractOf(interface);
  if (contract == nullptr) return internalUnimplemented(port_->info().name, interface);
  if (method == 0) return subscribe(*contract, call), DispatchCallResult{kj::READY_NOW, false};
  const auto commands = port_->info().codec().commands;
  const auto found =
      std::find_if(commands.begin(), commands.end(), [&](const codec::CommandCodec& one) {
        return one.interface == interface && one.method == method;
      });
  if (found == commands.end()) return internalUnimplemented(contract->name, interface, method);
  const auto number = static_cast<std::uint16_t>(found - commands.begin());
  return {port_->command(number, call), false};
}

const InterfaceInfo* Servant::contractOf(std::uint64_t interface) const {
  const InterfaceInfo* one = &port_->info();
  while (one->codec().contract != interface) {
    if (one->base == nullptr) return nullptr;
    one = &one->base();
  }
  return one;
}

// The events and columns of a contract are the first of one that derives from it.
void Servant::subscribe(const InterfaceInfo& contract, AnyCall call) {
  const auto in = call.getParams().getAs<wire::Subscription>();
  port_->subscribe(Subscriber(in.getEvents(), contract),
                   {.events = fromWireNumbers(contract.wireEvents, in.getEventMask()),
                    .joining = fromWireNumbers(contract.wireEvents, in.getJoinMask()),
                    .columns = fromWireNumbers(contract.wireColumns, in.getStateMask())});
}

}  // namespace suture::rpc
