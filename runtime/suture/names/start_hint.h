#pragma once
// This says what to run where no global manager answers.

#include <suture/net/address.h>

#include <string>

namespace suture {

/// Returns "Start it with: suture-manager --listen tls://127.0.0.1:7700 --keys FOLDER".
std::string howToStartManager(const rpc::Address& address);

}  // namespace suture
