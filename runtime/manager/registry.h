#pragma once
// The names that a global manager knows.

#include <suture/manager/records.h>

#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace suture {

/// Processes by name. Plain data of one thread.
class Registry {
 public:
  /// The generation under which the process is now known; or a refusal: the name is taken, or is
  /// none.
  tl::expected<std::uint64_t, Refusal> add(ProcessRecord process);
  /// Replaces the components of a process. Ignored if the name has gone to a later generation.
  void update(const std::string& name, std::uint64_t generation,
              std::vector<ComponentRecord> components);
  /// Frees the name. Ignored if it has gone to a later generation.
  void remove(const std::string& name, std::uint64_t generation);

  const ProcessRecord* find(const std::string& name) const;
  std::vector<ProcessRecord> list() const;
  /// Why `name` cannot be found: what there is, and which comes closest. `waitedMilliseconds` are
  /// told if not 0.
  Refusal unknown(const std::string& name, std::uint32_t waitedMilliseconds) const;

 private:
  std::map<std::string, ProcessRecord> processes_;
  std::uint64_t generation_ = 0;
};

}  // namespace suture
