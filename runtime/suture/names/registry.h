#pragma once
// These are the names that a global manager knows.

#include <suture/names/records.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace suture {

/// Returns why no process can have that name, and what to do; "" if one can.
std::string whyNoName(const std::string& name);

/// Counts what a registry holds for one link, or for all links of one peer. The registry keeps it,
/// and shares it with those that add names for the link.
struct Holding {
  std::size_t names = 0, bytes = 0;
  std::shared_ptr<Holding> peer;  ///< of a link whose peer has proved who it is
};

/// One thread uses it. Knows processes by name. What one record, one link, one peer, and all of
/// them may hold is bounded, so that no peer can fill the process that knows names, nor take the
/// room of others.
class Registry {
 public:
  static constexpr std::size_t kMostBytesOfARecord = 1u << 20;
  static constexpr std::size_t kMostBytesOfALink = 4u << 20;
  static constexpr std::size_t kMostNamesOfALink = 64;
  static constexpr std::size_t kMostNames = 4096, kMostNamesOfAPeer = kMostNames / 2;
  static constexpr std::size_t kMostBytes = 64u << 20, kMostBytesOfAPeer = kMostBytes / 2;
  static constexpr std::size_t kBytesOfAPage = 1u << 20;

  /// Returns the generation under which the process is now known, or a refusal: a process that is
  /// not silent has the name, or it is no name, or a limit is reached.
  tl::expected<std::uint64_t, Refusal> add(ProcessRecord process, std::shared_ptr<Holding> holding);
  /// Replaces the components of a process, or refuses to, because a limit is reached. Does nothing
  /// if the name has gone to a later generation.
  tl::expected<void, Refusal> update(const std::string& name, std::uint64_t generation,
                                     std::vector<ComponentRecord> components);
  /// Notes that the process lives. Returns false if the name has gone to a later generation.
  bool renew(const std::string& name, std::uint64_t generation);
  /// Call it as often as leases must be renewed: a process that has not renewed for too many calls
  /// is silent. A manager that was stopped has not called it, and so takes no process for silent.
  void age();
  /// Frees the name. Does nothing if it has gone to a later generation.
  void remove(const std::string& name, std::uint64_t generation);

  /// Returns a refusal for a name that no process can have, because it is too long.
  static std::optional<Refusal> whyTooLong(const std::string& name);
  /// Returns null if there is no such process, or it is silent.
  const ProcessRecord* find(const std::string& name) const;
  /// A Page has processes in the order of their names, the silent ones too.
  struct Page {
    std::vector<ProcessRecord> processes;
    bool more = false;  ///< there are more behind the last of them
  };
  /// Returns those behind the name `after`, until they take `bytes`; at least one, if there is any.
  Page list(const std::string& after = "", std::size_t bytes = kBytesOfAPage) const;
  /// Says why `name` cannot be found: it is silent, or what there is, and which comes closest. It
  /// mentions `waitedMilliseconds` if not 0.
  Refusal unknown(const std::string& name, std::uint32_t waitedMilliseconds) const;

 private:
  struct Entry {
    ProcessRecord process;
    std::size_t bytes = 0;
    std::shared_ptr<Holding> holding;
    unsigned missed = 0;  ///< renewals that were missed since the latest, or since it was added
  };

  using Processes = std::map<std::string, Entry>;

  Entry* held(const std::string& name, std::uint64_t generation);
  void erase(Processes::iterator entry);
  /// Counts so many more, which may be less, for the link, for its peer and in all.
  void count(Holding& link, std::ptrdiff_t names, std::ptrdiff_t bytes);
  std::optional<Refusal> whyNot(const ProcessRecord& process, std::size_t bytes,
                                const Holding& holding) const;
  /// Returns which limit a record of `bytes` would exceed in place of what `name` has now; "" if it
  /// exceeds none.
  std::string whyTooMuch(const std::string& name, std::size_t bytes, const Holding& holding) const;

  Processes processes_;
  std::size_t bytes_ = 0;  // the sum over all processes
  std::uint64_t generation_ = 0;
};

}  // namespace suture
