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
  /// The generation under which the process is now known; or a refusal: the name is taken by one
  /// that is not silent, or is none.
  tl::expected<std::uint64_t, Refusal> add(ProcessRecord process);
  /// Replaces the components of a process. Ignored if the name has gone to a later generation.
  void update(const std::string& name, std::uint64_t generation,
              std::vector<ComponentRecord> components);
  /// The process lives. False: the name has gone to a later generation.
  bool renew(const std::string& name, std::uint64_t generation);
  /// To be called as often as leases are to be renewed, while this thread runs: who has not
  /// renewed for too many calls is silent. So a manager that was stopped itself holds nobody to be.
  void age();
  /// Frees the name. Ignored if it has gone to a later generation.
  void remove(const std::string& name, std::uint64_t generation);

  /// Null: nobody, or silent.
  const ProcessRecord* find(const std::string& name) const;
  /// The silent ones too.
  std::vector<ProcessRecord> list() const;
  /// Why `name` cannot be found: it is silent, or what there is, and which comes closest.
  /// `waitedMilliseconds` are told if not 0.
  Refusal unknown(const std::string& name, std::uint32_t waitedMilliseconds) const;

 private:
  struct Entry {
    ProcessRecord process;
    unsigned missed = 0;  ///< renewals, since the latest or since it was added
  };

  Entry* held(const std::string& name, std::uint64_t generation);

  std::map<std::string, Entry> processes_;
  std::uint64_t generation_ = 0;
};

}  // namespace suture
