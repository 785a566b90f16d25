// Written by suturec from reference/gripper_arm.h. Do not edit.
#include "reference/gripper_arm.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "reference/gripper_arm.capnp.h"

// Defined in reference/arm_types.suture.cpp.
namespace reference {
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift);
bool isValid(const JointStateSlot& slot, suture::FieldPath* path);
wire::Mode wireMode(std::uint8_t slot);
bool isKnownMode(std::uint8_t slot);
suture::Errc fromWire(wire::Mode in, std::uint8_t& slot);
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift);
bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path);
}  // namespace reference

namespace reference {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Errc;
using suture::EventInfo;
using suture::FieldPath;
using suture::checkSlot;
using suture::newSlot;
using suture::refusedAt;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::slotIn;
using suture::slotSize;
using suture::store;

bool store(const double& width, GripperArmCloseArguments& slot) { return store(width, slot.width); }

bool store(const double& width, GripperArmFitsArguments& slot) { return store(width, slot.width); }

namespace {

bool acceptsGripperArmClose(const GripperArmCloseArguments& slot, FieldPath* path) {
  return isValid(slot.width) || refusedAt(path, "width");
}

bool acceptsGripperArmCloseResult(const double& slot, FieldPath*) { return isValid(slot); }
bool acceptsGripperArmOpeningResult(const double& slot, FieldPath*) { return isValid(slot); }

bool acceptsGripperArmFits(const GripperArmFitsArguments& slot, FieldPath* path) {
  return isValid(slot.width) || refusedAt(path, "width");
}

bool acceptsGripperArmGrippedEvent(const double& slot, FieldPath*) { return isValid(slot); }

// --- GripperArm over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class GripperArmSink final : public suture::rpc::EventSink {
 public:
  explicit GripperArmSink(wire::GripperArmEvents::Client subscriber) :
      subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(ArmLikeEvent::mode): {
        const auto& slot = slotIn<std::uint8_t>(payload);
        auto request = subscriber_.modeRequest();
        request.setValue(wireMode(slot));
        return request.send().ignoreResult();
      }
      case numberOf(ArmLikeEvent::arrived): {
        const auto& slot = slotIn<PoseStampedSlot>(payload);
        auto request = subscriber_.arrivedRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(ArmLikeEvent::stopped): {
        return subscriber_.stoppedRequest().send().ignoreResult();
      }
      case numberOf(ArmLikeEvent::moved): {
        const auto& slot = slotIn<ArmLikeMovedPayload>(payload);
        auto request = subscriber_.movedRequest();
        toWire(slot.value, request.initValue());
        request.setValue2(slot.value2);
        return request.send().ignoreResult();
      }
      case numberOf(GripperArmEvent::gripped): {
        const auto& slot = slotIn<double>(payload);
        auto request = subscriber_.grippedRequest();
        request.setValue(slot);
        return request.send().ignoreResult();
      }
    }
    return kj::READY_NOW;
  }

  kj::Promise<void> row(const suture::rt::StateTable::Row& row,
                        std::span<const std::byte* const> columns) override {
    auto request = subscriber_.stateRequest();
    auto out = request.initRow();
    out.setStamp(suture::toNanoseconds(row.stamp));
    out.setEvaluated(row.valid | row.invalid);
    out.setTooLarge(row.tooLarge | row.invalid);
    if (row.hasValue(0)) {
      const auto& slot = slotIn<PoseStampedSlot>(columns[0]);
      toWire(slot, out.initMeasuredCp());
    }
    if (row.hasValue(1)) {
      const auto& slot = slotIn<JointStateSlot>(columns[1]);
      toWire(slot, out.initMeasuredJs());
    }
    if (row.hasValue(2)) {
      const auto& slot = slotIn<double>(columns[2]);
      out.setOpening(slot);
    }
    return request.send().ignoreResult();
  }

