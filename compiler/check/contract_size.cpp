#include <vector>

#include "compiler/check/rules.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

// A connection has a word of 64 bits with a bit for each read that it asks for, and one for events.
constexpr std::size_t kMost = 64;

/// This is a read or an event of a contract.
struct Counted {
  std::string subject;
  bool isInherited;
  const model::Source& source;
};

void checkNumber(const std::string& contract, const std::string& what,
                 const std::vector<Counted>& all, model::Diagnostics& findings) {
  // If an inherited one is too many already, its own contract says so.
  if (all.size() <= kMost || all[kMost].isInherited) return;
  const Counted& first = all[kMost];
  addError(findings, first.source, "contract-size",
           first.subject + " is one too many: contract '" + contract + "' has " +
               std::to_string(all.size()) + " " + what + ", inherited ones included, and " +
               std::to_string(kMost) + " is the most",
           "put some of them into a contract of their own, or let one carry a struct");
}

template <class Member>
Counted counted(const std::string& kind, const Member& member) {
  return {kind + " '" + member.name + "'", !member.inheritedFrom.empty(), member.source};
}

}  // namespace

void checkContractSizes(const model::Header& header, model::Diagnostics& findings) {
  for (const model::Interface& interface : header.interfaces) {
    const std::string name = model::unqualified(interface.name);
    std::vector<Counted> reads, events;
    for (const model::Command& command : interface.commands) {
      if (command.kind == model::CommandKind::Read) reads.push_back(counted("read", command));
    }
    for (const model::Event& event : interface.events) events.push_back(counted("event", event));
    checkNumber(name, "reads", reads, findings);
    checkNumber(name, "events", events, findings);
  }
}

}  // namespace suture::compiler::check
