#include <utility>
#include <vector>

#include "compiler/emit/text/contract.h"
#include "compiler/emit/wire/later_parameters.h"
#include "compiler/emit/wire/remote.h"
#include "compiler/emit/wire/wire_form.h"
#include "compiler/emit/wire/wire_places.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

std::string home(const Context& context) { return context.header.cxxNamespace; }

// --- events and rows to the subscriber

void emitSinkCase(Code& code, const Context& context, const model::Interface& interface,
                  const model::Event& event) {
  code.open("case ", eventNumber(interface, event, home(context)), ": {");
  if (event.payload.empty()) {
    code.line("return subscriber_.", event.wireName, "Request()", kBreakText,
              ".send().ignoreResult();");
  } else {
    code.line("const auto& slot = ", kBreakText, "slotIn<",
              payloadSlot(interface, event, context, home(context)), ">(payload);");
    code.line("auto request = subscriber_.", event.wireName, "Request();");
    for (const WireValue& value : payloadValues(event)) {
      code.line(encode(value, "request", context), ";");
    }
    code.line("return request.send().ignoreResult();");
  }
  code.close("}");
}

void emitSinkEvent(Code& code, const Context& context, const model::Interface& interface) {
  if (interface.events.empty()) {
    code.line("kj::Promise<void> event(std::uint16_t, const std::byte*) override {",
              lambdaBody("return kj::READY_NOW;"), "}");
    return;
  }
  bool carries = false;
  for (const model::Event& event : interface.events) carries = carries || !event.payload.empty();
  code.open("kj::Promise<void> event(std::uint16_t event, const std::byte*",
            carries ? " payload" : "", ") override {");
  code.open("switch (event) {");
  for (const model::Event& event : interface.events) emitSinkCase(code, context, interface, event);
  code.close("}").line("return kj::READY_NOW;").close("}");
}

void emitSinkRow(Code& code, const Context& context, const model::Interface& interface) {
  const std::vector<const model::Command*> reads = readsOf(interface);
  code.line("kj::Promise<void> row(const suture::rt::StateTable::Row& row,");
  code.open("                      std::span<const std::byte* const>",
            reads.empty() ? "" : " columns", ") override {");
  code.line("auto request = subscriber_.stateRequest();").line("auto out = request.initRow();");
  code.line("out.setStamp(suture::toNanoseconds(row.stamp));");
  code.line("out.setEvaluated(", kBreakText,
            columnsToWire(context, interface, "row.valid | row.invalid"), ");");
  code.line("out.setTooLarge(", kBreakText,
            columnsToWire(context, interface, "row.tooLarge | row.invalid"), ");");
  for (std::size_t i = 0; i < reads.size(); ++i) {
    const std::string column = std::to_string(i);
    const model::Type& type = *reads[i]->result;
    code.open("if (row.hasValue(", column, ")) {");
    code.line("const auto& slot = ", kBreakText, "slotIn<", slotType(type, context, home(context)),
              ">(columns[", column, "]);");
    code.line(encode({type, reads[i]->wireName, "slot", {}}, "out", context), ";").close("}");
  }
  code.line("return request.send().ignoreResult();").close("}");
}

void emitSink(Code& code, const Context& context, const model::Interface& interface) {
  const std::string name = prefixOf(interface) + "Sink";
  const std::string client = "wire::" + interface.wireName + "Events::Client";
  code.line("/// Makes remote calls of a subscriber's events and rows.");
  code.open("class ", name, " final : public suture::rpc::EventSink {").label("public:");
  code.line("explicit ", name, "(", client, " subscriber) : ", kBreakText,
            "subscriber_(kj::mv(subscriber)) {}");
  code.blank();
  emitSinkEvent(code, context, interface);
  code.blank();
  emitSinkRow(code, context, interface);
  code.blank().label("private:").line(client, " subscriber_;").close("};").blank();
}

/// Passes calls through a contract that this one derives from to that one's servant: its commands,
/// events and columns are the first of this one's.
void emitDispatch(Code& code, const model::Interface& interface) {
  if (interface.base.empty()) return;
  const std::string server = "wire::" + interface.wireName;
  code.open("DispatchCallResult dispatchCall(", kBreakText, "std::uint64_t contract, ", kBreakText,
            "std::uint16_t method, ", kBreakText, "suture::rpc::AnyCall call) override {");
  code.line("if (contract != capnp::typeId<", server, ">()) {");
  code.line("  return base_->dispatchCall(contract, method, call);").line("}");
  code.line("return ", server, "::Server::dispatchCall(contract, method, call);");
  code.close("}").blank();
}

void emitServantConstructor(Code& code, const model::Interface& interface) {
  const std::string head = "explicit " + prefixOf(interface) + "Servant(kj::Own<ServantPort> port)";
  code.label("public:");
  if (interface.base.empty()) {
    code.line(head, " : port_(kj::mv(port)) {}");
    return;
  }
  code.line(head);
  code.line("    : base_(suture::interfaceInfo<", interface.base, ">().binding().makeServant(",
            kBreakText, "kj::addRef(*port))),");
  code.line("      port_(kj::mv(port)) {}");
}

// --- what every lane asks of values before a handler sees them

/// Emits the checks of a contract; those that fit on a line stand close together.
class Checks {
 public:
  Checks(Code& code, const Context& context) : code_(code), context_(context) {}

