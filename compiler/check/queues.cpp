#include "compiler/check/rules.h"

namespace suture::compiler::check {
namespace {

constexpr unsigned kDeepestQueue = 4096;

void checkDepth(const std::string& subject, unsigned queue, const model::Source& source,
                model::Diagnostics& findings) {
  if (queue >= 1 && queue <= kDeepestQueue) return;
  addError(findings, source, "queue-depth",
           subject + " has queue(" + std::to_string(queue) + "); a depth is between 1 and " +
               std::to_string(kDeepestQueue),
           "use latest() where only the newest counts");
}

void checkExclusive(const std::string& subject, bool latest, bool queueGiven,
                    const model::Source& source, model::Diagnostics& findings) {
  if (!latest || !queueGiven) return;
  addError(
      findings, source, "latest-with-queue",
      subject + " has both latest() and queue(); a newer one replaces the older or waits behind it",
      "keep the one that is meant");
}

void checkRead(const model::Command& command, const std::string& subject,
               model::Diagnostics& findings) {
  const char* argument = command.latest           ? "latest()"
                         : command.ttlNanoseconds ? "ttl()"
                         : command.queueGiven     ? "queue()"
                                                  : nullptr;
  if (!argument) return;
  addError(
      findings, command.source, "queued-read",
      subject + " is a read but has " + argument + ", which is for commands that wait in a queue",
      "drop it, or drop const if the command changes state");
}

bool returns(model::CommandKind kind) {
  return kind == model::CommandKind::VoidReturn || kind == model::CommandKind::WriteReturn;
}

void checkQueueOf(const model::Command& command, model::Diagnostics& findings) {
  const std::string subject = "command '" + command.name + "'";
  checkDepth(subject, command.queue, command.source, findings);
  checkExclusive(subject, command.latest, command.queueGiven, command.source, findings);
  if (command.ttlNanoseconds && *command.ttlNanoseconds <= 0) {
    addError(findings, command.source, "ttl-range",
             subject + " has a ttl() that is not positive; it would never be executed",
             "give the age at which it is too late, such as ttl(20ms)");
  }
  if (command.kind == model::CommandKind::Read) checkRead(command, subject, findings);
  if (command.kind == model::CommandKind::QualifiedRead && command.latest) {
    checkRead(command, subject, findings);
  }
  if (command.latest && returns(command.kind)) {
    addError(findings, command.source, "latest-with-result",
             subject + " is latest() but returns a value; of a replaced call there is none",
             "drop latest(), or return void");
  }
}

}  // namespace

void checkQueues(const model::Header& header, model::Diagnostics& findings) {
  for (const model::Interface& interface : header.interfaces) {
    for (const model::Command& command : interface.commands) checkQueueOf(command, findings);
    for (const model::Event& event : interface.events) {
      const std::string subject = "event '" + event.name + "'";
      checkDepth(subject, event.queue, event.source, findings);
      checkExclusive(subject, event.latest, event.queueGiven, event.source, findings);
    }
  }
}

}  // namespace suture::compiler::check
