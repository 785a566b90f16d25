#include <suture/base/errors.h>
#include "cli/peer/names.h"
#include "cli/peer/peer.h"
#include "cli/text/process_text.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

#include <string>
#include <vector>

namespace suture::cli {
namespace {

/// This is what a process answers about its connections, of which the global manager knows nothing.
struct ConnectionsAnswer {
  Connections connections;
  std::string whyNot;  ///< why that is not known; "" if it is
};

ConnectionsAnswer ask(loop::EventPort& loop, const Options& options, const net::Address& manager,
                      const ProcessRecord& process) {
  if (process.silent) return {std::nullopt, "it is silent"};
  try {
    Peer peer(loop, process, manager, options);
    peer.dial();
    peer.greet();
    Connections told = peer.describe().connections;
    return {told, told ? "" : "its Suture is older than that question"};
  } catch (const SetupError& error) {
    return {std::nullopt, error.what()};
  }
}

std::string text(const ProcessRecord& process, const ConnectionsAnswer& answer) {
  std::string line = plain(process.name) + "   pid " + std::to_string(process.pid) + "   host " +
                     plain(process.host);
  for (const std::string& address : process.addresses) line += "   " + plain(address);
  if (process.silent) line += "   silent";
  line += "\n" + componentsText(process.components, answer.connections);
  return answer.whyNot.empty() || process.silent
             ? line
             : line + "  its connections are not known: " + plain(answer.whyNot) + "\n";
}

Json json(const ProcessRecord& process, const ConnectionsAnswer& answer) {
  Json told = toJson(process, answer.connections);
  if (!answer.whyNot.empty()) told["connections_unknown"] = answer.whyNot;
  return told;
}

}  // namespace

int ps(loop::EventPort& loop, const Options& options) {
  Names names(loop, options);
  const auto processes = names.processes();
  Json all = Json::array();
  for (const ProcessRecord& process : processes) {
    const ConnectionsAnswer answer = ask(loop, options, names.address(), process);
    if (options.json) {
      all.push_back(json(process, answer));
    } else {
      print(text(process, answer));
    }
  }
  if (options.json) printJson(all);
  if (!options.json && processes.empty()) {
    print("No process is known to " + options.manager + ".\n");
  }
  return 0;
}

}  // namespace suture::cli
