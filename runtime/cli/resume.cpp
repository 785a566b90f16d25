#include <suture/base/errors.h>
#include <suture/base/nearest.h>
#include "cli/command_line/target.h"
#include "cli/peer/lookup.h"
#include "cli/peer/provider.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

#include <string>
#include <vector>

namespace suture::cli {
namespace {

/// Returns the interface that each component has for its life.
Target lifeOf(const Target& required) {
  return {required.process, required.component, "component"};
}

/// Returns what the component answered, for a person.
std::string told(const std::string& outcome, const std::string& connection) {
  const std::string asked = "resume '" + connection + "'";
  if (outcome == "Resumed") return connection + ": commands go through again";
  if (outcome == "Asked") {
    return connection +
           ": commands go through again when its device uses it next, unless its "
           "provider is lost then";
  }
  if (outcome == "NotConnected") {
    throw SetupError(asked, "it is not connected", "`suture ps` shows what there is");
  }
  if (outcome == "NotAwaiting") {
    throw SetupError(asked, "it does not await an operator", "Nothing has to be done");
  }
  if (outcome == "ProviderLost") {
    throw SetupError(asked, "its provider is lost, suspended or faulted",
                     "Have it run again, and look at it, first");
  }
  throw SetupError(asked, "it answers '" + outcome + "', which this program does not know",
                   "Use the `suture` that the process was built with");
}

/// Throws SetupError with what could have been meant.
[[noreturn]] void refuseUnknown(loop::EventPort& loop, const Options& options,
                                const Target& asked) {
  Peer peer = meet(loop, options, asked.process);
  std::vector<std::string> names;
  for (const auto& one : findComponent(peer, asked).required) names.push_back(one.name);
  throw SetupError(
      "resume '" + asked.toString() + "'",
      "its component requires no such interface; it has " + listNamed("required interfaces", names),
      remedyForName(asked.interface, names));
}

}  // namespace

int resume(loop::EventPort& loop, const Options& options) {
  const Target required = Target::parseInterface(options.target);
  Provider life(loop, options, lifeOf(required));
  const Member& command = life.contract().command("resume_connection");
  const Answer answer =
      life.call(command, {{"required", required.interface}}, codec::Labels::Names);
  const std::string outcome = valueLine(answer.value);  // a peer may answer no text
  if (outcome == "NoSuchInterface") refuseUnknown(loop, options, required);
  const std::string text = told(outcome, required.toString());
  if (options.json) {
    printJson({{"outcome", outcome}});
  } else {
    print(text + "\n");
  }
  return 0;
}

}  // namespace suture::cli
