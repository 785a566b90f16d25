#include <suture/loop/failure.h>
#include <suture/names/start_hint.h>

namespace suture {

std::string howToStartManager(const rpc::Address& address) {
  const bool needsKeys = address.kind == rpc::Address::Kind::Tls;
  return "If it does not run, start it with: suture-manager --listen " + address.text() +
         (needsKeys ? " --keys FOLDER" : "");
}

kj::Exception notGreeted(const rpc::Address& address, const kj::Exception& failure) {
  const std::string asked = "talk to " + address.text() + ": ";
  if (failure.getType() != kj::Exception::Type::UNIMPLEMENTED) {
    return rpc::failure(failure.getType(), asked + rpc::describe(failure));
  }
  return rpc::failure(kj::Exception::Type::FAILED,
                      asked + "what listens there is no global manager. Correct the address.");
}

}  // namespace suture
