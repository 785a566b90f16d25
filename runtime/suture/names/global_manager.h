#pragma once
// The process that knows names, or any process that plays its part.

#include <suture/names/security.h>

#include <memory>
#include <string>

namespace suture {

namespace rpc {
class ControlThread;
}

/// Serves names at an address for as long as it lives. It hands out addresses; data never passes
/// through it. Made and destroyed by any thread but the control thread, which outlives it.
class GlobalManager {
 public:
  /// Throws SetupError: not an address, in use, no permission, no keys for tls://. `security`: its
  /// keys are those of tls::kManagerName; whom its policy admits may ask and register.
  GlobalManager(rpc::ControlThread& control, const std::string& address,
                const Security& security = {});
  ~GlobalManager();
  GlobalManager(const GlobalManager&) = delete;
  GlobalManager& operator=(const GlobalManager&) = delete;

  /// Where it really listens.
  const std::string& address() const { return address_; }

  /// The address of a user's manager: in $XDG_RUNTIME_DIR/suture, or in /tmp/suture-<uid>.
  static std::string defaultAddress();
  /// Makes the directory of a "unix:" address, for its owner only, if it is not there. Throws
  /// SetupError if it is somebody else's.
  static void makeDirectory(const std::string& address);

 private:
  class Impl;
  rpc::ControlThread& control_;
  std::unique_ptr<Impl> impl_;
  std::string address_;
};

}  // namespace suture
