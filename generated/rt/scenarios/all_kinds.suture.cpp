// Written by suturec from rt/scenarios/all_kinds.h. Do not edit.
#include "rt/scenarios/all_kinds.suture.h"

#include <suture/transport/rpc/binding.h>
#include <suture/transport/rpc/proxy_port.h>
#include <suture/transport/rpc/servant_port.h>
#include <suture/transport/rpc/wire.h>

#include <type_traits>

#include "rt/scenarios/all_kinds.capnp.h"

// Defined in robot_types/pose.suture.cpp.
namespace robots {
void toWire(const PosePrmSlot& slot, wire::PosePrm::Builder out);
suture::Errc fromWire(wire::PosePrm::Reader in, PosePrmSlot& slot, suture::Duration shift);
bool isValid(const PosePrmSlot& slot);
}  // namespace robots

namespace scenarios {

using suture::CommandInfo;
using suture::CommandKind;
using suture::Errc;
using suture::EventInfo;
using suture::rpc::ProxyPort;
using suture::rpc::ServantPort;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::numberOf;
using suture::rpc::toWire;
using suture::store;

namespace {

constexpr CommandInfo kAllKindsCommands[] = {
    {.name = "clear", .kind = CommandKind::Void, .depth = 16},
    {.name = "set_scalar",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(AllKindsSetScalarArguments),
     .depth = 16},
    {.name = "set_vector",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(AllKindsSetVectorArguments),
     .depth = 16},
    {.name = "set_record",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(AllKindsSetRecordArguments),
     .depth = 16},
    {.name = "set_text",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(AllKindsSetTextArguments),
     .depth = 16},
    {.name = "scalar",
     .kind = CommandKind::Read,
     .resultSize = sizeof(double),
     .depth = 16,
     .column = 0},
    {.name = "vector",
     .kind = CommandKind::Read,
     .resultSize = sizeof(std::array<double, 3>),
     .depth = 16,
     .column = 1},
    {.name = "record",
     .kind = CommandKind::Read,
     .resultSize = sizeof(robots::PosePrmSlot),
     .depth = 16,
     .column = 2},
    {.name = "text",
     .kind = CommandKind::Read,
     .resultSize = sizeof(suture::BoundedText<31>),
     .depth = 16,
     .column = 3},
    {.name = "twice_scalar",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = sizeof(AllKindsTwiceScalarArguments),
     .resultSize = sizeof(double),
     .depth = 16},
    {.name = "twice_vector",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = sizeof(AllKindsTwiceVectorArguments),
     .resultSize = sizeof(std::array<double, 3>),
     .depth = 16},
    {.name = "twice_record",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = sizeof(AllKindsTwiceRecordArguments),
     .resultSize = sizeof(robots::PosePrmSlot),
     .depth = 16},
    {.name = "twice_text",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = sizeof(AllKindsTwiceTextArguments),
     .resultSize = sizeof(suture::BoundedText<31>),
     .depth = 16},
    {.name = "take_scalar",
     .kind = CommandKind::VoidReturn,
     .resultSize = sizeof(double),
     .depth = 16},
    {.name = "take_vector",
     .kind = CommandKind::VoidReturn,
     .resultSize = sizeof(std::array<double, 3>),
     .depth = 16},
    {.name = "take_record",
     .kind = CommandKind::VoidReturn,
     .resultSize = sizeof(robots::PosePrmSlot),
     .depth = 16},
    {.name = "take_text",
     .kind = CommandKind::VoidReturn,
     .resultSize = sizeof(suture::BoundedText<31>),
     .depth = 16},
    {.name = "swap_scalar",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = sizeof(AllKindsSwapScalarArguments),
     .resultSize = sizeof(double),
     .depth = 16},
    {.name = "swap_vector",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = sizeof(AllKindsSwapVectorArguments),
     .resultSize = sizeof(std::array<double, 3>),
     .depth = 16},
    {.name = "swap_record",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = sizeof(AllKindsSwapRecordArguments),
     .resultSize = sizeof(robots::PosePrmSlot),
     .depth = 16},
    {.name = "swap_text",
     .kind = CommandKind::WriteReturn,
     .argumentsSize = sizeof(AllKindsSwapTextArguments),
     .resultSize = sizeof(suture::BoundedText<31>),
     .depth = 16},
};

constexpr EventInfo kAllKindsEvents[] = {
    {.name = "cleared", .depth = 16},
    {.name = "scalar_set", .payloadSize = sizeof(double), .depth = 16},
    {.name = "vector_set", .payloadSize = sizeof(std::array<double, 3>), .depth = 16},
    {.name = "record_set", .payloadSize = sizeof(robots::PosePrmSlot), .depth = 16},
    {.name = "text_set", .payloadSize = sizeof(suture::BoundedText<31>), .depth = 16},
};

// The self-description, as in rt/scenarios/all_kinds.suture.json.
constexpr char kAllKindsDescription[] = R"json(
{"name": "scenarios::AllKinds", "hash": "6c3eb0727bcc74c29cb02c916019eb6c", "commands": [{
"name": "clear", "kind": "void", "doc": "Forgets all values. void", "queue": 16}, {
"name": "set_scalar", "kind": "write", "wire": "setScalar",
"doc": "Write: keep a value and tell it.", "parameters": [{"name": "value", "type": {
"kind": "Float64"}}], "queue": 16}, {"name": "set_vector", "kind": "write", "wire": "setVector",
"parameters": [{"name": "value", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3,
"columns": 1}}], "queue": 16}, {"name": "set_record", "kind": "write", "wire": "setRecord",
"parameters": [{"name": "value", "type": {"kind": "struct", "name": "robots::PosePrm"}}],
"queue": 16}, {"name": "set_text", "kind": "write", "wire": "setText", "parameters": [{
"name": "value", "type": {"kind": "text", "capacity": 31}}], "queue": 16}, {"name": "scalar",
"kind": "read", "doc": "Read: the value kept.", "result": {"type": {"kind": "Float64"}}, "queue": 16
}, {"name": "vector", "kind": "read", "result": {"type": {"kind": "matrix", "scalar": "Float64",
"rows": 3, "columns": 1}}, "queue": 16}, {"name": "record", "kind": "read", "result": {"type": {
"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}, {"name": "text", "kind": "read",
"result": {"type": {"kind": "text", "capacity": 31}}, "queue": 16}, {"name": "twice_scalar",
"kind": "qualified read", "wire": "twiceScalar", "doc": "Qualified read: twice the value given.",
"parameters": [{"name": "value", "type": {"kind": "Float64"}}], "result": {"type": {
"kind": "Float64"}}, "queue": 16}, {"name": "twice_vector", "kind": "qualified read",
"wire": "twiceVector", "parameters": [{"name": "value", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}}], "result": {"type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16}, {"name": "twice_record",
"kind": "qualified read", "wire": "twiceRecord", "parameters": [{"name": "value", "type": {
"kind": "struct", "name": "robots::PosePrm"}}], "result": {"type": {"kind": "struct",
"name": "robots::PosePrm"}}, "queue": 16}, {"name": "twice_text", "kind": "qualified read",
"wire": "twiceText", "parameters": [{"name": "value", "type": {"kind": "text", "capacity": 15}}],
"result": {"type": {"kind": "text", "capacity": 31}}, "queue": 16}, {"name": "take_scalar",
"kind": "void with return", "wire": "takeScalar",
"doc": "Void with return: the value kept, and forgets it.", "result": {"type": {"kind": "Float64"}
}, "queue": 16}, {"name": "take_vector", "kind": "void with return", "wire": "takeVector",
"result": {"type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16},
{"name": "take_record", "kind": "void with return", "wire": "takeRecord", "result": {"type": {
"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}, {"name": "take_text",
"kind": "void with return", "wire": "takeText", "result": {"type": {"kind": "text", "capacity": 31}
}, "queue": 16}, {"name": "swap_scalar", "kind": "write with return", "wire": "swapScalar",
"doc": "Write with return: keep a value, answer the one before.", "parameters": [{"name": "value",
"type": {"kind": "Float64"}}], "result": {"type": {"kind": "Float64"}}, "queue": 16}, {
"name": "swap_vector", "kind": "write with return", "wire": "swapVector", "parameters": [{
"name": "value", "type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}}],
"result": {"type": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16},
{"name": "swap_record", "kind": "write with return", "wire": "swapRecord", "parameters": [{
"name": "value", "type": {"kind": "struct", "name": "robots::PosePrm"}}], "result": {"type": {
"kind": "struct", "name": "robots::PosePrm"}}, "queue": 16}, {"name": "swap_text",
"kind": "write with return", "wire": "swapText", "parameters": [{"name": "value", "type": {
"kind": "text", "capacity": 31}}], "result": {"type": {"kind": "text", "capacity": 31}}, "queue": 16
}], "events": [{"name": "cleared", "kind": "void", "doc": "All values are forgotten. void",
"queue": 16}, {"name": "scalar_set", "kind": "write", "wire": "scalarSet",
"doc": "Write: a value has been set.", "payload": {"type": {"kind": "Float64"}}, "queue": 16}, {
"name": "vector_set", "kind": "write", "wire": "vectorSet", "payload": {"type": {"kind": "matrix",
"scalar": "Float64", "rows": 3, "columns": 1}}, "queue": 16}, {"name": "record_set",
"kind": "write", "wire": "recordSet", "payload": {"type": {"kind": "struct",
"name": "robots::PosePrm"}}, "queue": 16}, {"name": "text_set", "kind": "write", "wire": "textSet",
"payload": {"type": {"kind": "text", "capacity": 31}}, "queue": 16}], "enums": [], "structs": [{
"name": "robots::PosePrm",
"doc": "The fields of the cisst libraries' prmPositionCartesianGet, the type of the paper's\nmeasurements.",
"fields": [{"name": "timestamp", "type": {"kind": "time", "clock": "steady"}}, {
"name": "automatic_timestamp", "wire": "automaticTimestamp",
"doc": "Whether the provider stamps the data itself.", "type": {"kind": "Bool"}, "default": true}, {
"name": "valid", "type": {"kind": "Bool"}, "default": false}, {"name": "moving_frame",
"wire": "movingFrame", "type": {"kind": "text", "capacity": 15}}, {"name": "reference_frame",
"wire": "referenceFrame", "type": {"kind": "text", "capacity": 15}}, {"name": "position",
"doc": "The moving frame in the reference frame.", "type": {"kind": "isometry", "scalar": "Float64"
}, "unit": "m"}]}]})json";

}  // namespace

bool store(const double& value, AllKindsSetScalarArguments& slot) {
  return store(value, slot.value);
}

bool store(const Eigen::Vector3d& value, AllKindsSetVectorArguments& slot) {
  return store(value, slot.value);
}

bool store(const robots::PosePrm& value, AllKindsSetRecordArguments& slot) {
  return store(value, slot.value);
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

bool store(const std::string& value, AllKindsSwapTextArguments& slot) {
  return store(value, slot.value);
}

namespace {

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
        const auto& slot = *reinterpret_cast<const double*>(payload);
        auto request = subscriber_.scalarSetRequest();
        request.setValue(slot);
        return request.send().ignoreResult();
      }
      case numberOf(AllKindsEvent::vector_set): {
        const auto& slot = *reinterpret_cast<const std::array<double, 3>*>(payload);
        auto request = subscriber_.vectorSetRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(AllKindsEvent::record_set): {
        const auto& slot = *reinterpret_cast<const robots::PosePrmSlot*>(payload);
        auto request = subscriber_.recordSetRequest();
        toWire(slot, request.initValue());
        return request.send().ignoreResult();
      }
      case numberOf(AllKindsEvent::text_set): {
        const auto& slot = *reinterpret_cast<const suture::BoundedText<31>*>(payload);
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
    out.setEvaluated(row.valid);
    out.setTooLarge(row.tooLarge);
    if (row.valid >> 0 & 1) {
      const auto& slot = *reinterpret_cast<const double*>(columns[0]);
      out.setScalar(slot);
    }
    if (row.valid >> 1 & 1) {
      const auto& slot = *reinterpret_cast<const std::array<double, 3>*>(columns[1]);
      toWire(slot, out.initVector());
    }
    if (row.valid >> 2 & 1) {
      const auto& slot = *reinterpret_cast<const robots::PosePrmSlot*>(columns[2]);
      toWire(slot, out.initRecord());
    }
    if (row.valid >> 3 & 1) {
      const auto& slot = *reinterpret_cast<const suture::BoundedText<31>*>(columns[3]);
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
      auto& slot = *reinterpret_cast<AllKindsSetScalarArguments*>(memory);
      slot.value = in.getValue();
      return isValid(slot.value) ? Errc{} : Errc::Invalid;
    };
    return port_->command(numberOf(AllKindsCommand::set_scalar), in.getSent(), fill);
  }

  kj::Promise<void> setVector(SetVectorContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<AllKindsSetVectorArguments*>(memory);
      const Errc error = in.hasValue() ? fromWire(in.getValue(), slot.value) : Errc::Invalid;
      if (error != Errc{}) return error;
      return isValid(slot.value) ? Errc{} : Errc::Invalid;
    };
    return port_->command(numberOf(AllKindsCommand::set_vector), in.getSent(), fill);
  }

  kj::Promise<void> setRecord(SetRecordContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<AllKindsSetRecordArguments*>(memory);
      const Errc error =
          in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
      if (error != Errc{}) return error;
      return isValid(slot.value) ? Errc{} : Errc::Invalid;
    };
    return port_->command(numberOf(AllKindsCommand::set_record), in.getSent(), fill);
  }

  kj::Promise<void> setText(SetTextContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<AllKindsSetTextArguments*>(memory);
      return fromWire(in.getValue(), slot.value);
    };
    return port_->command(numberOf(AllKindsCommand::set_text), in.getSent(), fill);
  }

  kj::Promise<void> scalar(ScalarContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time stamp) mutable {
      const auto& slot = *reinterpret_cast<const double*>(result);
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
      const auto& slot = *reinterpret_cast<const std::array<double, 3>*>(result);
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
      const auto& slot = *reinterpret_cast<const robots::PosePrmSlot*>(result);
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
      const auto& slot = *reinterpret_cast<const suture::BoundedText<31>*>(result);
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
      auto& slot = *reinterpret_cast<AllKindsTwiceScalarArguments*>(memory);
      slot.value = in.getValue();
      return isValid(slot.value) ? Errc{} : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const double*>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(numberOf(AllKindsCommand::twice_scalar), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> twiceVector(TwiceVectorContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<AllKindsTwiceVectorArguments*>(memory);
      const Errc error = in.hasValue() ? fromWire(in.getValue(), slot.value) : Errc::Invalid;
      if (error != Errc{}) return error;
      return isValid(slot.value) ? Errc{} : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const std::array<double, 3>*>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::twice_vector), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> twiceRecord(TwiceRecordContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<AllKindsTwiceRecordArguments*>(memory);
      const Errc error =
          in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
      if (error != Errc{}) return error;
      return isValid(slot.value) ? Errc{} : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const robots::PosePrmSlot*>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::twice_record), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> twiceText(TwiceTextContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<AllKindsTwiceTextArguments*>(memory);
      return fromWire(in.getValue(), slot.value);
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const suture::BoundedText<31>*>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue(slot.size));
    };
    return port_->call(numberOf(AllKindsCommand::twice_text), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> takeScalar(TakeScalarContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const double*>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(numberOf(AllKindsCommand::take_scalar), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> takeVector(TakeVectorContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const std::array<double, 3>*>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::take_vector), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> takeRecord(TakeRecordContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const robots::PosePrmSlot*>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::take_record), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> takeText(TakeTextContext context) override {
    auto in = context.getParams();
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const suture::BoundedText<31>*>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue(slot.size));
    };
    return port_->call(numberOf(AllKindsCommand::take_text), in.getSent(),
                       [](std::byte*) { return Errc{}; }, kj::mv(take));
  }

  kj::Promise<void> swapScalar(SwapScalarContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<AllKindsSwapScalarArguments*>(memory);
      slot.value = in.getValue();
      return isValid(slot.value) ? Errc{} : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const double*>(result);
      auto out = context.getResults();
      out.setValue(slot);
    };
    return port_->call(numberOf(AllKindsCommand::swap_scalar), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> swapVector(SwapVectorContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<AllKindsSwapVectorArguments*>(memory);
      const Errc error = in.hasValue() ? fromWire(in.getValue(), slot.value) : Errc::Invalid;
      if (error != Errc{}) return error;
      return isValid(slot.value) ? Errc{} : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const std::array<double, 3>*>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::swap_vector), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> swapRecord(SwapRecordContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<AllKindsSwapRecordArguments*>(memory);
      const Errc error =
          in.hasValue() ? fromWire(in.getValue(), slot.value, port_->shift()) : Errc::Invalid;
      if (error != Errc{}) return error;
      return isValid(slot.value) ? Errc{} : Errc::Invalid;
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const robots::PosePrmSlot*>(result);
      auto out = context.getResults();
      toWire(slot, out.initValue());
    };
    return port_->call(numberOf(AllKindsCommand::swap_record), in.getSent(), fill, kj::mv(take));
  }

  kj::Promise<void> swapText(SwapTextContext context) override {
    auto in = context.getParams();
    const auto fill = [&](std::byte* memory) {
      auto& slot = *reinterpret_cast<AllKindsSwapTextArguments*>(memory);
      return fromWire(in.getValue(), slot.value);
    };
    auto take = [context](const std::byte* result, suture::Time) mutable {
      const auto& slot = *reinterpret_cast<const suture::BoundedText<31>*>(result);
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
    suture::rt::ColumnSet valid = 0;
    if (in.getEvaluated() >> 0 & 1) {
      auto& slot = *reinterpret_cast<double*>(port_->column(0));
      slot = in.getScalar();
      valid |= suture::rt::ColumnSet{1} << 0;
    }
    if (in.getEvaluated() >> 1 & 1) {
      auto& slot = *reinterpret_cast<std::array<double, 3>*>(port_->column(1));
      const Errc error = in.hasVector() ? fromWire(in.getVector(), slot) : Errc::Invalid;
      if (error == Errc{}) valid |= suture::rt::ColumnSet{1} << 1;
    }
    if (in.getEvaluated() >> 2 & 1) {
      auto& slot = *reinterpret_cast<robots::PosePrmSlot*>(port_->column(2));
      const Errc error =
          in.hasRecord() ? fromWire(in.getRecord(), slot, port_->shift()) : Errc::Invalid;
      if (error == Errc{}) valid |= suture::rt::ColumnSet{1} << 2;
    }
    if (in.getEvaluated() >> 3 & 1) {
      auto& slot = *reinterpret_cast<suture::BoundedText<31>*>(port_->column(3));
      const Errc error = fromWire(in.getText(), slot);
      if (error == Errc{}) valid |= suture::rt::ColumnSet{1} << 3;
    }
    port_->publish(in.getStamp(), valid, in.getTooLarge());
    return kj::READY_NOW;
  }

  kj::Promise<void> cleared(ClearedContext) override {
    return port_->event(numberOf(AllKindsEvent::cleared));
  }

  kj::Promise<void> scalarSet(ScalarSetContext context) override {
    auto in = context.getParams();
    double slot;
    slot = in.getValue();
    const Errc error = Errc{};
    return port_->event(numberOf(AllKindsEvent::scalar_set), error, slot);
  }

  kj::Promise<void> vectorSet(VectorSetContext context) override {
    auto in = context.getParams();
    std::array<double, 3> slot;
    const Errc error = in.hasValue() ? fromWire(in.getValue(), slot) : Errc::Invalid;
    return port_->event(numberOf(AllKindsEvent::vector_set), error, slot);
  }

  kj::Promise<void> recordSet(RecordSetContext context) override {
    auto in = context.getParams();
    robots::PosePrmSlot slot;
    const Errc error =
        in.hasValue() ? fromWire(in.getValue(), slot, port_->shift()) : Errc::Invalid;
    return port_->event(numberOf(AllKindsEvent::record_set), error, slot);
  }

  kj::Promise<void> textSet(TextSetContext context) override {
    auto in = context.getParams();
    suture::BoundedText<31> slot;
    const Errc error = fromWire(in.getValue(), slot);
    return port_->event(numberOf(AllKindsEvent::text_set), error, slot);
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
        const auto& slot = *reinterpret_cast<const AllKindsSetScalarArguments*>(record.arguments());
        auto request = provider_.setScalarRequest();
        request.setValue(slot.value);
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case AllKindsCommand::set_vector: {
        const auto& slot = *reinterpret_cast<const AllKindsSetVectorArguments*>(record.arguments());
        auto request = provider_.setVectorRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case AllKindsCommand::set_record: {
        const auto& slot = *reinterpret_cast<const AllKindsSetRecordArguments*>(record.arguments());
        auto request = provider_.setRecordRequest();
        toWire(slot.value, request.initValue());
        suture::rpc::fill(request.initSent(), record);
        return request.send().then([this, call = record.call](auto&&) { port_.answer(call); });
      }
      case AllKindsCommand::set_text: {
        const auto& slot = *reinterpret_cast<const AllKindsSetTextArguments*>(record.arguments());
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
        const auto& slot =
            *reinterpret_cast<const AllKindsTwiceScalarArguments*>(record.arguments());
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
        const auto& slot =
            *reinterpret_cast<const AllKindsTwiceVectorArguments*>(record.arguments());
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
        const auto& slot =
            *reinterpret_cast<const AllKindsTwiceRecordArguments*>(record.arguments());
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
        const auto& slot = *reinterpret_cast<const AllKindsTwiceTextArguments*>(record.arguments());
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
        const auto& slot =
            *reinterpret_cast<const AllKindsSwapScalarArguments*>(record.arguments());
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
        const auto& slot =
            *reinterpret_cast<const AllKindsSwapVectorArguments*>(record.arguments());
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
        const auto& slot =
            *reinterpret_cast<const AllKindsSwapRecordArguments*>(record.arguments());
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
        const auto& slot = *reinterpret_cast<const AllKindsSwapTextArguments*>(record.arguments());
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
};

const suture::rpc::Binding& allKindsBinding() {
  static const AllKindsBinding kBinding;
  return kBinding;
}

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

Errc Provided<scenarios::AllKinds>::execute(std::uint16_t command, const std::byte* arguments,
                                            std::byte* result) {
  using ::scenarios::AllKindsCommand;
  switch (static_cast<AllKindsCommand>(command)) {
    case AllKindsCommand::clear: {
      implementation_.clear();
      return Errc{};
    }
    case AllKindsCommand::set_scalar: {
      const auto& slot = *reinterpret_cast<const scenarios::AllKindsSetScalarArguments*>(arguments);
      load(slot.value, scratch_.set_scalar_value);
      implementation_.set_scalar(scratch_.set_scalar_value);
      return Errc{};
    }
    case AllKindsCommand::set_vector: {
      const auto& slot = *reinterpret_cast<const scenarios::AllKindsSetVectorArguments*>(arguments);
      load(slot.value, scratch_.set_vector_value);
      implementation_.set_vector(scratch_.set_vector_value);
      return Errc{};
    }
    case AllKindsCommand::set_record: {
      const auto& slot = *reinterpret_cast<const scenarios::AllKindsSetRecordArguments*>(arguments);
      load(slot.value, scratch_.set_record_value);
      implementation_.set_record(scratch_.set_record_value);
      return Errc{};
    }
    case AllKindsCommand::set_text: {
      const auto& slot = *reinterpret_cast<const scenarios::AllKindsSetTextArguments*>(arguments);
      load(slot.value, scratch_.set_text_value);
      implementation_.set_text(scratch_.set_text_value);
      return Errc{};
    }
    case AllKindsCommand::scalar: {
      auto& slot = *reinterpret_cast<double*>(result);
      return store(implementation_.scalar(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::vector: {
      auto& slot = *reinterpret_cast<std::array<double, 3>*>(result);
      return store(implementation_.vector(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::record: {
      auto& slot = *reinterpret_cast<robots::PosePrmSlot*>(result);
      return store(implementation_.record(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::text: {
      auto& slot = *reinterpret_cast<suture::BoundedText<31>*>(result);
      return store(implementation_.text(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::twice_scalar: {
      const auto& slot =
          *reinterpret_cast<const scenarios::AllKindsTwiceScalarArguments*>(arguments);
      load(slot.value, scratch_.twice_scalar_value);
      auto& answer = *reinterpret_cast<double*>(result);
      return store(implementation_.twice_scalar(scratch_.twice_scalar_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::twice_vector: {
      const auto& slot =
          *reinterpret_cast<const scenarios::AllKindsTwiceVectorArguments*>(arguments);
      load(slot.value, scratch_.twice_vector_value);
      auto& answer = *reinterpret_cast<std::array<double, 3>*>(result);
      return store(implementation_.twice_vector(scratch_.twice_vector_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::twice_record: {
      const auto& slot =
          *reinterpret_cast<const scenarios::AllKindsTwiceRecordArguments*>(arguments);
      load(slot.value, scratch_.twice_record_value);
      auto& answer = *reinterpret_cast<robots::PosePrmSlot*>(result);
      return store(implementation_.twice_record(scratch_.twice_record_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::twice_text: {
      const auto& slot = *reinterpret_cast<const scenarios::AllKindsTwiceTextArguments*>(arguments);
      load(slot.value, scratch_.twice_text_value);
      auto& answer = *reinterpret_cast<suture::BoundedText<31>*>(result);
      return store(implementation_.twice_text(scratch_.twice_text_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::take_scalar: {
      auto& slot = *reinterpret_cast<double*>(result);
      return store(implementation_.take_scalar(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::take_vector: {
      auto& slot = *reinterpret_cast<std::array<double, 3>*>(result);
      return store(implementation_.take_vector(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::take_record: {
      auto& slot = *reinterpret_cast<robots::PosePrmSlot*>(result);
      return store(implementation_.take_record(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::take_text: {
      auto& slot = *reinterpret_cast<suture::BoundedText<31>*>(result);
      return store(implementation_.take_text(), slot) ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::swap_scalar: {
      const auto& slot =
          *reinterpret_cast<const scenarios::AllKindsSwapScalarArguments*>(arguments);
      load(slot.value, scratch_.swap_scalar_value);
      auto& answer = *reinterpret_cast<double*>(result);
      return store(implementation_.swap_scalar(scratch_.swap_scalar_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::swap_vector: {
      const auto& slot =
          *reinterpret_cast<const scenarios::AllKindsSwapVectorArguments*>(arguments);
      load(slot.value, scratch_.swap_vector_value);
      auto& answer = *reinterpret_cast<std::array<double, 3>*>(result);
      return store(implementation_.swap_vector(scratch_.swap_vector_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::swap_record: {
      const auto& slot =
          *reinterpret_cast<const scenarios::AllKindsSwapRecordArguments*>(arguments);
      load(slot.value, scratch_.swap_record_value);
      auto& answer = *reinterpret_cast<robots::PosePrmSlot*>(result);
      return store(implementation_.swap_record(scratch_.swap_record_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
    case AllKindsCommand::swap_text: {
      const auto& slot = *reinterpret_cast<const scenarios::AllKindsSwapTextArguments*>(arguments);
      load(slot.value, scratch_.swap_text_value);
      auto& answer = *reinterpret_cast<suture::BoundedText<31>*>(result);
      return store(implementation_.swap_text(scratch_.swap_text_value), answer)
          ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
