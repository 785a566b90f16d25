#pragma once
// This is the provider's end of the connection under test, in whichever process it lives.

#include <suture/manager/manager.h>
#include <suture/names/security.h>

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "conformance/crossing.h"
#include "conformance/ends/arm.h"
#include "conformance/ends/fork.h"
#include "conformance/rows.h"
#include "fault/history/history_sums.h"
#include "support/cable.h"

namespace conformance {

/// Returns what proves that a process is `process`: its files in the folder `keys`; nothing if that
/// is "".
suture::Security securityOf(const std::string& process, const std::string& keys);

/// Holds what there is in the provider's process.
struct Hosted {
  std::unique_ptr<ArmComponent> arm;
  std::unique_ptr<suture::Manager> manager;
};

/// Any thread may use it, once it is made. Holds an arm and its manager, here or in a fork of this
/// process.
class Provider {
 public:
  /// Call it before this process has a second thread.
  Provider(ProviderKind kind, Where where);

  /// Starts it as process "provider" of that global manager; if that is "", the client shares its
  /// manager, and starts it.
  void start(const std::string& address, const std::string& keys = "");
  void stop();
  /// Returns the manager; call it only in one process.
  suture::Manager& manager() { return *hosted_->manager; }

  /// Returns the gate of the arm, in whichever process that is.
  Gate& gate() const { return *gate_; }

  /// Runs `work` with the arm where that lives, and returns what it returns. Both may cross to
  /// another process as bytes: `work` must not refer to anything of this one.
  template <class Work>
  std::invoke_result_t<Work, ArmComponent&> at(Work work) const {
    return run([work](Hosted& hosted) { return work(*hosted.arm); });
  }
  /// Runs `emission` where this kind of component emits.
  template <class Emission>
  void emitSoon(Emission emission) const {
    at([emission](ArmComponent& arm) { arm.emitSoon(emission); });
  }

  std::vector<std::string> taken() const {
    return at([](ArmComponent& arm) { return arm.taken(); });
  }
  std::vector<std::string> clients() const {
    return at([](ArmComponent& arm) { return arm.clients(); });
  }
  /// Returns "" if nothing has been taken.
  std::string lastTaken() const {
    const std::vector<std::string> lines = taken();
    return lines.empty() ? "" : lines.back();
  }
  int emitted() const {
    return at([](ArmComponent& arm) { return arm.emitted(); });
  }
  suture::ComponentState state() const {
    return at([](ArmComponent& arm) { return arm.component().state(); });
  }
  std::string fault() const {
    return at([](ArmComponent& arm) { return arm.component().fault(); });
  }
  /// Lets the arm note what its process reports of its commands.
  void noteLedger() const {
    run([](Hosted& hosted) {
      const auto served = reportOf(*hosted.manager, suture::ConnectionEnd::Provider);
      hosted.arm->noteLedger(sumsOf(served, hosted.manager->incarnation()));
    });
  }

 private:
  const std::unique_ptr<Gate> gate_ = std::make_unique<Gate>();
  std::optional<suture::Cable> cable_;
  std::unique_ptr<Hosted> hosted_;  // if it is here
  std::unique_ptr<Fork> fork_;      // if it is not

  template <class Work>
  std::invoke_result_t<Work, Hosted&> run(Work work) const {
    if (hosted_ != nullptr) return work(*hosted_);
    using Result = std::invoke_result_t<Work, Hosted&>;
    return fromBytes<Result>(fork_->ask(&perform<Work>, toBytes(work)));
  }
  template <class Work>
  static std::string perform(void* made, const std::string& bytes) {
    const Work work = fromBytes<Work>(bytes);
    auto& hosted = *static_cast<Hosted*>(made);
    if constexpr (std::is_void_v<std::invoke_result_t<Work, Hosted&>>) {
      work(hosted);
      return "";
    } else {
      return toBytes(work(hosted));
    }
  }
};

}  // namespace conformance
