#pragma once
// This is what the global manager knows, asked by a program that is not part of the system.

#include <suture/names/records.h>
#include "cli/command_line/options.h"
#include "cli/peer/link.h"

#include <string>
#include <vector>

namespace suture::cli {

/// Holds a link to the global manager, or of several to the first that answers. Throws SetupError
/// if it, or what is asked for, is not there.
class Names {
 public:
  Names(loop::EventPort& loop, const Options& options);

  std::vector<ProcessRecord> processes();
  ProcessRecord process(const std::string& name);
  /// Returns true if the network is that of tls:// addresses.
  bool leadsToTls() const { return manager_.address.kind == net::Address::Kind::Tls; }
  /// Returns the address of the manager that answers.
  const net::Address& address() const { return manager_.address; }

 private:
  struct Manager {
    net::Address address;
    kj::Own<framing::Link> link;
    wire::Session::Client session;
  };

  static Manager open(loop::EventPort& loop, const net::Address& address, const Options& options);
  static Manager openFirst(loop::EventPort& loop, const Options& options);

  loop::EventPort& loop_;
  const Duration patience_;
  Manager manager_;
};

}  // namespace suture::cli
