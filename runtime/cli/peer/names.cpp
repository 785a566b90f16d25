#include "cli/peer/names.h"
#include <suture/names/listing.h>
#include <suture/names/start_hint.h>
#include <suture/net/secure.h>
#include <suture/net/tls/keys.h>
#include "cli/peer/wait.h"

#include <exception>

namespace suture::cli {
namespace {

std::vector<net::Address> addressesOf(const std::string& text) {
  try {
    return net::parseAddresses(text);
  } catch (const SetupError& error) {
    throw UsageError(error.what());
  }
}

bool somebodyListens(loop::EventPort& loop, const net::Address& address, Duration patience) {
  try {
    cli::knock(loop, address, patience);
    return true;
  } catch (const SetupError&) {
    return false;
  }
}

/// Links to the manager at `address`. If nobody listens there, the error also says how to start
/// one.
kj::Own<framing::Link> reachManager(loop::EventPort& loop, const net::Address& address,
                                    const Options& options) {
  net::requireKeys(address, options.trust);  // no manager helps where we have none
  try {
    return cli::reach(loop, address, options.trust, tls::kManagerName, options.patience).link;
  } catch (const SetupError& error) {
    const std::string why = std::string("reach the global manager: ") + error.what();
    if (somebodyListens(loop, address, options.patience)) throw SetupError(why);
    throw SetupError(why + " " + howToStartManager(address));
  }
}

}  // namespace

Names::Names(loop::EventPort& loop, const Options& options)
    : loop_(loop), patience_(options.patience), manager_(openFirst(loop, options)) {}

// Each manager that lives knows all processes. If none lives, throws what was found at the first.
Names::Manager Names::openFirst(loop::EventPort& loop, const Options& options) {
  std::exception_ptr why;
  for (const net::Address& address : addressesOf(options.manager)) {
    try {
      return open(loop, address, options);
    } catch (const SetupError&) {
      if (!why) why = std::current_exception();
    }
  }
  std::rethrow_exception(why);
}

Names::Manager Names::open(loop::EventPort& loop, const net::Address& address,
                           const Options& options) {
  auto link = reachManager(loop, address, options);
  auto greeted = greet(link->bootstrap<wire::GlobalManager>(), kOwnName, address);
  auto session = wait(loop, options.patience, kj::mv(greeted), noManagerAnswers(address));
  return {address, kj::mv(link), kj::mv(session)};
}

std::vector<ProcessRecord> Names::processes() {
  return wait(loop_, patience_, listAll(manager_.session), noManagerAnswers(manager_.address));
}

ProcessRecord Names::process(const std::string& name) {
  auto request = manager_.session.resolveRequest();
  request.setProcess(codec::textOf(name));
  auto answer = request.send().then([](auto&& results) -> kj::Promise<ProcessRecord> {
    if (results.isRefused()) return refused(results.getRefused());
    return fromWire(results.getFound());
  });
  return wait(loop_, patience_, kj::mv(answer), noManagerAnswers(manager_.address));
}

}  // namespace suture::cli
