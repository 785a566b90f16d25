#pragma once
// What a process shows of itself, and whom it talks to. Those who do not know KJ include it too.

#include <sys/types.h>

#include <memory>
#include <vector>

namespace suture::tls {
class Keys;
}

namespace suture::rpc {

/// A value.
struct Trust {
  std::shared_ptr<const tls::Keys> keys{};  ///< none: no tls:// address can be used
  std::vector<uid_t> users{};               ///< on Unix sockets, beside this process's own and root
};

}  // namespace suture::rpc