  void add(const std::string& check, const std::string& slot,
           const std::vector<WireValue>& values) {
    if (check.empty() || isStructCheck(check)) return;
    const std::string head =
        "bool " + check + "(" + validityParameters(slot, values, context_) + ") {";
    Code body;
    emitValidity(body, values, context_);
    const std::string line = head + " " + body.text().substr(0, body.text().find('\n')) + " }";
    const bool isOneLine = line.size() == head.size() + body.text().size() + 2;
    if (isOneLine && line.size() - 1 <= Code::kColumns) {  // without the break in the head
      code_.line(line);
      close_ = true;
      return;
    }
    end();
    code_.open(head);
    emitValidity(code_, values, context_);
    code_.close("}").blank();
  }
  void end() {
    if (std::exchange(close_, false)) code_.blank();
  }

 private:
  Code& code_;
  const Context& context_;
  bool close_ = false;  // to what follows
};

void emitChecks(Code& code, const Context& context, const model::Interface& interface) {
  Checks checks(code, context);
  for (const model::Command* const command : ownCommands(interface)) {
    checks.add(argumentsCheck(interface, *command, context),
               relative(argumentsStruct(interface, *command), home(context)),
               argumentValues(*command));
    if (command->result) {
      checks.add(resultCheck(interface, *command, context),
                 slotType(*command->result, context, home(context)), resultValues(*command));
    }
  }
  for (const model::Event* const event : ownEvents(interface)) {
    checks.add(payloadCheck(interface, *event, context),
               payloadSlot(interface, *event, context, home(context)), payloadValues(*event));
  }
  checks.end();
}

// --- commands from the client

/// The lambda that fills the arguments' slot from `in`.
void emitFill(Code& code, const Context& context, const model::Interface& interface,
              const model::Command& command) {
  code.open("const auto fill = [&](std::byte* memory) {");
  code.line("auto& slot = ", kBreakText, "newSlot<",
            relative(argumentsStruct(interface, command), home(context)), ">(memory);");
  const std::set<std::string> later = laterParameters(context, interface, command);
  std::vector<WireValue> values = argumentValues(command);
  for (WireValue& value : values) value.isNeeded = !later.contains(value.wireName);
  emitDecodeAndReturn(code, values, "in", "port_->shift()", context);
  code.close("};");
}

/// The lambda that turns the result's slot into the answer.
void emitTake(Code& code, const Context& context, const model::Command& command) {
  const model::Type& type = *command.result;
  const bool stamped = command.kind == model::CommandKind::Read;
  code.open("auto take = [context](const std::byte* result, suture::Time", stamped ? " stamp" : "",
            ") mutable {");
  code.line("const auto& slot = ", kBreakText, "slotIn<", slotType(type, context, home(context)),
            ">(result);");
  code.line("auto out = context.getResults();");
  code.line(encode({type, "value", "slot", {}}, "out", context), ";");
  if (stamped) code.line("out.setStamp(suture::toNanoseconds(stamp));");
  code.close("};");
}

void emitMethod(Code& code, const Context& context, const model::Interface& interface,
                const model::Command& command) {
  code.open("kj::Promise<void> ", command.wireName, "(", model::titleCase(command.wireName),
            "Context context) override {");
  code.line("auto in = context.getParams();");
  const bool takes = !command.parameters.empty();
  if (takes) emitFill(code, context, interface, command);
  if (command.result) emitTake(code, context, command);
  code.line("return port_->", command.result ? "call(" : "command(", kBreakText, "numberOf(",
            prefixOf(interface), "Command::", command.name, "), ", kBreakText, "in.getSent(), ",
            kBreakText, takes ? "fill" : "[](std::byte*) { return Errc{}; }",
            command.result ? ", kj::mv(take));" : ");");
  code.close("}").blank();
}

}  // namespace

void emitServant(Code& code, const Context& context, const model::Interface& interface) {
  const std::string prefix = prefixOf(interface);
  emitChecks(code, context, interface);
  code.line("// --- ", prefix, " over Cap'n Proto RPC: the provider's side").blank();
  emitSink(code, context, interface);
  code.line("/// Puts remote calls into the provider's mailbox.");
  code.open("class ", prefix, "Servant final : public wire::", interface.wireName, "::Server {");
  emitServantConstructor(code, interface);
  code.blank();
  emitDispatch(code, interface);
  code.label("protected:");
  code.open("kj::Promise<void> subscribe(SubscribeContext context) override {");
  code.line("auto in = context.getParams();");
  code.line("port_->subscribe(kj::heap<", prefix, "Sink>(in.getEvents()), ", kBreakText,
            eventsFromWire(context, interface, "in.getEventMask()"), ", ", kBreakText,
            columnsFromWire(context, interface, "in.getStateMask()"), ");");
  code.line("return kj::READY_NOW;").close("}").blank();
  const std::vector<const model::Command*> own = ownCommands(interface);
  for (const model::Command* const command : own) emitMethod(code, context, interface, *command);
  code.label("private:");
  if (!interface.base.empty()) code.line("kj::Own<capnp::Capability::Server> base_;");
  code.line("kj::Own<ServantPort> port_;").close("};").blank();
}

}  // namespace suture::compiler::emit
