#pragma once
// Which demo of this machine may have real-time priorities.

namespace demo {

/// One demo at a time: the threads of two would leave to nobody else the time of two processors.
/// The turn ends with this object, and with the program, however that ends. It is kept by a Unix
/// socket's name, so demos see each other within one network namespace.
class RealTimeTurn {
 public:
  RealTimeTurn() = default;
  ~RealTimeTurn();
  RealTimeTurn(const RealTimeTurn&) = delete;
  RealTimeTurn& operator=(const RealTimeTurn&) = delete;

  /// False if another demo has it. To be called before this process changes its namespace.
  bool take();

 private:
  int socket_ = -1;
};

}  // namespace demo
