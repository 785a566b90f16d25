#pragma once
// This is the process that knows names, or any process that does the same.

#include <suture/names/security.h>

#include <memory>
#include <string>

namespace suture {

namespace loop {
class ControlThread;
}

/// Serves names at an address for as long as it lives. It hands out addresses; data never passes
/// through it. Any thread except the control thread, which outlives it, makes and destroys it.
class GlobalManager {
 public:
  /// Throws SetupError if the address is invalid, in use or not permitted, or lacks keys for
  /// tls://. The keys of `security` are those of tls::kManagerName; peers that its policy admits
  /// may ask and register.
  GlobalManager(loop::ControlThread& control, const std::string& address,
                const Security& security = {});
  ~GlobalManager();
  GlobalManager(const GlobalManager&) = delete;
  GlobalManager& operator=(const GlobalManager&) = delete;

  /// Returns where it really listens.
  const std::string& address() const { return address_; }

  /// Returns the address of this user's manager: in `$XDG_RUNTIME_DIR/suture`, or in
  /// `/tmp/suture-<uid>`.
  static std::string defaultAddress();
  /// Makes the directory of a "unix:" address, only for its owner, if it is not there. Throws
  /// SetupError if another user owns it.
  static void makeDirectory(const std::string& address);

 private:
  class Impl;
  loop::ControlThread& control_;
  std::unique_ptr<Impl> impl_;
  std::string address_;
};

}  // namespace suture
