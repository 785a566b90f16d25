#include "compiler/emit/text/call_words.h"

#include "compiler/emit/text/contract.h"

namespace suture::compiler::emit {
namespace {

using model::CommandKind;

constexpr std::int64_t kDefaultDeadline = 1'000'000'000;  // ns

/// Says how a command or an event waits for its turn.
template <class Waiting>
std::string queueWords(const Waiting& one) {
  if (one.latest) return "a newer one replaces the one that waits.";
  return "up to " + std::to_string(one.queue) + " wait.";
}

}  // namespace

bool isRead(const model::Command& command) { return command.kind == CommandKind::Read; }

bool isQueued(const model::Command& command) {
  return !isRead(command) && command.kind != CommandKind::QualifiedRead;
}

bool isAnswered(const model::Command& command) { return command.result && !isRead(command); }

std::string kindWords(CommandKind kind) {
  switch (kind) {
    case CommandKind::Void: return "Void";
    case CommandKind::Write: return "Write";
    case CommandKind::Read: return "Read";
    case CommandKind::QualifiedRead: return "Qualified read";
    case CommandKind::VoidReturn: return "Void with return";
    case CommandKind::WriteReturn: return "Write with return";
  }
  return "";
}

std::string callWords(const model::Command& command) {
  std::string words = kindWords(command.kind) + ": ";
  if (isRead(command)) return words + "answered at once with what the last cycle left.";
  if (command.concurrent) {
    words += "may run while the component runs.";
  } else {
    words += isQueued(command) ? queueWords(command) : "asked in the component's thread.";
  }
  if (command.direct) words += " Touches atomics only.";
  if (command.ttlNanoseconds) {
    words += " Not executed if it was sent more than " + durationWords(*command.ttlNanoseconds) +
             " ago.";
  }
  if (!isAnswered(command)) return words;
  return words + " `within()` waits " +
         durationWords(command.deadlineNanoseconds.value_or(kDefaultDeadline)) + " for the answer.";
}

std::string deliveryWords(const model::Event& event) {
  return "At a subscriber " + queueWords(event) +
         (event.latched ? " Who subscribes later gets the last one." : "");
}

std::string durationWords(std::int64_t nanoseconds) {
  const auto in = [nanoseconds](std::int64_t unit) {
    return number(static_cast<double>(nanoseconds) / static_cast<double>(unit));
  };
  std::string text = nanoseconds < 1'000'000'000 ? in(1'000'000) + " ms" : in(1'000'000'000) + " s";
  if (const std::size_t zero = text.find(".0 "); zero != std::string::npos) text.erase(zero, 2);
  return text;
}

std::string rangeWords(const model::Limits& limits) {
  if (!limits.range) return "";
  return "from " + number(limits.range->first) + " to " + number(limits.range->second);
}

std::string limitWords(const std::string& name, const model::Limits& limits) {
  const std::string range = rangeWords(limits);
  if (limits.unit.empty() && range.empty()) return "";
  const std::string unit = limits.unit.empty() ? "" : " in " + limits.unit;
  return " " + name + " is" + unit + (unit.empty() || range.empty() ? "" : ",") +
         (range.empty() ? "" : " " + range) + ".";
}

}  // namespace suture::compiler::emit
