#include "compiler/emit/wire/value_checks.h"

#include <utility>

#include "compiler/emit/text/contract.h"
#include "compiler/emit/wire/wire_form.h"

namespace suture::compiler::emit {
namespace {

std::string home(const Context& context) { return context.header.cxxNamespace; }

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

}  // namespace

void emitValueChecks(Code& code, const Context& context, const model::Interface& interface) {
  Checks checks(code, context);
  for (const model::Command* const command : ownCommands(interface)) {
    checks.add(argumentsCheck(interface, *command, context),
               relative(argumentsStruct(interface, *command, context), home(context)),
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

}  // namespace suture::compiler::emit
