#include <suture/loop/failure.h>
#include <suture/names/records.h>
#include <suture/names/start_hint.h>

namespace suture {
namespace {

/// Returns what `failure` means, which came instead of an answer: something else may listen there.
kj::Exception notGreeted(const net::Address& address, const kj::Exception& failure) {
  const std::string asked = "talk to " + address.text() + ": ";
  if (failure.getType() != kj::Exception::Type::UNIMPLEMENTED) {
    return loop::failure(failure.getType(), asked + loop::describe(failure));
  }
  return loop::failure(kj::Exception::Type::FAILED,
                       asked + "what listens there is no global manager. Correct the address.");
}

}  // namespace

std::string howToStartManager(const net::Address& address) {
  const bool needsKeys = address.kind == net::Address::Kind::Tls;
  return "If it does not run, start it with: suture-manager --listen " + address.text() +
         (needsKeys ? " --keys FOLDER" : "");
}

kj::Promise<wire::Session::Client> greet(wire::GlobalManager::Client manager,
                                         const std::string& program, const net::Address& address) {
  auto request = manager.helloRequest();
  request.setVersion(wire::PROTOCOL_VERSION);
  request.setProgram(codec::textOf(program));
  using Greeted = kj::Promise<wire::Session::Client>;
  return request.send().then(
      [](auto&& results) -> Greeted {
        if (results.isRefused()) return refused(results.getRefused());
        return results.getSession();
      },
      [address](kj::Exception&& failure) -> Greeted { return notGreeted(address, failure); });
}

std::string noManagerAnswers(const net::Address& address) {
  return "talk to " + address.text() +
         ": what listens there does not answer as a global manager. Check the address; if it is "
         "right, restart the manager.";
}

}  // namespace suture
