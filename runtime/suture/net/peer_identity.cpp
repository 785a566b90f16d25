#include <suture/net/peer_identity.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>

namespace suture::net {

std::string PeerIdentity::text() const {
  switch (proof) {
    case Proof::User: return "user " + std::to_string(user);
    case Proof::Certificate: return "process '" + process + "'";
    case Proof::None: break;
  }
  return "a peer without proof of who it is (plain TCP)";
}

PeerIdentity identityOf(int socket) {
  sockaddr_storage address{};
  socklen_t length = sizeof(address);
  ucred credentials{};
  socklen_t size = sizeof(credentials);
  const bool known = getsockname(socket, reinterpret_cast<sockaddr*>(&address), &length) == 0 &&
                     address.ss_family == AF_UNIX &&
                     getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &credentials, &size) == 0;
  if (!known) return {};
  return {.proof = PeerIdentity::Proof::User, .user = credentials.uid, .process = {}};
}

bool isTrusted(uid_t user, const std::vector<uid_t>& others) {
  return user == geteuid() || user == 0 ||
         std::find(others.begin(), others.end(), user) != others.end();
}

}  // namespace suture::net
