#pragma once
// A process tells people what becomes of its components and connections.

#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace suture {

/// Tells on standard error, unless the program takes what is told.
class Telling {
 public:
  using Taker = std::function<void(const std::string& line)>;

  explicit Telling(const std::string& process);

  /// Any thread. Lines then go to `taker`, or nowhere if it is null. A line of which it throws is
  /// told on standard error, because whoever tells has more to do than to tell.
  void giveTo(Taker taker);
  /// Any thread, also that of a task that has just faulted.
  void tell(const std::string& line) const;

 private:
  void print(const std::string& line) const;

  const std::string process_;
  mutable std::mutex mutex_;  // not held while a line is told
  std::shared_ptr<const Taker> taker_;
};

/// Says of a connection, or of a global manager, that it was missing.
inline constexpr const char* kIsThereAgain = "is there again";

/// Returns "is lost, closed: its process has ended. Start that process again ..." for the reason
/// that ConnectionNews has.
std::string lossText(std::string why);

}  // namespace suture
