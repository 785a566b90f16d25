#pragma once
// What the global manager knows, asked by a program that is not part of the system.

#include <suture/cli/link.h>
#include <suture/cli/options.h>
#include <suture/manager/records.h>

#include <string>
#include <vector>

namespace suture::cli {

/// A link to the global manager. Throws SetupError wherever it or what is asked for is not there.
class Names {
 public:
  Names(rpc::EventPort& loop, const Options& options);

  std::vector<ProcessRecord> processes();
  ProcessRecord process(const std::string& name);
  /// Is the network that of tls:// addresses?
  bool leadsToTls() const { return address_.kind == rpc::Address::Kind::Tls; }

 private:
  std::string noAnswer() const;

  rpc::EventPort& loop_;
  const Duration patience_;
  const rpc::Address address_;
  kj::Own<rpc::Link> link_;
  wire::Session::Client session_;
};

}  // namespace suture::cli
