#include <suture/cli/names.h>
#include <suture/cli/wait.h>
#include <suture/transport/tls/keys.h>

namespace suture::cli {
namespace {

rpc::Address addressOf(const std::string& text) {
  try {
    return rpc::Address::parse(text);
  } catch (const SetupError& error) {
    throw UsageError(error.what());
  }
}

/// Says also how a manager comes into being there.
kj::Own<rpc::Link> reachManager(rpc::EventPort& loop, const rpc::Address& address,
                                const Options& options) {
  try {
    return reach(loop, address, options.trust, tls::kManagerName, options.patience);
  } catch (const SetupError& error) {
    throw SetupError(std::string("reach the global manager: ") + error.what() +
                     " Start it with: suture-manager --listen " + address.text());
  }
}

kj::Promise<wire::Session::Client> greet(wire::GlobalManager::Client manager) {
  auto request = manager.helloRequest();
  request.setVersion(wire::PROTOCOL_VERSION);
  request.setProgram(kOwnName);
  return request.send().then([](auto&& results) -> kj::Promise<wire::Session::Client> {
    if (results.isRefused()) return refused(results.getRefused());
    return results.getSession();
  });
}

}  // namespace

Names::Names(rpc::EventPort& loop, const Options& options)
    : loop_(loop),
      patience_(options.patience),
      address_(addressOf(options.manager)),
      link_(reachManager(loop, address_, options)),
      session_(wait(loop, patience_, greet(link_->bootstrap<wire::GlobalManager>()), noAnswer())) {}

std::vector<ProcessRecord> Names::processes() {
  auto answer = session_.listRequest().send().then([](auto&& results) {
    std::vector<ProcessRecord> all;
    for (const auto process : results.getProcesses()) all.push_back(fromWire(process));
    return all;
  });
  return wait(loop_, patience_, kj::mv(answer), noAnswer());
}

ProcessRecord Names::process(const std::string& name) {
  auto request = session_.resolveRequest();
  request.setProcess(textOf(name));
  auto answer = request.send().then([](auto&& results) -> kj::Promise<ProcessRecord> {
    if (results.isRefused()) return refused(results.getRefused());
    return fromWire(results.getFound());
  });
  return wait(loop_, patience_, kj::mv(answer), noAnswer());
}

std::string Names::noAnswer() const {
  return "talk to " + address_.text() +
         ": what listens there does not answer as a global manager. Check the address; if it is "
         "right, restart the manager.";
}

}  // namespace suture::cli
