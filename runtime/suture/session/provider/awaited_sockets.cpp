#include <suture/base/errors.h>
#include <suture/session/provider/awaited_sockets.h>
#include <sys/random.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace suture {
namespace {

bool isSame(const rpc::PeerIdentity& one, const rpc::PeerIdentity& other) {
  return one.proof == other.proof && one.user == other.user && one.process == other.process;
}

// Fills memory with bytes that no peer can guess.
void fillWithRandom(rpc::Token& token) {
  if (getrandom(token.data(), token.size(), 0) == static_cast<ssize_t>(token.size())) return;
  throw SetupError("get random bytes for a connection", std::strerror(errno), "Try again");
}

}  // namespace

kj::Own<AwaitedSockets::Awaiting> AwaitedSockets::await(const rpc::PeerIdentity& who, Take take) {
  rpc::Token token;
  fillWithRandom(token);
  all_.insert_or_assign(token, One{who, kj::mv(take)});
  return kj::heap<Awaiting>(all_, token);
}

bool AwaitedSockets::arrived(const rpc::Token& token, rpc::ByteStream bytes) {
  const auto found = all_.find(token);
  if (found == all_.end() || !isSame(found->second.who, bytes.peer())) return false;
  auto awaited = all_.extract(found);
  if (rpc::sendToken(bytes, token)) awaited.mapped().take(kj::mv(bytes));
  return true;
}

}  // namespace suture
