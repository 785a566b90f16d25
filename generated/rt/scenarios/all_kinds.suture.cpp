// Written by suturec from rt/scenarios/all_kinds.h. Do not edit.
#include "rt/scenarios/all_kinds.suture.h"

#include <suture/lane/rpc/binding.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "rt/scenarios/all_kinds.capnp.h"

// Defined in robot_types/pose.suture.cpp.
namespace robots {
void toWire(const PosePrmSlot& slot, wire::PosePrm::Builder out);
suture::Errc fromWire(wire::PosePrm::Reader in, PosePrmSlot& slot, suture::Duration shift);
bool isValid(const PosePrmSlot& slot, suture::FieldPath* path);
}  // namespace robots

namespace scenarios {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
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
using suture::shiftSlot;
using suture::slotIn;
using suture::slotSize;
using suture::store;

bool store(const double& value, AllKindsSetScalarArguments& slot) {
  return store(value, slot.value);
}

bool store(const Eigen::Vector3d& value, AllKindsSetVectorArguments& slot) {
  return store(value, slot.value);
}

bool store(const robots::PosePrm& value, AllKindsSetRecordArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(AllKindsSetRecordArguments& slot, Duration shift) {
  shiftStamps(slot.value, shift);
}

bool store(const std::string& value, AllKindsSetTextArguments& slot) {
  return store(value, slot.value);
}

bool store(const double& value, AllKindsTwiceScalarArguments& slot) {
  return store(value, slot.value);
}

bool store(const Eigen::Vector3d& value, AllKindsTwiceVectorArguments& slot) {
  return store(value, slot.value);
}

bool store(const robots::PosePrm& value, AllKindsTwiceRecordArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(AllKindsTwiceRecordArguments& slot, Duration shift) {
  shiftStamps(slot.value, shift);
}

bool store(const std::string& value, AllKindsTwiceTextArguments& slot) {
  return store(value, slot.value);
}

bool store(const double& value, AllKindsSwapScalarArguments& slot) {
  return store(value, slot.value);
}

bool store(const Eigen::Vector3d& value, AllKindsSwapVectorArguments& slot) {
  return store(value, slot.value);
}

bool store(const robots::PosePrm& value, AllKindsSwapRecordArguments& slot) {
  return store(value, slot.value);
}

void shiftStamps(AllKindsSwapRecordArguments& slot, Duration shift) {
  shiftStamps(slot.value, shift);
}

bool store(const std::string& value, AllKindsSwapTextArguments& slot) {
  return store(value, slot.value);
}

namespace {

bool acceptsAllKindsSetScalar(const AllKindsSetScalarArguments& slot, FieldPath* path) {
  return isValid(slot.value) || refusedAt(path, "value");
}

bool acceptsAllKindsSetVector(const AllKindsSetVectorArguments& slot, FieldPath* path) {
  return isValid(slot.value, path) || refusedAt(path, "value");
}

bool acceptsAllKindsSetRecord(const AllKindsSetRecordArguments& slot, FieldPath* path) {
  return isValid(slot.value, path) || refusedAt(path, "value");
}

bool acceptsAllKindsScalarResult(const double& slot, FieldPath*) { return isValid(slot); }

bool acceptsAllKindsVectorResult(const std::array<double, 3>& slot, FieldPath* path) {
  return isValid(slot, path);
}

bool acceptsAllKindsTwiceScalar(const AllKindsTwiceScalarArguments& slot, FieldPath* path) {
  return isValid(slot.value) || refusedAt(path, "value");
}

bool acceptsAllKindsTwiceScalarResult(const double& slot, FieldPath*) { return isValid(slot); }

bool acceptsAllKindsTwiceVector(const AllKindsTwiceVectorArguments& slot, FieldPath* path) {
  return isValid(slot.value, path) || refusedAt(path, "value");
}

bool acceptsAllKindsTwiceVectorResult(const std::array<double, 3>& slot, FieldPath* path) {
  return isValid(slot, path);
}

bool acceptsAllKindsTwiceRecord(const AllKindsTwiceRecordArguments& slot, FieldPath* path) {
  return isValid(slot.value, path) || refusedAt(path, "value");
}

bool acceptsAllKindsTakeScalarResult(const double& slot, FieldPath*) { return isValid(slot); }

bool acceptsAllKindsTakeVectorResult(const std::array<double, 3>& slot, FieldPath* path) {
  return isValid(slot, path);
}

bool acceptsAllKindsSwapScalar(const AllKindsSwapScalarArguments& slot, FieldPath* path) {
  return isValid(slot.value) || refusedAt(path, "value");
}

bool acceptsAllKindsSwapScalarResult(const double& slot, FieldPath*) { return isValid(slot); }

bool acceptsAllKindsSwapVector(const AllKindsSwapVectorArguments& slot, FieldPath* path) {
  return isValid(slot.value, path) || refusedAt(path, "value");
}

bool acceptsAllKindsSwapVectorResult(const std::array<double, 3>& slot, FieldPath* path) {
  return isValid(slot, path);
}

bool acceptsAllKindsSwapRecord(const AllKindsSwapRecordArguments& slot, FieldPath* path) {
  return isValid(slot.value, path) || refusedAt(path, "value");
}

bool acceptsAllKindsScalarSetEvent(const double& slot, FieldPath*) { return isValid(slot); }

bool acceptsAllKindsVectorSetEvent(const std::array<double, 3>& slot, FieldPath* path) {
  return isValid(slot, path);
}

// --- AllKinds over Cap'n Proto RPC: the provider's side

/// Makes remote calls of a subscriber's events and rows.
class AllKindsSink final : public suture::rpc::EventSink {
 public:
  explicit AllKindsSink(wire::AllKindsEvents::Client subscriber) :
      subscriber_(kj::mv(subscriber)) {}

  kj::Promise<void> event(std::uint16_t event, const std::byte* payload) override {
    switch (event) {
      case numberOf(AllKindsEvent::cleared): {
        return subscriber_.clearedRequest().send().ignoreResult();
      }
      case numberOf(AllKindsEvent::scalar_set): {
        const auto& slot = slotIn<double>(payload);
        auto request = subscriber_.scalarSetRequest();
        request.setValue(slot);
        return request.send().ignoreResult();
      }
      case numberOf(AllKindsEvent::vector_set): {
        const auto& slot = slotIn<std::array<double, 3>>(payload);
        auto request = subscriber_.vectorSetRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(AllKindsEvent::record_set): {
        const auto& slot = slotIn<robots::PosePrmSlot>(payload);
        auto request = subscriber_.recordSetRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(AllKindsEvent::text_set): {
        const auto& slot = slotIn<suture::BoundedText<31>>(payload);
        auto request = subscriber_.textSetRequest();
        toWire(slot, request.initValue(slot.size));
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
      const auto& slot = slotIn<double>(columns[0]);
      out.setScalar(slot);
    }
    if (row.hasValue(1)) {
      const auto& slot = slotIn<std::array<double, 3>>(columns[1]);
      toWire(slot, out.initVector());
    }
    if (row.hasValue(2)) {
      const auto& slot = slotIn<robots::PosePrmSlot>(columns[2]);
      toWire(slot, out.initRecord());
    }
    if (row.hasValue(3)) {
      const auto& slot = slotIn<suture::BoundedText<31>>(columns[3]);
      toWire(slot, out.initText(slot.size));
    }
    return request.send().ignoreResult();
  }

 private:
  wire::AllKindsEvents::Client subscriber_;
};

/// Puts remote calls into the provider's mailbox.
class AllKindsServant final : public wire::AllKinds::Server {
 public:
  explicit AllKindsServant(kj::Own<ServantPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    auto in = context.getParams();
    port_->subscribe(kj::heap<AllKindsSink>(in.getEvents()), in.getEventMask(), in.getStateMask());
    return kj::READY_NOW;
  }

  kj::Promise<void> clear(ClearContext context) override {
    auto in = context.getParams();
    return port_->command(numberOf(AllKindsCommand::clear), in.getSent(),
                          [](std::byte*) { return Errc{}; });
  }

  kj::Promise<void> setScalar(SetScalarContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsSetScalarArguments>(memory);
      slot.value = in.getValue();
      return Errc{};
    };
    return port_->command(numberOf(AllKindsCommand::set_scalar), in.getSent(), fill);
  }

  kj::Promise<void> setVector(SetVectorContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsSetVectorArguments>(memory);
      return in.hasValue() ? fromWire(in.getValue(), slot.value) : Errc::Invalid;
    };
    return port_->command(numberOf(AllKindsCommand::set_vector), in.getSent(), fill);
  }

  kj::Promise<void> setRecord(SetRecordContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsSetRecordArguments>(memory);
      return in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
    };
    return port_->command(numberOf(AllKindsCommand::set_record), in.getSent(), fill);
  }

  kj::Promise<void> setText(SetTextContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsSetTextArguments>(memory);
      return fromWire(in.getValue(), slot.value);
    };
    return port_->command(numberOf(AllKindsCommand::set_text), in.getSent(), fill);
  }

  kj::Promise<void> scalar(ScalarContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(AllKindsCommand::scalar), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> vector(VectorContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<std::array<double, 3>>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(AllKindsCommand::vector), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> record(RecordContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<robots::PosePrmSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(AllKindsCommand::record), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> text(TextContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = slotIn<suture::BoundedText<31>>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue(slot.size));
      out.setStamp(suture::toNanoseconds(stamp));
    };
    return port_->call(numberOf(AllKindsCommand::text), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> twiceScalar(TwiceScalarContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsTwiceScalarArguments>(memory);
      slot.value = in.getValue();
      return Errc{};
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(numberOf(AllKindsCommand::twice_scalar), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> twiceVector(TwiceVectorContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsTwiceVectorArguments>(memory);
      return in.hasValue() ? fromWire(in.getValue(), slot.value) : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<std::array<double, 3>>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::twice_vector), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> twiceRecord(TwiceRecordContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsTwiceRecordArguments>(memory);
      return in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<robots::PosePrmSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::twice_record), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> twiceText(TwiceTextContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsTwiceTextArguments>(memory);
      return fromWire(in.getValue(), slot.value);
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<suture::BoundedText<31>>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue(slot.size));
    };
    return port_->call(numberOf(AllKindsCommand::twice_text), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> takeScalar(TakeScalarContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(numberOf(AllKindsCommand::take_scalar), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> takeVector(TakeVectorContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<std::array<double, 3>>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::take_vector), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> takeRecord(TakeRecordContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<robots::PosePrmSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::take_record), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> takeText(TakeTextContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<suture::BoundedText<31>>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue(slot.size));
    };
    return port_->call(numberOf(AllKindsCommand::take_text), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> swapScalar(SwapScalarContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsSwapScalarArguments>(memory);
      slot.value = in.getValue();
      return Errc{};
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<double>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(numberOf(AllKindsCommand::swap_scalar), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> swapVector(SwapVectorContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsSwapVectorArguments>(memory);
      return in.hasValue() ? fromWire(in.getValue(), slot.value) : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<std::array<double, 3>>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::swap_vector), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> swapRecord(SwapRecordContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsSwapRecordArguments>(memory);
      return in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<robots::PosePrmSlot>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::swap_record), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> swapText(SwapTextContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = newSlot<AllKindsSwapTextArguments>(memory);
      return fromWire(in.getValue(), slot.value);
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = slotIn<suture::BoundedText<31>>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue(slot.size));
    };
    return port_->call(numberOf(AllKindsCommand::swap_text), in.getSent(), fill, kj::mv(take));
  }

 private:
  kj::Own<ServantPort> port_;
};

// --- AllKinds over Cap'n Proto RPC: the client's side

/// Receives events and rows.
class AllKindsReceiver final : public wire::AllKindsEvents::Server {
 public:
  explicit AllKindsReceiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}

 protected:
  kj::Promise<void> state(StateContext context) override {
    auto in = context.getParams().getRow();
    auto columns = port_->columnsOf(in.getEvaluated(), in.getTooLarge());
    if (columns.hasValue(0)) {
      auto& slot = port_->column<double>(0);
      slot = in.getScalar();
    }
    if (columns.hasValue(1)) {
      auto& slot = port_->column<std::array<double, 3>>(1);
      const Errc error = in.hasVector() ? fromWire(in.getVector(), slot) : Errc::Invalid;
      columns.enter(1, error);
    }
    if (columns.hasValue(2)) {
      auto& slot = port_->column<robots::PosePrmSlot>(2);
      const Errc error =
          in.hasRecord() ? fromWire(in.getRecord(), slot, port_->shift()) : Errc::Invalid;
      columns.enter(2, error);
    }
    if (columns.hasValue(3)) {
      auto& slot = port_->column<suture::BoundedText<31>>(3);
      const Errc error = fromWire(in.getText(), slot);
      columns.enter(3, error);
    }
    port_->publish(in.getStamp(), columns);
    return kj::READY_NOW;
  }

  kj::Promise<void> cleared(ClearedContext) override {
    return port_->event(numberOf(AllKindsEvent::cleared));
  }

  kj::Promise<void> scalarSet(ScalarSetContext context) override {
    auto in = context.getParams();
    return port_->event<double>(numberOf(AllKindsEvent::scalar_set), [&](double& slot) {
      slot = in.getValue();
      return Errc{};
    });
  }

  kj::Promise<void> vectorSet(VectorSetContext context) override {
    auto in = context.getParams();
    return port_->event<std::array<double, 3>>(numberOf(AllKindsEvent::vector_set),
                                               [&](std::array<double, 3>& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot) : Errc::Invalid;
    });
  }

  kj::Promise<void> recordSet(RecordSetContext context) override {
    auto in = context.getParams();
    return port_->event<robots::PosePrmSlot>(numberOf(AllKindsEvent::record_set),
                                             [&](robots::PosePrmSlot& slot) {
      return in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    });
  }

  kj::Promise<void> textSet(TextSetContext context) override {
    auto in = context.getParams();
    return port_->event<suture::BoundedText<31>>(numberOf(AllKindsEvent::text_set),
                                                 [&](suture::BoundedText<31>& slot) {
      return fromWire(in.getValue(), slot);
    });
  }

 private:
  kj::Own<ProxyPort> port_;
};

/// Makes remote calls of commands.
class AllKindsProxy final : public suture::rpc::Proxy {
 public:
  AllKindsProxy(wire::AllKinds::Client provider, ProxyPort& port)
      : provider_(kj::mv(provider)), port_(port) {}

  kj::Promise<void> subscribe(suture::EventSet events, suture::rt::ColumnSet columns) override {
    auto request = provider_.subscribeRequest();
    request.setEvents(kj::heap<AllKindsReceiver>(kj::addRef(port_)));
    request.setEventMask(events);
    request.setStateMask(columns);
    return request.send().ignoreResult();
  }

  kj::Promise<void> send(const suture::rt::CommandRecord& record) override {
    switch (static_cast<AllKindsCommand>(record.command)) {
      case AllKindsCommand::clear: {
        auto request = provider_.clearRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case AllKindsCommand::set_scalar: {
        const auto& slot = slotIn<AllKindsSetScalarArguments>(record.arguments());
        auto request = provider_.setScalarRequest();
        request.setValue(slot.value);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case AllKindsCommand::set_vector: {
        const auto& slot = slotIn<AllKindsSetVectorArguments>(record.arguments());
        auto request = provider_.setVectorRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case AllKindsCommand::set_record: {
        const auto& slot = slotIn<AllKindsSetRecordArguments>(record.arguments());
        auto request = provider_.setRecordRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case AllKindsCommand::set_text: {
        const auto& slot = slotIn<AllKindsSetTextArguments>(record.arguments());
        auto request = provider_.setTextRequest();
        toWire(slot.value, request.initValue(slot.value.size));
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case AllKindsCommand::scalar: {
        auto request = provider_.scalarRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, response.getStamp(), [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case AllKindsCommand::vector: {
        auto request = provider_.vectorRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::array<double, 3>>(call, response.getStamp(),
                                              [&](std::array<double, 3>& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer) : Errc::Invalid;
          });
        });
      }
      case AllKindsCommand::record: {
        auto request = provider_.recordRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<robots::PosePrmSlot>(call, response.getStamp(),
                                            [&](robots::PosePrmSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case AllKindsCommand::text: {
        auto request = provider_.textRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<suture::BoundedText<31>>(call, response.getStamp(),
                                                [&](suture::BoundedText<31>& answer) {
            return fromWire(response.getValue(), answer);
          });
        });
      }
      case AllKindsCommand::twice_scalar: {
        const auto& slot = slotIn<AllKindsTwiceScalarArguments>(record.arguments());
        auto request = provider_.twiceScalarRequest();
        request.setValue(slot.value);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case AllKindsCommand::twice_vector: {
        const auto& slot = slotIn<AllKindsTwiceVectorArguments>(record.arguments());
        auto request = provider_.twiceVectorRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::array<double, 3>>(call, [&](std::array<double, 3>& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer) : Errc::Invalid;
          });
        });
      }
      case AllKindsCommand::twice_record: {
        const auto& slot = slotIn<AllKindsTwiceRecordArguments>(record.arguments());
        auto request = provider_.twiceRecordRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<robots::PosePrmSlot>(call, [&](robots::PosePrmSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case AllKindsCommand::twice_text: {
        const auto& slot = slotIn<AllKindsTwiceTextArguments>(record.arguments());
        auto request = provider_.twiceTextRequest();
        toWire(slot.value, request.initValue(slot.value.size));
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<suture::BoundedText<31>>(call, [&](suture::BoundedText<31>& answer) {
            return fromWire(response.getValue(), answer);
          });
        });
      }
      case AllKindsCommand::take_scalar: {
        auto request = provider_.takeScalarRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case AllKindsCommand::take_vector: {
        auto request = provider_.takeVectorRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::array<double, 3>>(call, [&](std::array<double, 3>& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer) : Errc::Invalid;
          });
        });
      }
      case AllKindsCommand::take_record: {
        auto request = provider_.takeRecordRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<robots::PosePrmSlot>(call, [&](robots::PosePrmSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case AllKindsCommand::take_text: {
        auto request = provider_.takeTextRequest();
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<suture::BoundedText<31>>(call, [&](suture::BoundedText<31>& answer) {
            return fromWire(response.getValue(), answer);
          });
        });
      }
      case AllKindsCommand::swap_scalar: {
        const auto& slot = slotIn<AllKindsSwapScalarArguments>(record.arguments());
        auto request = provider_.swapScalarRequest();
        request.setValue(slot.value);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<double>(call, [&](double& answer) {
            answer = response.getValue();
            return Errc{};
          });
        });
      }
      case AllKindsCommand::swap_vector: {
        const auto& slot = slotIn<AllKindsSwapVectorArguments>(record.arguments());
        auto request = provider_.swapVectorRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<std::array<double, 3>>(call, [&](std::array<double, 3>& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer) : Errc::Invalid;
          });
        });
      }
      case AllKindsCommand::swap_record: {
        const auto& slot = slotIn<AllKindsSwapRecordArguments>(record.arguments());
        auto request = provider_.swapRecordRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<robots::PosePrmSlot>(call, [&](robots::PosePrmSlot& answer) {
            return response.hasValue() ? fromWire(response.getValue(), answer, port_.shift())
                : Errc::Invalid;
          });
        });
      }
      case AllKindsCommand::swap_text: {
        const auto& slot = slotIn<AllKindsSwapTextArguments>(record.arguments());
        auto request = provider_.swapTextRequest();
        toWire(slot.value, request.initValue(slot.value.size));
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&& response) {
          port_.answer<suture::BoundedText<31>>(call, [&](suture::BoundedText<31>& answer) {
            return fromWire(response.getValue(), answer);
          });
        });
      }
    }
    return kj::READY_NOW;
  }

 private:
  wire::AllKinds::Client provider_;
  ProxyPort& port_;
};

class AllKindsBinding final : public suture::rpc::Binding {
 public:
  kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const override {
    return kj::heap<AllKindsServant>(kj::mv(port));
  }
  kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract,
                                        ProxyPort& port) const override {
    return kj::heap<AllKindsProxy>(contract.castAs<wire::AllKinds>(), port);
  }
  kj::Own<suture::rpc::EventSink> makeSink(capnp::Capability::Client subscriber) const override {
    return kj::heap<AllKindsSink>(subscriber.castAs<wire::AllKindsEvents>());
  }
  capnp::InterfaceSchema schema() const override {
    return capnp::Schema::from<wire::AllKinds>();
  }
};

const suture::rpc::Binding& allKindsBinding() {
  static const AllKindsBinding kBinding;
  return kBinding;
}

constexpr CommandInfo kAllKindsCommands[] = {
    {.name = "clear", .kind = CommandKind::Void, .depth = 16},
    {.name = "set_scalar",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<AllKindsSetScalarArguments>,
     .depth = 16,
     .accepts = checkSlot<AllKindsSetScalarArguments, acceptsAllKindsSetScalar>},
    {.name = "set_vector",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<AllKindsSetVectorArguments>,
     .depth = 16,
     .accepts = checkSlot<AllKindsSetVectorArguments, acceptsAllKindsSetVector>},
    {.name = "set_record",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<AllKindsSetRecordArguments>,
     .depth = 16,
     .accepts = checkSlot<AllKindsSetRecordArguments, acceptsAllKindsSetRecord>,
     .shiftArguments = shiftSlot<AllKindsSetRecordArguments>},
    {.name = "set_text",
     .kind = CommandKind::Write,
     .argumentsSize = slotSize<AllKindsSetTextArguments>,
     .depth = 16},
    {.name = "scalar",
     .kind = CommandKind::Read,
     .resultSize = slotSize<double>,
     .depth = 16,
     .column = 0,
     .acceptsResult = checkSlot<double, acceptsAllKindsScalarResult>},
    {.name = "vector",
     .kind = CommandKind::Read,
     .resultSize = slotSize<std::array<double, 3>>,
     .depth = 16,
     .column = 1,
     .acceptsResult = checkSlot<std::array<double, 3>, acceptsAllKindsVectorResult>},
    {.name = "record",
     .kind = CommandKind::Read,
     .resultSize = slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .column = 2,
     .acceptsResult = checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftResult = shiftSlot<robots::PosePrmSlot>},
    {.name = "text",
     .kind = CommandKind::Read,
     .resultSize = slotSize<suture::BoundedText<31>>,
     .depth = 16,
     .column = 3},
    {.name = "twice_scalar",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<AllKindsTwiceScalarArguments>,
     .resultSize = slotSize<double>,
     .depth = 16,
     .accepts = checkSlot<AllKindsTwiceScalarArguments, acceptsAllKindsTwiceScalar>,
     .acceptsResult = checkSlot<double, acceptsAllKindsTwiceScalarResult>},
    {.name = "twice_vector",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<AllKindsTwiceVectorArguments>,
     .resultSize = slotSize<std::array<double, 3>>,
     .depth = 16,
     .accepts = checkSlot<AllKindsTwiceVectorArguments, acceptsAllKindsTwiceVector>,
     .acceptsResult = checkSlot<std::array<double, 3>, acceptsAllKindsTwiceVectorResult>},
    {.name = "twice_record",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<AllKindsTwiceRecordArguments>,
     .resultSize = slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .accepts = checkSlot<AllKindsTwiceRecordArguments, acceptsAllKindsTwiceRecord>,
     .acceptsResult = checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftArguments = shiftSlot<AllKindsTwiceRecordArguments>,
     .shiftResult = shiftSlot<robots::PosePrmSlot>},
    {.name = "twice_text",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = slotSize<AllKindsTwiceTextArguments>,
     .resultSize = slotSize<suture::BoundedText<31>>,
     .depth = 16},
    {.name = "take_scalar",
     .kind = CommandKind::VoidReturn,
     .resultSize = slotSize<double>,
     .depth = 16,
     .acceptsResult = checkSlot<double, acceptsAllKindsTakeScalarResult>},
    {.name = "take_vector",
     .kind = CommandKind::VoidReturn,
     .resultSize = slotSize<std::array<double, 3>>,
     .depth = 16,
     .acceptsResult = checkSlot<std::array<double, 3>, acceptsAllKindsTakeVectorResult>},
    {.name = "take_record",
     .kind = CommandKind::VoidReturn,
     .resultSize = slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .acceptsResult = checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftResult = shiftSlot<robots::PosePrmSlot>},
    {.name = "take_text",
     .kind = CommandKind::VoidReturn,
     .resultSize = slotSize<suture::BoundedText<31>>,
     .depth = 16},
    {.name = "swap_scalar",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = slotSize<AllKindsSwapScalarArguments>,
     .resultSize = slotSize<double>,
     .depth = 16,
     .accepts = checkSlot<AllKindsSwapScalarArguments, acceptsAllKindsSwapScalar>,
     .acceptsResult = checkSlot<double, acceptsAllKindsSwapScalarResult>},
    {.name = "swap_vector",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = slotSize<AllKindsSwapVectorArguments>,
     .resultSize = slotSize<std::array<double, 3>>,
     .depth = 16,
     .accepts = checkSlot<AllKindsSwapVectorArguments, acceptsAllKindsSwapVector>,
     .acceptsResult = checkSlot<std::array<double, 3>, acceptsAllKindsSwapVectorResult>},
    {.name = "swap_record",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = slotSize<AllKindsSwapRecordArguments>,
     .resultSize = slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .accepts = checkSlot<AllKindsSwapRecordArguments, acceptsAllKindsSwapRecord>,
     .acceptsResult = checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftArguments = shiftSlot<AllKindsSwapRecordArguments>,
     .shiftResult = shiftSlot<robots::PosePrmSlot>},
    {.name = "swap_text",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = slotSize<AllKindsSwapTextArguments>,
     .resultSize = slotSize<suture::BoundedText<31>>,
     .depth = 16},
};

constexpr EventInfo kAllKindsEvents[] = {
    {.name = "cleared", .depth = 16},
    {.name = "scalar_set",
     .payloadSize = slotSize<double>,
     .depth = 16,
     .accepts = checkSlot<double, acceptsAllKindsScalarSetEvent>},
    {.name = "vector_set",
     .payloadSize = slotSize<std::array<double, 3>>,
     .depth = 16,
     .accepts = checkSlot<std::array<double, 3>, acceptsAllKindsVectorSetEvent>},
    {.name = "record_set",
     .payloadSize = slotSize<robots::PosePrmSlot>,
     .depth = 16,
     .accepts = checkSlot<robots::PosePrmSlot, robots::isValid>,
     .shiftPayload = shiftSlot<robots::PosePrmSlot>},
    {.name = "text_set", .payloadSize = slotSize<suture::BoundedText<31>>, .depth = 16},
};

// The self-description, as in rt/scenarios/all_kinds.suture.json.
constexpr char kAllKindsDescription[] = R"json(
{"name": "scenarios::AllKinds", "hash": "6c3eb0727bcc74c29cb02c916019eb6c", "commands": [{
"name": "clear", "kind": "void", "ordinal": 1, "doc": "Forgets all values. void", "queue": 16}, {
"name": "set_scalar", "kind": "write", "ordinal": 2, "wire": "setScalar",
"doc": "Write: keep a value and tell it.", "parameters": [{"name": "value", "type": {
"kind": "Float64"}}], "queue": 16}, {"name": "set_vector", "kind": "write", "ordinal": 3,
"wire": "setVector", "parameters": [{"name": "value", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}}], "queue": 16}, {"name": "set_record",
"kind": "write", "ordinal": 4, "wire": "setRecord", "parameters": [{"name": "value", "type": {
"kind": "struct", "name": "robots::PosePrm"}}], "queue": 16}, {"name": "set_text", "kind": "write",
"ordinal": 5, "wire": "setText", "parameters": [{"name": "value", "type": {"kind": "text",
"capacity": 31}}], "queue": 16}, {"name": "scalar", "kind": "read", "ordinal": 6,
"doc": "Read: the value kept.", "result": {"type": {"kind": "Float64"}}, "queue": 16}, {
"name": "vector", "kind": "read", "ordinal": 7, "result": {"type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16}, {"name": "record", "kind": "read",
"ordinal": 8, "result": {"type": {"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}, {
"name": "text", "kind": "read", "ordinal": 9, "result": {"type": {"kind": "text", "capacity": 31}},
"queue": 16}, {"name": "twice_scalar", "kind": "qualified read", "ordinal": 10,
"wire": "twiceScalar", "doc": "Qualified read: twice the value given.", "parameters": [{
"name": "value", "type": {"kind": "Float64"}}], "result": {"type": {"kind": "Float64"}}, "queue": 16
}, {"name": "twice_vector", "kind": "qualified read", "ordinal": 11, "wire": "twiceVector",
"parameters": [{"name": "value", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}}], "result": {"type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1
}}, "queue": 16}, {"name": "twice_record", "kind": "qualified read", "ordinal": 12,
"wire": "twiceRecord", "parameters": [{"name": "value", "type": {"kind": "struct",
"name": "robots::PosePrm"}}], "result": {"type": {"kind": "struct", "name": "robots::PosePrm"}},
"queue": 16}, {"name": "twice_text", "kind": "qualified read", "ordinal": 13, "wire": "twiceText",
"parameters": [{"name": "value", "type": {"kind": "text", "capacity": 15}}], "result": {"type": {
"kind": "text", "capacity": 31}}, "queue": 16}, {"name": "take_scalar", "kind": "void with return",
"ordinal": 14, "wire": "takeScalar", "doc": "Void with return: the value kept, and forgets it.",
"result": {"type": {"kind": "Float64"}}, "queue": 16}, {"name": "take_vector",
"kind": "void with return", "ordinal": 15, "wire": "takeVector", "result": {"type": {
"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16}, {
"name": "take_record", "kind": "void with return", "ordinal": 16, "wire": "takeRecord", "result": {
"type": {"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}, {"name": "take_text",
"kind": "void with return", "ordinal": 17, "wire": "takeText", "result": {"type": {"kind": "text",
"capacity": 31}}, "queue": 16}, {"name": "swap_scalar", "kind": "write with return", "ordinal": 18,
"wire": "swapScalar", "doc": "Write with return: keep a value, answer the one before.",
"parameters": [{"name": "value", "type": {"kind": "Float64"}}], "result": {"type": {
"kind": "Float64"}}, "queue": 16}, {"name": "swap_vector", "kind": "write with return",
"ordinal": 19, "wire": "swapVector", "parameters": [{"name": "value", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}}], "result": {"type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16}, {"name": "swap_record",
"kind": "write with return", "ordinal": 20, "wire": "swapRecord", "parameters": [{"name": "value",
"type": {"kind": "struct", "name": "robots::PosePrm"}}], "result": {"type": {"kind": "struct",
"name": "robots::PosePrm"}}, "queue": 16}, {"name": "swap_text", "kind": "write with return",
"ordinal": 21, "wire": "swapText", "parameters": [{"name": "value", "type": {"kind": "text",
"capacity": 31}}], "result": {"type": {"kind": "text", "capacity": 31}}, "queue": 16}], "events": [
{"name": "cleared", "kind": "void", "ordinal": 1, "doc": "All values are forgotten. void",
"queue": 16}, {"name": "scalar_set", "kind": "write", "ordinal": 2, "wire": "scalarSet",
"doc": "Write: a value has been set.", "payload": {"type": {"kind": "Float64"}}, "queue": 16}, {
"name": "vector_set", "kind": "write", "ordinal": 3, "wire": "vectorSet", "payload": {"type": {
"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16}, {
"name": "record_set", "kind": "write", "ordinal": 4, "wire": "recordSet", "payload": {"type": {
"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}, {"name": "text_set", "kind": "write",
"ordinal": 5, "wire": "textSet", "payload": {"type": {"kind": "text", "capacity": 31}}, "queue": 16
}], "enums": [], "structs": [{"name": "robots::PosePrm",
"doc": "The fields of the cisst libraries' prmPositionCartesianGet, the type of the paper's\nmeasurements.",
"fields": [{"name": "timestamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "automatic_timestamp", "wire": "automaticTimestamp",
"doc": "Whether the provider stamps the data itself.", "type": {"kind": "Bool"}, "default": true}, {
"name": "valid", "type": {"kind": "Bool"}, "default": false}, {"name": "moving_frame",
"wire": "movingFrame", "type": {"kind": "text", "capacity": 15}}, {"name": "reference_frame",
"wire": "referenceFrame", "type": {"kind": "text", "capacity": 15}}, {"name": "position",
"doc": "The moving frame in the reference frame.", "type": {"kind": "isometry", "scalar": "Float64"
}, "unit": "m"}]}], "wire": [{"id": "@0xf6dce3f368753cbc", "kind": "interface", "name": "AllKinds",
"cxx": "scenarios::AllKinds", "members": [{"at": 0, "name": "subscribe", "parameters": [{"at": 0,
"name": "events", "is": "@0xdccb6d872bbaa8db"}, {"at": 1, "name": "eventMask", "is": "UInt64"}, {
"at": 2, "name": "stateMask", "is": "UInt64"}]}, {"at": 1, "name": "clear", "is": "kind \"void\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 2,
"name": "setScalar", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 3,
"name": "setVector", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "/suture/types.capnp:Vec3"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 4, "name": "setRecord", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xedd17c97b8723561"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 5, "name": "setText", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "Text"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {"at": 6,
"name": "scalar", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Float64"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 7, "name": "vector", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "/suture/types.capnp:Vec3"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 8, "name": "record", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 9, "name": "text", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Text"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 10,
"name": "twiceScalar", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "value",
"is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Float64"}]}, {"at": 11, "name": "twiceVector",
"is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "value",
"is": "/suture/types.capnp:Vec3"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "/suture/types.capnp:Vec3"}]}, {"at": 12,
"name": "twiceRecord", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xedd17c97b8723561"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"}]}, {"at": 13,
"name": "twiceText", "is": "kind \"qualifiedRead\"", "parameters": [{"at": 0, "name": "value",
"is": "Text"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Text"}]}, {"at": 14, "name": "takeScalar", "is": "kind \"voidReturn\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Float64"}]}, {"at": 15, "name": "takeVector", "is": "kind \"voidReturn\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "/suture/types.capnp:Vec3"}]}, {"at": 16, "name": "takeRecord",
"is": "kind \"voidReturn\"", "parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"
}], "results": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"}]}, {"at": 17,
"name": "takeText", "is": "kind \"voidReturn\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "Text"}]}, {
"at": 18, "name": "swapScalar", "is": "kind \"writeReturn\"", "parameters": [{"at": 0,
"name": "value", "is": "Float64"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "Float64"}]}, {"at": 19, "name": "swapVector",
"is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "value",
"is": "/suture/types.capnp:Vec3"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "/suture/types.capnp:Vec3"}]}, {"at": 20,
"name": "swapRecord", "is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xedd17c97b8723561"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}],
"results": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"}]}, {"at": 21,
"name": "swapText", "is": "kind \"writeReturn\"", "parameters": [{"at": 0, "name": "value",
"is": "Text"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "Text"}]}]}, {"id": "@0xdccb6d872bbaa8db", "kind": "interface",
"name": "AllKindsEvents", "members": [{"at": 0, "name": "state", "parameters": [{"at": 0,
"name": "row", "is": "@0xf9cad0ab043d03c9"}]}, {"at": 1, "name": "cleared"}, {"at": 2,
"name": "scalarSet", "parameters": [{"at": 0, "name": "value", "is": "Float64"}]}, {"at": 3,
"name": "vectorSet", "parameters": [{"at": 0, "name": "value", "is": "/suture/types.capnp:Vec3"}]},
{"at": 4, "name": "recordSet", "parameters": [{"at": 0, "name": "value", "is": "@0xedd17c97b8723561"
}]}, {"at": 5, "name": "textSet", "parameters": [{"at": 0, "name": "value", "is": "Text"}]}]}, {
"id": "@0xf9cad0ab043d03c9", "kind": "struct", "name": "AllKindsStateRow", "members": [{"at": 0,
"name": "stamp", "is": "Int64"}, {"at": 1, "name": "evaluated", "is": "UInt64"}, {"at": 2,
"name": "tooLarge", "is": "UInt64"}, {"at": 3, "name": "scalar", "is": "Float64"}, {"at": 4,
"name": "vector", "is": "/suture/types.capnp:Vec3"}, {"at": 5, "name": "record",
"is": "@0xedd17c97b8723561"}, {"at": 6, "name": "text", "is": "Text"}]}, {
"id": "@0xedd17c97b8723561", "kind": "struct", "name": "PosePrm", "members": [{"at": 0,
"name": "timestamp", "is": "Int64 clock \"steady\""}, {"at": 1, "name": "automaticTimestamp",
"is": "Bool = true"}, {"at": 2, "name": "valid", "is": "Bool"}, {"at": 3, "name": "movingFrame",
"is": "Text"}, {"at": 4, "name": "referenceFrame", "is": "Text"}, {"at": 5, "name": "position",
"is": "/suture/types.capnp:Pose unit \"m\""}]}]})json";

}  // namespace
}  // namespace scenarios

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<scenarios::AllKinds>() {
  static constexpr InterfaceInfo kInfo{
      .name = "scenarios::AllKinds",
      .hash = "6c3eb0727bcc74c29cb02c916019eb6c",
      .description = scenarios::kAllKindsDescription,
      .commands = scenarios::kAllKindsCommands,
      .events = scenarios::kAllKindsEvents,
      .binding = &scenarios::allKindsBinding,
  };
  return kInfo;
}

