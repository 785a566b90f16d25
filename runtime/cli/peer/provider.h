#pragma once
// This is a provided interface, used by a program that has learnt its contract from it.

#include <capnp/dynamic.h>
#include <suture/codec/json/to_json.h>
#include "cli/command_line/options.h"
#include "cli/peer/peer.h"
#include "cli/values/json.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace suture::cli {

/// Says how a command ended.
struct Answer {
  Json value;                   ///< null if it has none
  std::optional<Duration> age;  ///< how old the value that was read is when it arrives
  Duration ageError{0};         ///< how wrong the age may be; zero if both have one clock
};

/// Finds its process, links to that and opens it. All members throw SetupError, or their promises
/// reject.
class Provider {
 public:
  using Heard = std::function<void(const Member& event, const Json& value)>;

  /// `options` outlive it.
  Provider(loop::EventPort& loop, const Options& options, const Target& target);

  const Contract& contract() const { return *contract_; }

  /// Runs a command and waits for its end. Throws UsageError if the arguments do not fit it. If its
  /// component has faulted, it throws what that said.
  Answer call(const Member& command, const Json& arguments, codec::Labels labels);
  /// Does the same without waiting. Rejects where there is no answer in time.
  kj::Promise<Answer> start(const Member& command, const Json& arguments, codec::Labels labels);
  /// Asks for events, bit i for the contract's event i. `heard` is called as they arrive; while it
  /// works, the provider keeps what follows. Resolves when the provider has agreed, or rejects.
  kj::Promise<void> subscribe(std::uint64_t events, codec::Labels labels, Heard heard);
  /// Returns when the cycle is over in which the component answered last, but not later than the
  /// patience: so it has emitted what that cycle had to say.
  void awaitCycleEnd();
  /// Returns the time on our clock of a stamp of the provider's, and how wrong that may be.
  Time here(std::int64_t stamp) const { return peer_.here(stamp); }
  Duration clockError() const { return peer_.clock().error(now()); }
  /// Rejects when the provider's process is gone.
  kj::Promise<void> whenGone();
  /// Rejects when it is there and does not answer, as if it hangs.
  kj::Promise<void> whenSilent() { return peer_.whenSilent(); }

 private:
  std::string whyFaulted() const;
  std::optional<Duration> ageIn(capnp::DynamicStruct::Reader results) const;

  loop::EventPort& loop_;
  const Options& options_;
  const Duration patience_;
  const std::string process_, component_;
  Errc refusal_{};  // the last one
  Peer peer_;
  std::shared_ptr<const Contract> contract_;
  capnp::DynamicCapability::Client capability_;
};

}  // namespace suture::cli
