#pragma once
// This is a session whose client a test plays.

#include <suture/framing/link.h>
#include <suture/loop/control_thread.h>
#include <suture/names/manager_link.h>
#include <suture/peer.capnp.h>

#include <string>
#include <vector>

#include "support/patience.h"

namespace reference {

/// Holds a control link to a process that the manager knows by name, on a control thread of its
/// own.
class PlayedClient {
 public:
  PlayedClient(const std::string& manager, const std::string& process) {
    control_.run(suture::kPatience, [&] {
      names_ = kj::heap<suture::ManagerLink>(
          control_, std::vector{suture::net::Address::parse(manager)}, kName);
      return names_->open(suture::kPatience)
          .then([&] { return names_->resolve(process, suture::kPatience); })
          .then([this](suture::ProcessRecord found) {
            provider_ = suture::net::Address::parse(found.addresses.at(0));
            return names_->reach(found, suture::kPatience);
          })
          .then([this](suture::net::ByteStream bytes) {
            auto stream = kj::heap<suture::framing::MessageStream>(control_.port(), kj::mv(bytes));
            session_ =
                kj::heap<suture::framing::Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT);
          });
    });
  }
  ~PlayedClient() {
    control_.run(suture::kPatience, [this] {
      session_ = nullptr;
      names_ = nullptr;
      return kj::Promise<void>(kj::READY_NOW);
    });
  }
  PlayedClient(const PlayedClient&) = delete;
  PlayedClient& operator=(const PlayedClient&) = delete;

  /// Says hello.
  void greet() {
    control_.run(suture::kPatience, [this] {
      auto hello = peer().helloRequest();
      hello.setVersion(suture::wire::PROTOCOL_VERSION);
      hello.setProcess(kName);
      return hello.send().ignoreResult();
    });
  }
  /// Returns where the process listens.
  const suture::net::Address& provider() const { return provider_; }

 protected:
  static constexpr const char* kName = "test";

  suture::wire::Peer::Client peer() { return session_->bootstrap<suture::wire::Peer>(); }

  suture::loop::ControlThread control_;

 private:
  suture::net::Address provider_;
  kj::Own<suture::ManagerLink> names_;
  kj::Own<suture::framing::Link> session_;
};

}  // namespace reference