auto Provided<scenarios::AllKinds>::Scratch::reserved() -> Scratch {
  Scratch scratch{};
  reserveFor<decltype(scenarios::AllKindsSetRecordArguments::value)>(scratch.set_record_value);
  reserveFor<decltype(scenarios::AllKindsSetTextArguments::value)>(scratch.set_text_value);
  reserveFor<decltype(scenarios::AllKindsTwiceRecordArguments::value)>(scratch.twice_record_value);
  reserveFor<decltype(scenarios::AllKindsTwiceTextArguments::value)>(scratch.twice_text_value);
  reserveFor<decltype(scenarios::AllKindsSwapRecordArguments::value)>(scratch.swap_record_value);
  reserveFor<decltype(scenarios::AllKindsSwapTextArguments::value)>(scratch.swap_text_value);
  return scratch;
}

Errc Provided<scenarios::AllKinds>::execute(std::uint16_t command, const std::byte* arguments,
                                            std::byte* result) {
  using ::scenarios::AllKindsCommand;
  switch (static_cast<AllKindsCommand>(command)) {
    case AllKindsCommand::clear: {
      implementation_.clear();
      return Errc{};
    }
    case AllKindsCommand::set_scalar: {
      const auto& slot = slotIn<scenarios::AllKindsSetScalarArguments>(arguments);
      load(slot.value, scratch_.set_scalar_value);
      implementation_.set_scalar(scratch_.set_scalar_value);
      return Errc{};
    }
    case AllKindsCommand::set_vector: {
      const auto& slot = slotIn<scenarios::AllKindsSetVectorArguments>(arguments);
      load(slot.value, scratch_.set_vector_value);
      implementation_.set_vector(scratch_.set_vector_value);
      return Errc{};
    }
    case AllKindsCommand::set_record: {
      const auto& slot = slotIn<scenarios::AllKindsSetRecordArguments>(arguments);
      load(slot.value, scratch_.set_record_value);
      implementation_.set_record(scratch_.set_record_value);
      return Errc{};
    }
    case AllKindsCommand::set_text: {
      const auto& slot = slotIn<scenarios::AllKindsSetTextArguments>(arguments);
      load(slot.value, scratch_.set_text_value);
      implementation_.set_text(scratch_.set_text_value);
      return Errc{};
    }
    case AllKindsCommand::scalar: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.scalar(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::vector: {
      auto& slot = newSlot<std::array<double, 3>>(result);
      return store(implementation_.vector(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::record: {
      auto& slot = newSlot<robots::PosePrmSlot>(result);
      return store(implementation_.record(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::text: {
      auto& slot = newSlot<suture::BoundedText<31>>(result);
      return store(implementation_.text(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::twice_scalar: {
      const auto& slot = slotIn<scenarios::AllKindsTwiceScalarArguments>(arguments);
      load(slot.value, scratch_.twice_scalar_value);
      auto& answer = newSlot<double>(result);
      return store(implementation_.twice_scalar(scratch_.twice_scalar_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::twice_vector: {
      const auto& slot = slotIn<scenarios::AllKindsTwiceVectorArguments>(arguments);
      load(slot.value, scratch_.twice_vector_value);
      auto& answer = newSlot<std::array<double, 3>>(result);
      return store(implementation_.twice_vector(scratch_.twice_vector_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::twice_record: {
      const auto& slot = slotIn<scenarios::AllKindsTwiceRecordArguments>(arguments);
      load(slot.value, scratch_.twice_record_value);
      auto& answer = newSlot<robots::PosePrmSlot>(result);
      return store(implementation_.twice_record(scratch_.twice_record_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::twice_text: {
      const auto& slot = slotIn<scenarios::AllKindsTwiceTextArguments>(arguments);
      load(slot.value, scratch_.twice_text_value);
      auto& answer = newSlot<suture::BoundedText<31>>(result);
      return store(implementation_.twice_text(scratch_.twice_text_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::take_scalar: {
      auto& slot = newSlot<double>(result);
      return store(implementation_.take_scalar(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::take_vector: {
      auto& slot = newSlot<std::array<double, 3>>(result);
      return store(implementation_.take_vector(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::take_record: {
      auto& slot = newSlot<robots::PosePrmSlot>(result);
      return store(implementation_.take_record(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::take_text: {
      auto& slot = newSlot<suture::BoundedText<31>>(result);
      return store(implementation_.take_text(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::swap_scalar: {
      const auto& slot = slotIn<scenarios::AllKindsSwapScalarArguments>(arguments);
      load(slot.value, scratch_.swap_scalar_value);
      auto& answer = newSlot<double>(result);
      return store(implementation_.swap_scalar(scratch_.swap_scalar_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::swap_vector: {
      const auto& slot = slotIn<scenarios::AllKindsSwapVectorArguments>(arguments);
      load(slot.value, scratch_.swap_vector_value);
      auto& answer = newSlot<std::array<double, 3>>(result);
      return store(implementation_.swap_vector(scratch_.swap_vector_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::swap_record: {
      const auto& slot = slotIn<scenarios::AllKindsSwapRecordArguments>(arguments);
      load(slot.value, scratch_.swap_record_value);
      auto& answer = newSlot<robots::PosePrmSlot>(result);
      return store(implementation_.swap_record(scratch_.swap_record_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::swap_text: {
      const auto& slot = slotIn<scenarios::AllKindsSwapTextArguments>(arguments);
      load(slot.value, scratch_.swap_text_value);
      auto& answer = newSlot<suture::BoundedText<31>>(result);
      return store(implementation_.swap_text(scratch_.swap_text_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
