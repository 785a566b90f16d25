#include "compiler/emit/docs/page_commands.h"

#include <algorithm>

#include "compiler/emit/docs/markdown.h"
#include "compiler/emit/text/call_words.h"
#include "compiler/emit/text/context.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

std::string signature(const model::Command& command, const std::string& home) {
  std::string parameters;
  for (const model::Parameter& one : command.parameters) {
    const std::string type = cxxType(one.type, home);
    parameters += (parameters.empty() ? "" : ", ") +
                  (one.byReference ? "const " + type + "& " : type + " ") + one.name;
  }
  std::string result = command.result ? cxxType(*command.result, home) : "void";
  if (command.resultByReference) result = "const " + result + "&";
  const bool reads = !isQueued(command);
  return result + " " + command.name + "(" + parameters + ")" + (reads ? " const" : "");
}

class Sections {
 public:
  Sections(const Context& context, const PageTypes& types, const model::Interface& interface)
      : context_(context), types_(types), interface_(interface) {}

  std::string text() const { return overview() + commands() + events() + errors(); }

 private:
  std::string heading(const model::Command& command) const {
    return model::unqualified(interface_.name) + "::" + command.name;
  }
  std::string heading(const model::Event& event) const {
    return model::unqualified(interface_.name) + "::" + event.name + " (event)";
  }

  std::string overview() const {
    MarkdownTable commands({"command", "kind", "about"});
    for (const model::Command& one : interface_.commands) {
      commands.add({link(inCode(one.name), anchorOf(heading(one))), kindWords(one.kind),
                    firstSentence(one.doc.text)});
    }
    MarkdownTable events({"event", "carries", "about"});
    for (const model::Event& one : interface_.events) {
      events.add({link(inCode(one.name), anchorOf(heading(one))), carried(one),
                  firstSentence(one.doc.text)});
    }
    return commands.text() + events.text();
  }

  std::string carried(const model::Event& event) const {
    std::string words;
    for (const model::Type& type : event.payload) {
      words += (words.empty() ? "" : "; ") + types_.words(type);
    }
    return words;
  }

  std::string commands() const {
    std::string text;
    for (const model::Command& one : interface_.commands) {
      text += "### " + heading(one) + "\n\n```cpp\n" +
              signature(one, context_.header.cxxNamespace) + "\n```\n\n" + body(one) + "\n";
    }
    return text;
  }

  std::string body(const model::Command& command) const {
    std::string text = command.doc.text.empty() ? "" : prose(command.doc.text) + "\n\n";
    for (const model::Parameter& one : command.parameters) {
      text += "- " + inCode(one.name) + ": " + types_.value(one.type, {one.unit, one.range}) + "\n";
    }
    if (command.result) {
      text +=
          "- Answers: " + types_.value(*command.result, {command.resultUnit, command.resultRange}) +
          "\n";
    }
    text += "- " + callWords(command) + "\n";
    if (command.optional) text += "- Optional: a provider may lack it (`NotImplemented`).\n";
    return text + origin(command.inheritedFrom, command.lifecycle);
  }

  static std::string origin(const std::string& from, const model::Lifecycle& lifecycle) {
    const std::string words = lifecycleWords(lifecycle);
    return (from.empty() ? "" : "- From contract " + inCode(from) + "\n") +
           (words.empty() ? "" : "- " + words + "\n");
  }

  std::string events() const {
    std::string text;
    for (const model::Event& one : interface_.events) {
      text += "### " + heading(one) + "\n\n" + body(one) + "\n";
    }
    return text;
  }

  std::string body(const model::Event& event) const {
    std::string text = event.doc.text.empty() ? "" : prose(event.doc.text) + "\n\n";
    for (std::size_t i = 0; i < event.payload.size(); ++i) {
      const model::Limits limits = i < event.limits.size() ? event.limits[i] : model::Limits{};
      const bool alone = event.payload.size() == 1;
      text += "- " + (alone ? "Carries" : inCode(lock::payloadName(i))) + ": " +
              types_.value(event.payload[i], limits) + "\n";
    }
    if (event.payload.empty()) text += "- Carries nothing.\n";
    text += "- " + deliveryWords(event) + "\n";
    return text + origin(event.inheritedFrom, event.lifecycle);
  }

  template <class Condition>
  bool any(const Condition& condition) const {
    return std::any_of(interface_.commands.begin(), interface_.commands.end(), condition);
  }

  /// Lists what the commands of this contract may answer instead of a value.
  std::string errors() const {
    const auto queued = [](const model::Command& one) { return isQueued(one) && !one.latest; };
    const auto aged = [](const model::Command& one) { return one.ttlNanoseconds.has_value(); };
    const auto optional = [](const model::Command& one) { return one.optional; };
    const auto takes = [](const model::Command& one) { return !one.parameters.empty(); };
    const auto carries = [&](const model::Command& one) { return takes(one) || one.result; };
    const auto moves = [](const model::Command& one) {
      return !isRead(one) && one.kind != model::CommandKind::QualifiedRead;
    };
    if (interface_.commands.empty()) return "";
    MarkdownTable table({"error", "of", "meaning"});
    const auto add = [&table](bool possible, const char* name, const char* of,
                              const char* meaning) {
      if (possible) table.add({inCode(name), of, meaning});
    };
    add(true, "NotConnected", "every call",
        "the required interface has no connection at this moment");
    add(true, "Lost", "every call",
        "the connection broke; nothing reaches the provider until it is back");
    add(true, "WrongThread", "every call",
        "a required interface belongs to one thread, and this is another");
    add(any(queued), "Full", "commands that wait", "as many as the provider accepts wait already");
    add(any(takes), "TooLarge", "commands with arguments", "text or a list exceeds its bound");
    add(any(carries), "Invalid", "commands with arguments, reads, answers",
        "a number is not finite, or outside its range");
    add(any(isRead), "NotYet", "reads",
        "nobody has asked for the value before; it is there after the provider's next cycle");
    add(any(aged), "Late", "commands that age", "too old when its turn came; not executed");
    add(any(isQueued), "Superseded", "commands that wait",
        "a later one had run already; not executed");
    add(any(isAnswered), "Timeout", "calls with an answer", "whether it ran is not known");
    add(any(isAnswered), "OutcomeUnknown", "calls with an answer",
        "the connection broke; it may have run");
    add(any(isAnswered), "TooManyCalls", "calls with an answer",
        "as many as can be followed are unfinished");
    add(true, "Faulted", "every call",
        "the provider's component is faulted: its code threw, or a policy said so");
    add(true, "Suspended", "every call",
        "the provider is suspended; a command is not executed, a read has no value");
    add(any(moves), "AwaitingOperator", "commands",
        "the connection's contract wants an operator, who has not resumed it; nothing was sent");
    add(any(moves), "NotPermitted", "commands",
        "the provider's policy lets this process only read; not executed");
    add(any(takes), "OnLoan", "commands",
        "this required interface is filling a loan; nothing was sent");
    add(any(isAnswered), "Cancelled", "calls with an answer",
        "the caller cancelled it in time; not executed");
    add(any(isRead), "Stale", "reads", "the value is older than the connection's max_age");
    add(any(optional), "NotImplemented", "optional commands", "this provider does not have it");
    return "### Errors of " + model::unqualified(interface_.name) + "\n\n" + table.text();
  }

  const Context& context_;
  const PageTypes& types_;
  const model::Interface& interface_;
};

}  // namespace

std::string commandSections(const Context& context, const PageTypes& types,
                            const model::Interface& interface) {
  return Sections(context, types, interface).text();
}

}  // namespace suture::compiler::emit
