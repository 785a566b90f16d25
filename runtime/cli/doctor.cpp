#include <suture/base/errors.h>
#include "cli/checklist.h"
#include "cli/peer/lookup.h"
#include "cli/peer/names.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace suture::cli {
namespace {

std::string count(std::size_t number, const char* what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

/// Says why what travels to this address need not be encrypted.
std::string tlsOf(const net::Address& address) {
  return address.kind == net::Address::Kind::Unix
             ? "not needed: a Unix socket does not leave this machine"
             : "not needed: loopback does not leave this machine";
}

std::string whereabouts(const ProcessRecord& process) {
  return "pid " + std::to_string(process.pid) + " on " + process.host;
}

/// Does what the use of an interface takes: reads its schema and, if it is provided, opens it.
std::string useInterface(Peer& peer, const Target& target) {
  const Found found = findInterface(peer, target);
  if (found.side == wire::Peer::Side::PROVIDED) peer.open(target, *found.contract);
  return found.contract->name() + ": " + count(found.contract->commands().size(), "command") +
         ", " + count(found.contract->events().size(), "event");
}

std::string look(Peer& peer, const Target& target) {
  if (!target.interface.empty()) return useInterface(peer, target);
  if (!target.component.empty()) {
    const ComponentRecord component = findComponent(peer, target);
    return count(component.provided.size(), "provided interface") + ", " +
           count(component.required.size(), "required one");
  }
  return count(peer.components().size(), "component");
}

Checklist examine(loop::EventPort& loop, const Options& options, Names& names,
                  const Target& target) {
  Checklist all(target.toString());
  std::optional<Peer> peer;
  all.step("resolve", "Start the process, with this manager's address", [&] {
    peer.emplace(loop, names.process(target.process), names.address(), options);
    return whereabouts(peer->process());
  });
  const bool secure = names.leadsToTls();
  std::optional<SetupError> unproven;
  all.step("connect", "If it is gone, start it again; if it hangs, look at what it does", [&] {
    try {
      peer->dial();
    } catch (const SetupError& error) {
      if (!secure) throw;
      peer->knock();  // throws unless something listens, and then it is the proof that fails
      unproven = error;
    }
    return peer->address().text();
  });
  if (secure) {
    all.step("tls", "Give both keys of one CA: `suture keys --help`", [&] {
      if (unproven) throw *unproven;
      return "it has the certificate of '" + target.process + "', which " + peer->certificatesEnd();
    });
  } else {
    all.skip("tls", [&] { return tlsOf(peer->address()); });
  }
  all.step("version", "Build both from the same release", [&] {
    peer->greet();
    return "both speak version " + std::to_string(wire::PROTOCOL_VERSION);
  });
  all.step("schema", "`suture describe " + target.process + "` shows what there is",
           [&] { return look(*peer, target); });
  return all;
}

std::vector<Checklist> examineAll(loop::EventPort& loop, const Options& options) {
  std::vector<Target> targets;
  for (const std::string& name : options.targets) targets.push_back(Target::parse(name));
  std::optional<Names> names;
  std::vector<Checklist> done;
  done.emplace_back("the global manager").step("manager", "Restart the manager", [&] {
    names.emplace(loop, options);
    const auto processes = names->processes();
    for (const ProcessRecord& process : processes) {
      if (options.targets.empty()) targets.push_back({process.name, "", ""});
    }
    return names->address().text() + ", processes known: " + std::to_string(processes.size());
  });
  if (!done.front().good()) return done;
  for (const Target& target : targets) done.push_back(examine(loop, options, *names, target));
  return done;
}

}  // namespace

int doctor(loop::EventPort& loop, const Options& options) {
  const auto done = examineAll(loop, options);
  const bool good =
      std::all_of(done.begin(), done.end(), [](const Checklist& one) { return one.good(); });
  if (options.json) {
    Json all = Json::array();
    for (const Checklist& one : done) all.push_back(one.json());
    printJson({{"good", good}, {"examinations", std::move(all)}});
  } else {
    for (const Checklist& one : done) print(one.text());
  }
  return good ? 0 : 1;
}

}  // namespace suture::cli
