#include "cli/text/answer_text.h"
#include <suture/base/errors.h>
#include "cli/text/screen.h"

namespace suture::cli {

const Member& readCommand(const Contract& contract, const std::string& name) {
  const Member& command = contract.command(name);
  if (command.kind == "read") return command;
  throw SetupError("read '" + name + "' of " + contract.title(),
                   "it is a command of kind " + command.kind,
                   "Run it: suture call " + contract.title() + " " + name);
}

std::string unitOf(const Member& member, const Json& value) {
  if (value.is_null() || value.is_object()) return "";
  const char* const described = member.description.contains("result") ? "result" : "payload";
  const std::string unit = textAt(valueAt(member.description, described), "unit");
  return unit.empty() ? "" : " " + plain(unit);
}

std::string answerText(const Member& command, const Answer& answer) {
  std::string text = answer.value.is_null() ? "done\n" : valueText(answer.value);
  text.insert(text.size() - 1, unitOf(command, answer.value));
  if (!answer.age) return text;
  const std::string age =
      milliseconds(inMilliseconds(*answer.age)) + " old" + knownTo(answer.ageError) + "\n";
  if (answer.value.is_structured()) return text + age;
  text.back() = ',';
  return text + " " + age;
}

Json answerJson(const Member& command, const Answer& answer) {
  Json json{{"command", command.name}, {"kind", command.kind}};
  if (!answer.value.is_null()) json["value"] = answer.value;
  if (answer.age) {
    json["age_ms"] = inMilliseconds(*answer.age);
    json["age_error_ms"] = inMilliseconds(answer.ageError);
  }
  return json;
}

}  // namespace suture::cli
