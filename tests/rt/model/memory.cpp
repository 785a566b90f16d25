#include "rt/model/memory.h"

#include <algorithm>

namespace model {
namespace {

// A store becomes visible in finite time, so a thread may miss it only this often in a row.
constexpr unsigned kMaxStale = 2;

}  // namespace

void Memory::begin(std::size_t threads) {
  threads_ = threads;
  places_.clear();
  shadows_.clear();
  for (std::size_t i = 0; i < kMaxThreads; ++i) {
    clocks_[i] = {};
    clocks_[i][i] = 1;
  }
}

void Memory::join(Clock& clock, const Clock& other) {
  for (std::size_t i = 0; i < kMaxThreads; ++i) clock[i] = std::max(clock[i], other[i]);
}

Memory::Place& Memory::at(const void* place, std::uint64_t initial) {
  Place& found = places_[place];
  if (found.stores.empty()) found.stores.push_back({.value = initial});  // before all threads
  return found;
}

std::size_t Memory::oldestVisible(std::size_t thread, const Place& place) const {
  const Clock& clock = clocks_[thread];
  std::size_t oldest = place.stores.size() - 1;
  while (place.stores[oldest].time > clock[place.stores[oldest].writer]) --oldest;
  for (std::size_t reader = 0; reader < threads_; ++reader) {
    for (const Sight& sight : place.seen[reader]) {
      if (sight.time <= clock[reader]) oldest = std::max(oldest, sight.store);
    }
  }
  return oldest;
}

std::size_t Memory::choices(std::size_t thread, const void* place, std::uint64_t initial) {
  const Place& found = at(place, initial);
  if (found.stale[thread] >= kMaxStale) return 1;
  return found.stores.size() - oldestVisible(thread, found);
}

std::uint64_t Memory::load(std::size_t thread, const void* place, std::size_t age, bool acquires) {
  Place& found = places_.at(place);
  const std::size_t index = found.stores.size() - 1 - age;
  found.stale[thread] = age == 0 ? 0 : found.stale[thread] + 1;
  found.seen[thread].push_back({clocks_[thread][thread], index});
  if (acquires) join(clocks_[thread], found.stores[index].carries);
  return found.stores[index].value;
}

void Memory::store(std::size_t thread, const void* place, std::uint64_t initial,
                   std::uint64_t value, bool releases, bool readModifyWrite) {
  Place& found = at(place, initial);
  Clock& clock = clocks_[thread];
  Store store{.value = value, .writer = thread, .time = clock[thread]};
  if (readModifyWrite) store.carries = found.stores.back().carries;  // the release sequence goes on
  if (releases) join(store.carries, clock);
  found.stores.push_back(store);
  found.stale[thread] = 0;
  ++clock[thread];
}

const char* Memory::plain(std::size_t thread, const void* word, bool writes) {
  const Clock& clock = clocks_[thread];
  Shadow& shadow = shadows_[word];
  if (shadow.written > clock[shadow.writer]) return "a race on plain memory: written unordered";
  if (!writes) {
    shadow.read[thread] = clock[thread];
    return nullptr;
  }
  for (std::size_t i = 0; i < threads_; ++i) {
    if (i != thread && shadow.read[i] > clock[i]) {
      return "a race on plain memory: overwritten while it may be read";
    }
  }
  shadow.writer = thread;
  shadow.written = clock[thread];
  return nullptr;
}

}  // namespace model
