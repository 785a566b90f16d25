#pragma once
// What components were doing when one of them failed.

#include <suture/base/time.h>
#include <suture/component/component.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace suture {

struct BlackBoxOptions {
  std::filesystem::path folder;              ///< exists
  Duration last = std::chrono::seconds(10);  ///< how far back it writes, if the tables keep it
  Duration period = std::chrono::milliseconds(10);  ///< how often it looks
  /// Told what has been written, or why it could not be; in the box's thread.
  std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// Watches components from a thread of its own, and each time one is faulted writes the rows of its
/// state tables (ProvidedBase::keepState says how many there are) to
/// "<folder>/<component>.<n>.jsonl", n its how many-th fault (JsonLines). A disk that is full or a
/// folder that is missing is told, and nothing else comes of it. Whoever restarts the process takes
/// the files away before: they are replaced.
class BlackBox {
 public:
  /// Asks for all reads that the components provide, so that there are rows. They outlive this.
  BlackBox(std::vector<Component*> components, BlackBoxOptions options);
  ~BlackBox();
  BlackBox(const BlackBox&) = delete;
  BlackBox& operator=(const BlackBox&) = delete;

 private:
  struct Watched {
    Component* component;
    std::uint64_t faults;  // as far as they have been seen
  };

  void watch();
  void look(Watched& watched);
  void write(const Component& component, const std::filesystem::path& file) const;

  const BlackBoxOptions options_;
  std::vector<Watched> watched_;
  std::mutex mutex_;  // no task takes it
  std::condition_variable ending_;
  bool end_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace suture
