#include <suture/base/errors.h>
#include <suture/session/provider/shared/awaited_sockets.h>
#include <sys/random.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace suture {
namespace {

bool isSame(const net::PeerIdentity& one, const net::PeerIdentity& other) {
  return one.proof == other.proof && one.user == other.user && one.process == other.process;
}

// Fills memory with bytes that no peer can guess.
void fillWithRandom(framing::Token& token) {
  if (getrandom(token.data(), token.size(), 0) == static_cast<ssize_t>(token.size())) return;
  throw SetupError("get random bytes for a connection", std::strerror(errno), "Try again");
}

}  // namespace

kj::Own<AwaitedSockets::Awaiting> AwaitedSockets::await(const net::PeerIdentity& who, Take take) {
  framing::Token token;
  fillWithRandom(token);
  all_.insert_or_assign(token, One{who, kj::mv(take)});
  return kj::heap<Awaiting>(all_, token);
}

bool AwaitedSockets::arrived(const framing::Token& token, net::ByteStream bytes) {
  const auto found = all_.find(token);
  if (found == all_.end() || !isSame(found->second.who, bytes.peer())) return false;
  auto awaited = all_.extract(found);
  if (framing::sendToken(bytes, token)) awaited.mapped().take(kj::mv(bytes));
  return true;
}

}  // namespace suture