 private:
  wire::GripperArmEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class GripperArmServant final : public wire::GripperArm::Server {
 public:
  explicit GripperArmServant(kj::Own<ServantPort> port)
      : base_(suture::interfaceInfo<reference::ArmLike>().binding().makeServant(kj::addRef(*port))),
        port_(kj::mv(port)) {}

  DispatchCallResult dispatchCall(std::uint64_t contract, std::uint16_t method,
                                  suture::rpc::AnyCall call) override {
    if (contract != capnp::typeId<wire::GripperArm>()) {
      return base_->dispatchCall(contract, method, call);
    }
    return wire::GripperArm::Server::dispatchCall(contract, method, call);
  }

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<GripperArmSink>(in.getEvents()), in.getEventMask(),
                     in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> close(CloseContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<GripperArmCloseArguments>(memory);
      slot.width = in.getWidth();
      return Errc{};
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(numberOf(GripperArmCommand::close), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> opening(OpeningContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(GripperArmCommand::opening), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> release(ReleaseContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(GripperArmCommand::release), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> fits(FitsContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<GripperArmFitsArguments>(memory);
      slot.width = in.getWidth();
      return Errc{};
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<std::uint8_t>(result);
      auto out = context.getResults();
      out.setValue(slot != 0);
    };
    return port_->call(numberOf(GripperArmCommand::fits), in.getSent(), fill, kj::mv(take));
  }

 private:
  kj::Own<capnp::Capability::Server> base_;
  kj::Own<ServantPort> port_;
};

// --- GripperArm over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class GripperArmReceiver final : public wire::GripperArmEvents::Server {
 public:
  explicit GripperArmReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<PoseStampedSlot>(0);
      const Errc error =
          in.hasMeasuredCp() ? fromWire(in.getMeasuredCp(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(0, error);
    }
    if (columns.hasValue(1)) {
      auto& slot = port_->column<JointStateSlot>(1);
      const Errc error =
          in.hasMeasuredJs() ? fromWire(in.getMeasuredJs(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(1, error);
    }
    if (columns.hasValue(2)) {
      auto& slot = port_->column<double>(2);
      slot = in.getOpening();
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> mode(ModeContext context) override {
    auto in = context.getParams();
    return port_->event<std::uint8_t>(numberOf(ArmLikeEvent::mode), [&](std::uint8_t& slot) {
      return fromWire(in.getValue(), slot);
    });
  }

  kj::Promise<void> arrived(ArrivedContext context) override {
    auto in = context.getParams();
    return port_->event<PoseStampedSlot>(numberOf(ArmLikeEvent::arrived),
                                         [&](PoseStampedSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> stopped(StoppedContext) override {
    return port_->event(numberOf(ArmLikeEvent::stopped));
  }

  kj::Promise<void> moved(MovedContext context) override {
    auto in = context.getParams();
    return port_->event<ArmLikeMovedPayload>(numberOf(ArmLikeEvent::moved),
                                             [&](ArmLikeMovedPayload& slot) {
      slot.value2 = in.getValue2();
      return in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> gripped(GrippedContext context) override {
    auto in = context.getParams();
    return port_->event<double>(numberOf(GripperArmEvent::gripped), [&](double& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class GripperArmProxy final : public suture::rpc::Proxy {
 public:
  GripperArmProxy(wire::GripperArm::Client provider, ProxyPort& port)
      : base_(suture::interfaceInfo<reference::ArmLike>().binding().makeProxy(provider, port)),
        provider_(kj::mv(provider)),
        port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<GripperArmReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<GripperArmCommand>(record.command)) {
      case GripperArmCommand::close: {
        const auto& slot = slotIn<GripperArmCloseArguments>(record.arguments());
        auto request = provider_.closeRequest();
        request.setWidth(slot.width);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case GripperArmCommand::opening: {
        auto request = provider_.openingRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, response.getStamp(), [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case GripperArmCommand::release: {
        auto request = provider_.releaseRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case GripperArmCommand::fits: {
        const auto& slot = slotIn<GripperArmFitsArguments>(record.arguments());
        auto request = provider_.fitsRequest();
        request.setWidth(slot.width);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::uint8_t>(call, [&](std::uint8_t& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
    }
    return base_->send(record);
  }

 private:
  kj::Own<suture::rpc::Proxy> base_;
  wire::GripperArm::Client provider_;
  ProxyPort& port_;
};

class GripperArmBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<GripperArmServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<GripperArmProxy>(contract.castAs<wire::GripperArm>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<GripperArmSink>(subscriber.castAs<wire::GripperArmEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::GripperArm>();
  }
};

const suture::rpc::Binding& gripperArmBinding() {
  static const GripperArmBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kGripperArmCommands[] = {
    {.name = "close",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = slotSize<GripperArmCloseArguments>,
     .resultSize = slotSize<double>,
     .depth = 16,
     .accepts = checkSlot<GripperArmCloseArguments, acceptsGripperArmClose>,
     .acceptsResult = checkSlot<double, acceptsGripperArmCloseResult>},
    {.name = "opening",
     .kind = CommandKind::Read,
     .resultSize = slotSize<double>,
     .depth = 16,
     .column = 2,
     .acceptsResult = checkSlot<double, acceptsGripperArmOpeningResult>},
    {.name = "release", .kind = CommandKind::Void, .depth = 16, .inCallersThread = true},
    {.name = "fits",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<GripperArmFitsArguments>,
     .resultSize = slotSize<std::uint8_t>,
     .depth = 16,
     .inCallersThread = true,
     .accepts = checkSlot<GripperArmFitsArguments, acceptsGripperArmFits>},
};

constexpr EventInfo kGripperArmEvents[] = {
    {.name = "gripped",
     .payloadSize = slotSize<double>,
     .depth = 16,
     .accepts = checkSlot<double, acceptsGripperArmGrippedEvent>},
};

// The self-description, as in reference/gripper_arm.suture.json.
constexpr char kGripperArmDescription[] = R"json({"name": "reference::GripperArm"})json";

}  // namespace
}  // namespace reference

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<reference::GripperArm>() {
  static const auto kCommands = extended<15>(interfaceInfo<reference::ArmLike>().commands,
                                             reference::kGripperArmCommands);
  static const auto kEvents = extended<5>(interfaceInfo<reference::ArmLike>().events,
                                          reference::kGripperArmEvents);
  static const InterfaceInfo kInfo{
      .name = "reference::GripperArm",
      .hash = "gripper",
      .description = reference::kGripperArmDescription,
      .commands = kCommands,
      .events = kEvents,
      .binding = &reference::gripperArmBinding,
      .base = &interfaceInfo<reference::ArmLike>,
      .toBase = &castToBase<reference::GripperArm, reference::ArmLike>,
  };
  return kInfo;
}

Errc Provided<reference::GripperArm>::execute(std::uint16_t command, const std::byte* arguments,
                                              std::byte* result) {
  using ::reference::GripperArmCommand;
  switch (static_cast<GripperArmCommand>(command)) {
    case GripperArmCommand::close: {
      const auto& slot = slotIn<reference::GripperArmCloseArguments>(arguments);
      load(slot.width, scratch_.close_width);
      auto& answer = newSlot<double>(result);
      return store(implementation_.close(scratch_.close_width), answer) ? Errc{} : Errc::TooLarge;
    }
    case GripperArmCommand::opening: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.opening(), slot) ? Errc{} : Errc::TooLarge;
    }
    case GripperArmCommand::release: {
      implementation_.release();
      return Errc{};
    }
    case GripperArmCommand::fits: {
      const auto& slot = slotIn<reference::GripperArmFitsArguments>(arguments);
      load(slot.width, scratch_.fits_width);
      auto& answer = newSlot<std::uint8_t>(result);
      return store(implementation_.fits(scratch_.fits_width), answer) ? Errc{} : Errc::TooLarge;
    }
  }
  return Provided<reference::ArmLike>::execute(command, arguments, result);
}

}  // namespace suture
