#pragma once
// This is one end of a scenario: a component of any kind that serves the contract and uses that of
// the other end.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rt/scenarios/store.h"

namespace suture {
class Manager;
}

namespace scenarios {

/// Says where a component's code runs: the original's kinds, and the task that borrows a thread.
enum class Kind { Device, Periodic, Continuous, FromSignal, FromCallback, Guest };

/// Holds what arrived as events.
struct Received {
  std::vector<double> scalars;
  std::vector<Vector> vectors;
  std::vector<PosePrm> records;
  std::vector<std::string> texts;
  int cleared = 0;

  void listen(Used& used);
};

class End {
 public:
  virtual ~End() = default;

  /// Adds the component, and what it needs to run, to `manager`.
  virtual void addTo(suture::Manager& manager, const std::string& name) = 0;
  /// The test calls this after the manager's start(), and end() before its stop().
  virtual void begin() {}
  virtual void end() {}

  /// Runs `work` in the component's thread, which is the caller's for a device, and returns when it
  /// has ended.
  virtual void with(const std::function<void(Used&)>& work) = 0;
  /// Waits until its code finds the other end connected, at most 10 s: one that is in a cycle when
  /// it is connected takes the connection over in its next.
  bool awaitConnection();
  /// Lets it look at what has been received until `enough` says so, at most 10 s.
  bool await(const std::function<bool(const Received&)>& enough);

 protected:
  /// Returns what has arrived until now; call it in the component's thread.
  virtual const Received& received() = 0;
};

std::unique_ptr<End> makeEnd(Kind kind);

}  // namespace scenarios
