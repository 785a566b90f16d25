#pragma once
// Tests turn both links of a socket by hand with this.

#include <suture/lane/frame/frame_link.h>

#include <memory>

#include "support/socket_pair.h"

namespace suture::frame {

/// Holds the client's link and the provider's.
struct JoinedLinks {
  JoinedLinks() : JoinedLinks(makeSocketPair()) {}
  explicit JoinedLinks(SocketPair pair)
      : near(std::make_unique<FrameLink>(net::ByteStream(kj::mv(pair.ours)), 1)),
        far(std::make_unique<FrameLink>(net::ByteStream(kj::mv(pair.theirs)), 1)) {}

  /// Gives each of them one turn, the provider's first: the client has what it sends.
  void turn() {
    for (FrameLink* const one : {far.get(), near.get()}) {
      one->arrived();
      one->turn();
    }
  }
  /// Gives them as many turns as a question and its answer take.
  void exchange() {
    for (int lap = 0; lap < 3; ++lap) turn();
  }

  std::unique_ptr<FrameLink> near, far;
};

}  // namespace suture::frame
