#pragma once
// This is the global manager between the processes of a measurement.

#include <suture/loop/control_thread.h>
#include <suture/names/global_manager.h>
#include <suture/names/security.h>
#include <suture/net/tls/key_maker.h>
#include <suture/net/tls/keys.h>

#include <memory>
#include <string>

#include "bench/table2/setup.h"
#include "support/temporary_directory.h"

namespace bench {

/// Returns how `process` proves who it is; `keys` is a folder, "" without TLS. Throws SetupError.
inline suture::Security securityWith(const std::string& keys, const std::string& process) {
  if (keys.empty()) return {};
  return {.keys = std::make_shared<const suture::tls::Keys>(keys, process), .policy = {}};
}

/// Make it before the processes that it serves, and let it go after them.
class Names {
 public:
  /// Throws SetupError.
  explicit Names(Transport transport)
      : keys_(transport == Transport::Tls ? folder_.file("keys") : ""),
        manager_(control_, wanted(transport), madeSecurity()) {}

  const std::string& address() const { return manager_.address(); }
  /// Returns the folder with the keys of the processes "server" and "client"; "" without TLS.
  const std::string& keys() const { return keys_; }

 private:
  std::string wanted(Transport transport) const {
    switch (transport) {
      case Transport::Unix: return "unix:" + folder_.file("manager");
      case Transport::Tcp: return "tcp://127.0.0.1:0";
      case Transport::Tls: return "tls://127.0.0.1:0";
    }
    return "";
  }
  suture::Security madeSecurity() const {
    const std::string own = suture::tls::kManagerName;
    if (!keys_.empty()) suture::tls::makeKeys(keys_, {own, "server", "client"});
    return securityWith(keys_, own);
  }

  const suture::TemporaryDirectory folder_;
  const std::string keys_;
  suture::loop::ControlThread control_;
  const suture::GlobalManager manager_;
};

}  // namespace bench
