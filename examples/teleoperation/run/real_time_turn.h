#pragma once
// This says which demo of this machine may have real-time priorities.

namespace demo {

/// Gives one demo at a time real-time priorities, because the threads of two would leave no time of
/// two processors to others. The turn ends with this object, and with the program, however that
/// ends. A Unix socket's name holds it, so demos see each other within one network namespace.
class RealTimeTurn {
 public:
  RealTimeTurn() = default;
  ~RealTimeTurn();
  RealTimeTurn(const RealTimeTurn&) = delete;
  RealTimeTurn& operator=(const RealTimeTurn&) = delete;

  /// Takes the turn; returns false if another demo has it. Call it before this process changes its
  /// namespace.
  bool take();

 private:
  int socket_ = -1;
};

}  // namespace demo
