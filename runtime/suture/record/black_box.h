#pragma once
// This records what components were doing when one of them failed.

#include <suture/base/time.h>
#include <suture/component/component.h>
#include <suture/rt/thread.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace suture {

struct BlackBoxOptions {
  std::filesystem::path folder;              ///< it must exist
  std::string prefix = {};                   ///< before the component in the files' names
  Duration last = std::chrono::seconds(10);  ///< how far back it writes, if the tables keep it
  Duration period = std::chrono::milliseconds(10);  ///< how often it looks
  /// Each interface keeps at least this many rows of the past (ProvidedBase::keepState); with 0 it
  /// keeps as many as its component has asked for.
  unsigned rows = 0;
  /// The box calls this, in its own thread, with what has been written or why it could not be.
  /// If it is null, standard error gets that.
  std::function<void(const std::string&)> tell = nullptr;
};

/// Watches components from a thread of its own. When one has been faulted, writes the rows of its
/// state tables to "<folder>/<prefix><component>.<n>.jsonl" (JsonLines), where n is the number of
/// its fault. Faults that came since the last look share one file, which has the number of the last
/// of them; its first line says which they are. If the disk is full or the folder is missing,
/// reports that, leaves no part of a file there, and goes on. Of a device it has rows only if
/// remote clients read it; otherwise it writes the fault alone, and says so. It replaces a file of
/// the same name, so another run of the process needs another prefix.
class BlackBox {
 public:
  /// Before the components are started and connected. Asks for all reads that they provide, so that
  /// there are rows. The components must outlive this. Throws SetupError if there would be too many
  /// rows, or if the period is not positive.
  BlackBox(const std::vector<Component*>& components, BlackBoxOptions options);
  ~BlackBox();
  BlackBox(const BlackBox&) = delete;
  BlackBox& operator=(const BlackBox&) = delete;

 private:
  struct Watched {
    Component* component;
    std::uint64_t faults;  // how many of them have been seen
  };

  void watch();
  void look(Watched& watched);
  /// Writes the file for the faults number `first` to `last` of `component`, of which the last has
  /// `reason`.
  void write(const Component& component, std::uint64_t first, std::uint64_t last,
             const std::string& reason, const std::filesystem::path& file) const;

  const BlackBoxOptions options_;
  std::vector<Watched> watched_;
  rt::Doorbell ending_;
  rt::Thread thread_;  // last: it uses the others
};

}  // namespace suture
