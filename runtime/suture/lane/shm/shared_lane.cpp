#include <suture/base/errors.h>
#include <suture/codec/text.h>
#include <suture/component/contract/unbounded.h>
#include <suture/lane/shm/shared_channel.h>
#include <suture/lane/shm/shared_lane.h>
#include <suture/lane/shm/shared_memory.h>
#include <suture/lane/status_port.h>
#include <suture/loop/failure.h>
#include <suture/wiring/memory_layout.h>

#include <utility>

namespace suture::shm {
namespace {

using Type = kj::Exception::Type;

std::string whyNeverShared(const InterfaceInfo& contract, bool byUnixSocket) {
  if (std::string why = whyUnbounded(contract); !why.empty()) return why;
  return byUnixSocket ? "" : "the two processes are not reached by a Unix socket";
}

class SharedAttempt final : public LaneAttempt {
 public:
  explicit SharedAttempt(const OutgoingConnection& connection)
      : contract_(connection.contract), client_(connection.client) {}

  void request(capnp::AnyPointer::Builder out) override {
    auto request = out.initAs<wire::SharedRequest>();
    request.setLayout(codec::textOf(memoryLayout(contract_)));
    request.setBell(handOut(client_->share()));
  }

  kj::Promise<OpenedEnd> open(OutgoingConnection connection,
                              capnp::AnyPointer::Reader answer) override {
    return receive(answer.getAs<wire::SharedChannel>(), contract_)
        .then([connection = std::move(connection)](const SharedParts& parts) mutable -> OpenedEnd {
          auto channel = takeShared(std::move(connection), parts);
          return {.end = kj::refcounted<ClientEnd>(channel), .channel = channel};
        });
  }

 private:
  const InterfaceInfo& contract_;
  const std::shared_ptr<rt::Doorbell> client_;
};

class SharedClient final : public LaneClient {
 public:
  explicit SharedClient(ClientSession& session) : session_(session) {}

  // Refuses different clocks, because nothing converts the stamps that lie in shared memory.
  std::string whyNot(const OutgoingConnection& connection) const override {
    const std::string why = whyUnbounded(connection.contract);
    if (why.empty() && !session_.hasOneClock()) return "the two processes have different clocks";
    return whyNeverShared(connection.contract, session_.carriesDescriptors());
  }

  kj::Promise<kj::Own<LaneAttempt>> attempt(const OutgoingConnection& connection) override {
    return kj::Own<LaneAttempt>(kj::heap<SharedAttempt>(connection));
  }

 private:
  ClientSession& session_;
};

class SharedServer final : public LaneServer {
 public:
  explicit SharedServer(ServerSession& session) : session_(session) {}

  kj::Promise<AcceptedEnd> accept(IncomingConnection connection, capnp::AnyPointer::Reader brings,
                                  capnp::AnyPointer::Builder answer) override {
    const auto request = brings.getAs<wire::SharedRequest>();
    const std::string why = whyNot(connection, codec::stringOf(request.getLayout()));
    if (!why.empty()) return loop::failure(Type::FAILED, why);
    return receive(request.getBell(), sizeof(std::uint64_t), MemoryBlock::Others::Write)
        .then([this, connection, answer](std::shared_ptr<MemoryBlock> bell) mutable {
          SharedOffer offer =
              offerShared(connection, std::move(bell), session_.control().sharedDoorbell());
          toWire(offer.parts, answer.initAs<wire::SharedChannel>());
          return AcceptedEnd{kj::refcounted<StatusPort>(session_.control(), offer.channel),
                             offer.channel};
        })
        .catch_([](kj::Exception&& e) -> kj::Promise<AcceptedEnd> {
          if (e.getType() != Type::FAILED) return kj::mv(e);
          return loop::failure(Type::OVERLOADED, loop::describe(e));
        });
  }

  void opened(LaneSocket) override {}

 private:
  // The rows have the reads of the provided contract, and these may be more than the client knows.
  // If a value in them has pointers, the rows do not lie in memory that another process can map.
  static std::string whyNot(const IncomingConnection& connection, const std::string& layout) {
    if (connection.readOnly) return "the policy gives it for reading only";
    if (std::string why = whyOtherSlots(connection.contract, layout); !why.empty()) return why;
    if (connection.provided.state()->memory() != nullptr) return "";
    return "the provider's rows have values without a bound";
  }

  ServerSession& session_;
};

}  // namespace

std::string SharedLane::whyNever(const InterfaceInfo& contract, bool byUnixSocket) const {
  return whyNeverShared(contract, byUnixSocket);
}

kj::Own<LaneClient> SharedLane::makeClient(ClientSession& session) {
  return kj::heap<SharedClient>(session);
}

kj::Own<LaneServer> SharedLane::makeServer(ServerSession& session) {
  return kj::heap<SharedServer>(session);
}

}  // namespace suture::shm
