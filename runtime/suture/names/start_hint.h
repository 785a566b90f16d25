#pragma once
// This says what to do where no global manager answers.

#include <kj/exception.h>
#include <suture/net/address.h>

#include <string>

namespace suture {

/// Returns "If it does not run, start it with: suture-manager --listen tls://127.0.0.1:7700 --keys
/// FOLDER".
std::string howToStartManager(const rpc::Address& address);

/// Returns what `failure` means, which came instead of an answer when the manager at `address` was
/// greeted: something else may listen there.
kj::Exception notGreeted(const rpc::Address& address, const kj::Exception& failure);

}  // namespace suture
