#pragma once
// This is a network namespace whose only way out is a TUN device.

#include <string>

namespace experiment {

/// A LinkEnd is one end of a link, to a machine of its own as far as the network goes. It is gone
/// when this is, and every thread that has entered it.
class LinkEnd {
 public:
  /// `address` and `peer` are IPv4, of this end and of the other one. Throws suture::SetupError
  /// without the rights for it, without /dev/net/tun, and without iproute2.
  LinkEnd(const std::string& address, const std::string& peer);
  ~LinkEnd();
  LinkEnd(const LinkEnd&) = delete;
  LinkEnd& operator=(const LinkEnd&) = delete;

  /// Returns the descriptor of this end's IP packets: a read takes one that its kernel sends, a
  /// write has one arrive; both never block.
  int packets() const { return packets_; }
  /// Moves the calling thread there; the threads and processes that it starts are there too. Throws
  /// suture::SetupError.
  void enter() const;

 private:
  void closeAll() const;

  int namespace_ = -1, packets_ = -1;
};

}  // namespace experiment
