#pragma once
// These are second connections of peers that are on their way to this process.

#include <kj/function.h>
#include <suture/framing/preamble.h>
#include <suture/net/byte_stream.h>
#include <suture/net/peer_identity.h>

#include <map>

namespace suture {

/// Belongs to the control thread; outlives what is awaited.
class AwaitedSockets {
 public:
  using Take = kj::Function<void(net::ByteStream)>;

 private:
  struct One {
    net::PeerIdentity who;
    Take take;
  };
  using All = std::map<framing::Token, One>;

 public:
  /// Awaits the connection as long as this lives, and until it has come.
  class Awaiting {
   public:
    Awaiting(All& all, const framing::Token& token) : all_(all), token_(token) {}
    ~Awaiting() { all_.erase(token_); }
    KJ_DISALLOW_COPY(Awaiting);
    const framing::Token& token() const { return token_; }

   private:
    All& all_;
    const framing::Token token_;
  };

  /// Calls `take` once with the connection of `who` that shows the token; `take` may drop what this
  /// returns. Throws SetupError if the kernel refuses.
  kj::Own<Awaiting> await(const net::PeerIdentity& who, Take take);

  /// Takes a connection that has come and shows `token`. Closes it, and returns false, if it is not
  /// awaited, or not any more, or not of this peer.
  bool arrived(const framing::Token& token, net::ByteStream bytes);

 private:
  All all_;
};

}  // namespace suture
