#include "compiler/emit/cpp/value_checks.h"

#include <set>
#include <utility>

#include "compiler/emit/cpp/validity.h"
#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/enum_names.h"
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

void emitEnumCheck(Code& code, const Context& context, const model::Enum& type) {
  const EnumNames names(type, context.header.cxxNamespace);
  code.open("bool ", enumCheck(type.name, context), "(", names.slot, " slot) {");
  code.open("switch (", names.subject(), ") {");
  std::set<std::int64_t> values;
  for (const model::Enumerator& one : type.enumerators) {
    if (!values.insert(one.value).second) continue;
    code.line("case ", names.label(one), ":");
  }
  if (!values.empty()) code.line("  return true;");
  code.close("}").line("return false;").close("}").blank();
}

std::string slotOf(const model::Struct& type, const Context& context) {
  return relative(slotStruct(type.name, context.lookup), home(context));
}

}  // namespace

void declareTypeChecks(Code& code, const Context& context) {
  for (const model::Enum& type : context.header.enums) {
    code.line("bool ", enumCheck(type.name, context), "(", type.underlyingType, " slot);");
  }
  for (const model::Struct& type : context.header.structs) {
    code.line("bool isValid(const ", slotOf(type, context), "& slot, ", kBreakText,
              "suture::FieldPath* path);");
  }
  const bool any = !context.header.enums.empty() || !context.header.structs.empty();
  if (any) code.blank();
}

void emitTypeChecks(Code& code, const Context& context) {
  for (const model::Enum& type : context.header.enums) emitEnumCheck(code, context, type);
  for (const model::Struct& type : context.header.structs) {
    const std::vector<WireValue> values = fieldValues(type, context);
    code.open("bool isValid(", validityParameters(slotOf(type, context), values, context), ") {");
    emitValidity(code, values, context);
    code.close("}").blank();
  }
}

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
