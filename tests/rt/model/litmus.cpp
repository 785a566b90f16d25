#include "rt/model/litmus.h"

namespace model::litmus {
namespace {

struct Two {
  std::atomic<int> x{0}, y{0};
  int first = 0, second = 0;
  std::uint64_t message = 0;
};

void twice(std::atomic<int>& place) {
  place.store(1);
  place.store(2);
}

void addOne(std::atomic<int>& place) { place.store(place.load() + 1); }

Run message(std::memory_order order) {
  const auto it = std::make_shared<Two>();
  auto* word = reinterpret_cast<std::byte*>(&it->message);
  return {.threads = {[it, word, order] {
                        write(word, 42);
                        it->x.store(1, order);
                      },
                      [it, word] {
                        if (it->x.load(std::memory_order_acquire) == 1) {
                          require(read(word) == 42, "the message is not there");
                        }
                      }},
          .atEnd = [it] {}};
}

Run stores(std::memory_order storing, std::memory_order loading) {
  const auto it = std::make_shared<Two>();
  return {.threads = {[it, storing, loading] {
                        it->x.store(1, storing);
                        it->first = it->y.load(loading);
                      },
                      [it, storing, loading] {
                        it->y.store(1, storing);
                        it->second = it->x.load(loading);
                      }},
          .atEnd = [it] { require(it->first + it->second > 0, "neither saw the other"); }};
}

}  // namespace

Run twoWritersOfOnePlace() {
  const auto it = std::make_shared<Two>();
  return {.threads = {[it] { twice(it->x); }, [it] { twice(it->x); }}, .atEnd = [it] {}};
}

Run twoWritersOfTwoPlaces() {
  const auto it = std::make_shared<Two>();
  return {.threads = {[it] { twice(it->x); }, [it] { twice(it->y); }}, .atEnd = [it] {}};
}

Run lostUpdate() {
  const auto it = std::make_shared<Two>();
  return {.threads = {[it] { addOne(it->x); }, [it] { addOne(it->x); }},
          .atEnd = [it] { require(it->x.load() == 2, "an update is lost"); }};
}

Run noLostUpdate() {
  const auto it = std::make_shared<Two>();
  return {.threads = {[it] { it->x.fetch_add(1); }, [it] { it->x.fetch_add(1); }},
          .atEnd = [it] { require(it->x.load() == 2, "an update is lost"); }};
}

Run messageReleased() { return message(std::memory_order_release); }

Run messageNotReleased() { return message(std::memory_order_relaxed); }

Run storeBuffering() { return stores(std::memory_order_release, std::memory_order_acquire); }

Run storeBufferingSequential() {
  return stores(std::memory_order_seq_cst, std::memory_order_seq_cst);
}

Run readTwice() {
  const auto it = std::make_shared<Two>();
  return {.threads = {[it] { twice(it->x); },
                      [it] {
                        it->first = it->x.load(std::memory_order_relaxed);
                        it->second = it->x.load(std::memory_order_relaxed);
                        require(it->second >= it->first, "a place went back in time");
                      }},
          .atEnd = [it] {}};
}

}  // namespace model::litmus
