#pragma once
// This is a peer that this process serves: who it is, and how it is answered.

#include <suture/base/errors.h>
#include <suture/component/channel/peer_state.h>
#include <suture/framing/link_server.h>
#include <suture/names/records.h>
#include <suture/session/provider/admission.h>
#include <suture/session/provider/shared/shared_by_sessions.h>
#include <suture/wiring/endpoint.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace suture {

/// Belongs to the control thread.
class ServedPeer {
 public:
  ServedPeer(SharedBySessions& shared, std::shared_ptr<framing::Caller> caller);

  /// A Greeting is what it says of itself when it begins the session.
  struct Greeting {
    std::string bootId;
    std::uint64_t incarnation = 0;
    std::uint64_t number = 0;  ///< which of all that this process has had
  };
  /// Takes down what it says, and makes it known to the link.
  void greet(std::string bootId, std::uint64_t incarnation);

  SharedBySessions& shared() { return shared_; }
  framing::Caller& caller() { return *caller_; }
  const Admission& admission() const { return admission_; }
  const Greeting& greeting() const { return greeting_; }
  const std::shared_ptr<PeerState>& state() const { return state_; }
  /// Returns who has proved to be behind the session.
  std::string name() const { return caller_->identity.text(); }
  /// Returns the interface of this process that the peer names.
  Endpoint endpoint(capnp::Text::Reader component, capnp::Text::Reader interface) const;

  /// Tells the peer and, in this process, its operator.
  void refuse(const Refusal& refusal, wire::Refusal::Builder out);
  /// Tells the operator of this process alone.
  void note(const std::string& why);
  /// Returns a call that fails. Tells also the operator of this process.
  kj::Promise<void> fail(const std::string& why);
  /// Answers a call that asks for an interface: refuses it if that is withheld; else returns what
  /// `attempt()` does. If that throws SetupError, calls it once more when the process has
  /// published, and refuses the call if it throws again.
  template <class Context, class Attempt>
  kj::Promise<void> serve(Context context, const std::optional<Refusal>& withheld, Attempt attempt);

 private:
  SharedBySessions& shared_;
  const std::shared_ptr<framing::Caller> caller_;
  const Admission admission_;
  const std::shared_ptr<PeerState> state_ = std::make_shared<PeerState>();
  Greeting greeting_;
};

template <class Context, class Attempt>
kj::Promise<void> ServedPeer::serve(Context context, const std::optional<Refusal>& withheld,
                                    Attempt attempt) {
  if (withheld) {
    refuse(*withheld, context.getResults().initRefused());
    return kj::READY_NOW;
  }
  caller_->known = true;
  context.allowCancellation();  // the peer may give up, and this process leave before it publishes
  try {
    return attempt();
  } catch (const SetupError&) {
    // The interface may still come, since the process may still be adding components.
  }
  return shared_.published.reached().then(
      [this, context, attempt = std::move(attempt)]() mutable -> kj::Promise<void> {
        try {
          return attempt();
        } catch (const SetupError& error) {
          refuse(Refusal{wire::Refusal::Kind::NO_SUCH_INTERFACE, error.what()},
                 context.getResults().initRefused());
          return kj::READY_NOW;
        }
      });
}

}  // namespace suture
