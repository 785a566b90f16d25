#include <suture/component/contract/unbounded.h>
#include <suture/lane/carrier/row_slots.h>
#include <suture/lane/mirrored_channel.h>
#include <suture/lane/rpc/calls_client.h>
#include <suture/lane/rpc/counts_receiver.h>
#include <suture/lane/rpc/proxy_port.h>

#include <algorithm>
#include <utility>

namespace suture::rpc {
namespace {

// A larger message would hold up the small ones of other connections for too long.
constexpr std::size_t kMostShared = std::size_t{256} << 10;

bool isLarge(const InterfaceInfo& contract) {
  if (!whyUnbounded(contract).empty()) return true;
  const std::size_t most = std::max<std::size_t>(largestSlot(contract), RowSlots(contract).bytes());
  return most > kMostShared;
}

class CallsAttempt final : public LaneAttempt {
 public:
  CallsAttempt(std::shared_ptr<CallsLink> link, loop::ControlThread& control)
      : link_(std::move(link)), control_(control) {}

  void request(capnp::AnyPointer::Builder out) override {
    out.initAs<wire::CallsRequest>().setSocket(link_->number());
  }

  kj::Promise<OpenedEnd> open(OutgoingConnection connection,
                              capnp::AnyPointer::Reader answer) override {
    auto channel =
        mirroredChannel(std::move(connection), "rpc", control_.sharedDoorbell(), control_);
    auto port = kj::refcounted<ProxyPort>(control_, channel, link_->counters());
    port->open(link_->contract(answer.getAs<wire::CallsAnswer>().getConnection(),
                               kj::heap<CountsReceiver>(kj::addRef(*port))),
               link_);
    return OpenedEnd{kj::mv(port), std::move(channel)};
  }

 private:
  const std::shared_ptr<CallsLink> link_;
  loop::ControlThread& control_;
};

}  // namespace

kj::Promise<kj::Own<LaneAttempt>> CallsClient::attempt(const OutgoingConnection& connection) {
  return linkFor(connection.contract)
      .then([this](std::shared_ptr<CallsLink>&& link) -> kj::Own<LaneAttempt> {
        return kj::heap<CallsAttempt>(std::move(link), session_.control());
      });
}

kj::Promise<std::shared_ptr<CallsLink>> CallsClient::linkFor(const InterfaceInfo& contract) {
  if (isLarge(contract)) return open();
  return shared_.get([this] { return open(); });
}

kj::Promise<std::shared_ptr<CallsLink>> CallsClient::open() {
  return session_.openSocket("rpc").then([this](LaneSocket&& socket) {
    auto link = std::make_shared<CallsLink>(session_.control(), kj::mv(socket));
    link->bear(longest_);
    std::erase_if(links_, [](const auto& one) { return one.expired(); });
    links_.push_back(link);
    return link;
  });
}

void CallsClient::bear(Duration silence) {
  longest_ = silence;
  for (const auto& one : links_) {
    if (const auto link = one.lock()) link->bear(silence);
  }
}

}  // namespace suture::rpc
