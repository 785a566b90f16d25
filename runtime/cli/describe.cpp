#include "cli/peer/lookup.h"
#include "cli/text/contract_text.h"
#include "cli/text/process_text.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

#include <utility>
#include <vector>

namespace suture::cli {
namespace {

const char* sideName(wire::Peer::Side side) {
  return side == wire::Peer::Side::REQUIRED ? "required" : "provided";
}

/// Returns the self-description without what only peers compare.
Json forPeople(Json description) {
  description.erase("wire");
  return description;
}

int describeInterface(Peer& peer, const Options& options, const Target& target) {
  const Found found = findInterface(peer, target);
  if (options.json) {
    printJson({{"interface", target.toString()},
               {"side", sideName(found.side)},
               {"description", forPeople(found.contract->description())}});
  } else {
    print(target.toString() + ", " + sideName(found.side) + ": " + contractText(*found.contract));
  }
  return 0;
}

}  // namespace

int describe(loop::EventPort& loop, const Options& options) {
  const Target target = Target::parse(options.target);
  Peer peer = meet(loop, options, target.process);
  if (!target.interface.empty()) return describeInterface(peer, options, target);
  ProcessRecord process = peer.process();
  Description described = peer.describe();
  process.components = target.component.empty() ? std::move(described.components)
                                                : std::vector{findComponent(peer, target)};
  if (options.json) {
    Json told = toJson(process, described.connections);
    told["clock"] = toJson(peer.clock());
    printJson(told);
  } else {
    print(plain(process.name) + "\n" + clockText(peer.clock()) +
          componentsText(process.components, described.connections));
  }
  return 0;
}

}  // namespace suture::cli
