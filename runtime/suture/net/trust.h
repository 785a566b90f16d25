#pragma once
// This says how a process proves who it is, and whom it talks to. Sources that do not use KJ
// include it too.

#include <sys/types.h>

#include <memory>
#include <vector>

namespace suture::tls {
class Keys;
}

namespace suture::net {

/// Any thread may have its own copy.
struct Trust {
  std::shared_ptr<const tls::Keys> keys{};  ///< null: no tls:// address can be used
  std::vector<uid_t> users{};  ///< trusted on Unix sockets, beside this process's user and root
};

}  // namespace suture::net
