#pragma once
// This greets a global manager, and says what to do where none answers.

#include <suture/loop/kj_comparisons.h>  // first

#include <kj/async.h>
#include <suture/manager.capnp.h>
#include <suture/net/address.h>

#include <string>

namespace suture {

/// Returns "If it does not run, start it with: suture-manager --listen tls://127.0.0.1:7700 --keys
/// FOLDER".
std::string howToStartManager(const net::Address& address);

/// Greets what listens at `address` as the program of that name. Rejects with what to do if it
/// refuses, or is no global manager.
kj::Promise<wire::Session::Client> greet(wire::GlobalManager::Client manager,
                                         const std::string& program, const net::Address& address);

/// Says what to do where the manager at `address` has not answered in time.
std::string noManagerAnswers(const net::Address& address);

}  // namespace suture
