#include <vector>

#include "compiler/emit/text/contract.h"
#include "compiler/emit/wire/remote.h"
#include "compiler/emit/wire/wire_form.h"
#include "compiler/emit/wire/wire_places.h"
#include "compiler/lock/schema/composites.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

std::string home(const Context& context) { return context.header.cxxNamespace; }

/// Every provider sends this, so a message without it is wrong.
WireValue needed(const model::Type& type, const std::string& wireName, const std::string& slot) {
  return {.type = type, .wireName = wireName, .slot = slot, .isNeeded = true};
}

// --- events and rows from the provider

void emitColumn(Code& code, const Context& context, const model::Command& read, std::size_t i) {
  const std::string column = std::to_string(i);
  code.open("if (columns.hasValue(", column, ")) {");
  code.line("auto& slot = ", kBreakText, "port_->column<",
            slotType(*read.result, context, home(context)), ">(", column, ");");
  const std::string outcome = emitDecode(code, {needed(*read.result, read.wireName, "slot")}, "in",
                                         "port_->shift()", context);
  if (outcome != "Errc{}") {
    emitError(code, outcome);
    code.line("columns.enter(", column, ", error);");
  }
  code.close("}");
}

void emitState(Code& code, const Context& context, const model::Interface& interface) {
  code.open("kj::Promise<void> state(StateContext context) override {");
  code.line("auto in = context.getParams().getRow();");
  code.line("auto columns = ", kBreakText, "port_->columnsOf(",
            columnsFromWire(context, interface, "in.getEvaluated()"), ", ", kBreakText,
            columnsFromWire(context, interface, "in.getTooLarge()"), ");");
  const std::vector<const model::Command*> reads = readsOf(interface);
  for (std::size_t i = 0; i < reads.size(); ++i) emitColumn(code, context, *reads[i], i);
  code.line("port_->publish(in.getStamp(), columns);").line("return kj::READY_NOW;").close("}");
}

void emitEvent(Code& code, const Context& context, const model::Interface& interface,
               const model::Event& event) {
  const std::string id = eventNumber(interface, event, home(context));
  const bool carries = !event.payload.empty();
  code.blank().open("kj::Promise<void> ", event.wireName, "(", model::titleCase(event.wireName),
                    carries ? "Context context) override {" : "Context) override {");
  if (carries) {
    const std::string slot = payloadSlot(interface, event, context, home(context));
    code.line("auto in = context.getParams();");
    code.open("return port_->event<", slot, ">(", id, ", ", kBreakText, "[&](", slot, "& slot) {");
    emitDecodeAndReturn(code, payloadValues(event), "in", "port_->shift()", context);
    code.close("});");
  } else {
    code.line("return port_->event(", id, ");");
  }
  code.close("}");
}

void emitReceiver(Code& code, const Context& context, const model::Interface& interface) {
  const std::string prefix = prefixOf(interface);
  code.line("/// Receives events and rows.");
  code.open("class ", prefix, "Receiver final : public wire::", interface.wireName,
            "Events::Server {");
  code.label("public:").line("explicit ", prefix,
                             "Receiver(kj::Own<ProxyPort> port) : port_(kj::mv(port)) {}");
  code.blank().label("protected:");
  emitState(code, context, interface);
  for (const model::Event& event : interface.events) emitEvent(code, context, interface, event);
  code.blank().label("private:");
  code.line("kj::Own<ProxyPort> port_;").close("};").blank();
}

// --- commands to the provider

void emitAnswer(Code& code, const Context& context, const model::Command& command) {
  const model::Type& type = *command.result;
  const char* const stamp = command.kind == model::CommandKind::Read ? "response.getStamp(), " : "";
  const std::string slot = slotType(type, context, home(context));
  code.open("return request.send().then([this, call = record.call](auto&& response) {");
  // The slot of a composite has a long name: leave it to `auto`.
  const std::string answer = lock::isComposite(type) ? "auto" : slot;
  code.open("port_.answer<", slot, ">(call, ", stamp, kBreakText, "[&](", answer, "& answer) {");
  emitDecodeAndReturn(code, {needed(type, "value", "answer")}, "response", "port_.shift()",
                      context);
  code.close("});").close("});");
}

