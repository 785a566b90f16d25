#pragma once
// A process tells people what becomes of its components and connections.

#include <functional>
#include <string>

namespace suture {

/// Tells on standard error, unless the program takes what is told.
class Telling {
 public:
  using Taker = std::function<void(const std::string& line)>;

  explicit Telling(const std::string& process);

  /// Before anything can be told. Lines then go to `taker`, or nowhere if it is null.
  void giveTo(Taker taker) { taker_ = std::move(taker); }
  /// Any thread, also that of a task that has just faulted.
  void tell(const std::string& line) const {
    if (taker_) taker_(line);
  }

 private:
  Taker taker_;
};

/// Returns "is lost, closed: its process has ended. Start that process again ..." for the reason
/// that ConnectionNews has.
std::string lossText(std::string why);

}  // namespace suture
