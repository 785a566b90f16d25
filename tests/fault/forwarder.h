#pragma once
// This puts a proxy between a client and its provider, by the provider's name.

#include <suture/loop/control_thread.h>
#include <suture/names/manager_link.h>

#include <memory>
#include <string>
#include <vector>

#include "fault/byte_proxy.h"
#include "support/patience.h"

namespace suture {

/// Tells the global manager what a process that forwards a port would: a name, and where it is.
class Forwarder {
 public:
  /// Its proxy listens at `here`.
  Forwarder(const std::string& manager, const std::string& name, const std::string& behind,
            const net::Address& here, unsigned seed) {
    control_.run(kPatience, [&, name, behind, here, address = net::Address::parse(manager)] {
      link_ = std::make_unique<ManagerLink>(control_, std::vector{address}, "forwarder");
      return link_->open(kPatience)
          .then([this, behind] { return link_->resolve(behind, kPatience); })
          .then([this, name, here, seed](ProcessRecord found) {
            const auto target = net::Address::parse(found.addresses.at(0));
            proxy = std::make_unique<ByteProxy>(here, target, seed);
            found.name = name;
            found.addresses = {proxy->address()};
            return link_->enrol(found);
          });
    });
  }
  ~Forwarder() {
    control_.run(kPatience, [this] { link_.reset(); });
  }
  Forwarder(const Forwarder&) = delete;
  Forwarder& operator=(const Forwarder&) = delete;

  std::unique_ptr<ByteProxy> proxy;

 private:
  loop::ControlThread control_;
  std::unique_ptr<ManagerLink> link_;
};

}  // namespace suture