void emitCase(Code& code, const Context& context, const model::Interface& interface,
              const model::Command& command) {
  code.open("case ", prefixOf(interface), "Command::", command.name, ": {");
  if (!command.parameters.empty()) {
    code.line("const auto& slot = ", kBreakText, "slotIn<",
              relative(argumentsStruct(interface, command), home(context)),
              ">(record.arguments());");
  }
  code.line("auto request = provider_.", command.wireName, "Request();");
  for (const model::Parameter& one : command.parameters) {
    code.line(encode({one.type, one.wireName, "slot." + one.name, {}}, "request", context), ";");
  }
  code.line("suture::rpc::fill(request.initSent(), record);");
  if (command.result) {
    emitAnswer(code, context, command);
  } else {
    code.line("return request.send().then(", kBreakText,
              "[this, call = record.call](auto&&) { port_.answer(call); });");
  }
  code.close("}");
}

void emitSend(Code& code, const Context& context, const model::Interface& interface) {
  const std::vector<const model::Command*> own = ownCommands(interface);
  const std::string rest = interface.base.empty() ? "kj::READY_NOW" : "base_->send(record)";
  const bool uses = !own.empty() || !interface.base.empty();
  code.open("kj::Promise<void> send(const suture::rt::CommandRecord&", uses ? " record" : "",
            ") override {");
  if (!own.empty()) {
    code.open("switch (static_cast<", prefixOf(interface), "Command>(record.command)) {");
    for (const model::Command* const command : own) emitCase(code, context, interface, *command);
    code.close("}");
  }
  code.line("return ", rest, ";").close("}");
}

}  // namespace

void emitProxy(Code& code, const Context& context, const model::Interface& interface) {
  const std::string prefix = prefixOf(interface);
  const std::string client = "wire::" + interface.wireName + "::Client";
  code.line("// --- ", prefix, " over Cap'n Proto RPC: the client's side").blank();
  emitReceiver(code, context, interface);
  code.line("/// Makes remote calls of commands.");
  code.open("class ", prefix, "Proxy final : public suture::rpc::Proxy {").label("public:");
  code.line(prefix, "Proxy(", client, " provider, ProxyPort& port)");
  if (interface.base.empty()) {
    code.line("    : provider_(kj::mv(provider)), port_(port) {}").blank();
  } else {
    code.line("    : base_(suture::interfaceInfo<", interface.base, ">().binding().makeProxy(",
              kBreakText, "provider, port)),");
    code.line("      provider_(kj::mv(provider)),").line("      port_(port) {}").blank();
  }
  code.open("kj::Promise<void> subscribe(suture::EventSet events, ", kBreakText,
            "suture::rt::ColumnSet columns) override {");
  code.line("auto request = provider_.subscribeRequest();");
  code.line("request.setEvents(kj::heap<", prefix, "Receiver>(kj::addRef(port_)));");
  code.line("request.setEventMask(", eventsToWire(context, interface, "events"), ");");
  code.line("request.setStateMask(", columnsToWire(context, interface, "columns"), ");");
  code.line("return request.send().ignoreResult();").close("}").blank();
  emitSend(code, context, interface);
  code.blank().label("private:");
  if (!interface.base.empty()) code.line("kj::Own<suture::rpc::Proxy> base_;");
  code.line(client, " provider_;").line("ProxyPort& port_;");
  code.close("};").blank();
}

std::string bindingFunction(const model::Interface& interface) {
  return model::camelCase(prefixOf(interface)) + "Binding";
}

void emitBinding(Code& code, const Context&, const model::Interface& interface) {
  const std::string prefix = prefixOf(interface);
  code.open("class ", prefix, "Binding final : public suture::rpc::Binding {").label("public:");
  code.open("kj::Own<capnp::Capability::Server> makeServant(", kBreakText,
            "kj::Own<ServantPort> port) const override {");
  code.line("return kj::heap<", prefix, "Servant>(kj::mv(port));");
  code.close("}");
  code.open("kj::Own<suture::rpc::Proxy> makeProxy(capnp::Capability::Client contract, ",
            kBreakText, "ProxyPort& port) const override {");
  code.line("return kj::heap<", prefix, "Proxy>(contract.castAs<wire::", interface.wireName,
            ">(), port);");
  code.close("}");
  code.open("kj::Own<suture::rpc::EventSink> makeSink(", kBreakText,
            "capnp::Capability::Client subscriber) const override {");
  code.line("return kj::heap<", prefix, "Sink>(subscriber.castAs<wire::", interface.wireName,
            "Events>());");
  code.close("}");
  code.open("capnp::InterfaceSchema schema() const override {");
  code.line("return capnp::Schema::from<wire::", interface.wireName, ">();");
  code.close("}").close("};").blank();
  code.open("const suture::rpc::Binding& ", bindingFunction(interface), "() {");
  code.line("static const ", prefix, "Binding kBinding;").line("return kBinding;");
  code.close("}").blank();
}

}  // namespace suture::compiler::emit
