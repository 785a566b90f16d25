#include <suture/names/start_hint.h>

namespace suture {

std::string howToStartManager(const rpc::Address& address) {
  const bool needsKeys = address.kind == rpc::Address::Kind::Tls;
  return "Start it with: suture-manager --listen " + address.text() +
         (needsKeys ? " --keys FOLDER" : "");
}

}  // namespace suture
