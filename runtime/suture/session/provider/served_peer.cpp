#include <suture/loop/failure.h>
#include <suture/session/provider/served_peer.h>

namespace suture {

ServedPeer::ServedPeer(SharedBySessions& shared, std::shared_ptr<framing::Caller> caller)
    : shared_(shared),
      caller_(std::move(caller)),
      admission_(shared.directory.process(), shared.policy, caller_->identity) {}

void ServedPeer::greet(std::string bootId, std::uint64_t incarnation) {
  greeting_ = {.bootId = std::move(bootId),
               .incarnation = incarnation,
               .number = shared_.latest.nextGreeting()};
  caller_->known = true;
}

Endpoint ServedPeer::endpoint(capnp::Text::Reader component, capnp::Text::Reader interface) const {
  return {shared_.directory.process(), codec::stringOf(component), codec::stringOf(interface)};
}

void ServedPeer::refuse(const Refusal& refusal, wire::Refusal::Builder out) {
  note(refusal.text);
  toWire(refusal, out);
}

void ServedPeer::note(const std::string& why) { shared_.refusals.add(name(), why); }

kj::Promise<void> ServedPeer::fail(const std::string& why) {
  note(why);
  return loop::failure(kj::Exception::Type::FAILED, why);
}

}  // namespace suture
