// These use the rings and the newest-wins cell: what comes out is what went in, in order, and
// complete.
#include <suture/rt/queue/latest_cell.h>
#include <suture/rt/queue/mpsc_ring.h>
#include <suture/rt/queue/spsc_ring.h>

#include "rt/model/scenarios.h"

namespace model {
namespace {

namespace rt = suture::rt;

/// A payload is its serial number twice: more than one access, so that it can be torn.
void put(std::byte* memory, std::uint64_t serial) {
  write(memory, serial);
  write(memory + 8, serial);
}

std::uint64_t take(const std::byte* memory) {
  const std::uint64_t serial = read(memory);
  require(read(memory + 8) == serial, "a payload is torn");
  return serial;
}

struct Spsc {
  // 128 bytes: the third record finds no room before the end, the fourth none until one is taken.
  rt::SpscRing ring{80, 40};
  std::uint64_t sent = 0, taken = 0;

  void send(std::size_t length) {
    std::byte* memory = ring.claim(length);
    if (memory == nullptr) return;
    put(memory, ++sent);
    ring.commit();
  }
  void receive() {
    const std::byte* memory = ring.front();
    if (memory == nullptr) return;
    require(take(memory) == ++taken, "a record is lost, or out of order");
    ring.pop();
  }
};

}  // namespace

Run spscRing() {
  const auto it = std::make_shared<Spsc>();
  return {.threads = {[it] {
                        for (const std::size_t length : {40, 24, 40, 16, 32}) it->send(length);
                      },
                      [it] {
                        for (int i = 0; i < 4; ++i) it->receive();
                      }},
          .atEnd = [it] {
            for (int i = 0; i < 5; ++i) it->receive();
            require(it->taken == it->sent, "a record is lost");
            require(it->sent >= 2, "a record was refused though there was room");
          }};
}

namespace {

struct Mpsc {
  rt::MpscRing ring{2, 16};
  std::uint64_t sent[2] = {}, taken[2] = {};

  void send(std::uint64_t producer) {
    std::byte* cell = ring.claim();
    if (cell == nullptr) return;
    put(cell, 2 * ++sent[producer] + producer);
    ring.commit(cell);
  }
  void receive() {
    const std::byte* cell = ring.front();
    if (cell == nullptr) return;
    const std::uint64_t serial = take(cell);
    require(serial / 2 == ++taken[serial % 2], "a cell is lost, or out of its producer's order");
    ring.pop();
  }
};

}  // namespace

Run mpscRing() {
  const auto it = std::make_shared<Mpsc>();
  return {.threads = {[it] {
                        it->send(0);
                        it->send(0);
                      },
                      [it] { it->send(1); },
                      [it] {
                        for (int i = 0; i < 3; ++i) it->receive();
                      }},
          .atEnd = [it] {
            for (int i = 0; i < 3; ++i) it->receive();
            for (int i = 0; i < 2; ++i) require(it->taken[i] == it->sent[i], "a cell is lost");
          }};
}

namespace {

struct Latest {
  rt::LatestCell cell{16};
  std::uint64_t taken = 0;

  void send(std::uint64_t serial) {
    put(cell.claim(), serial);
    cell.commit();
  }
  void receive() {
    if (!cell.take()) return;
    const std::uint64_t serial = take(cell.front());
    require(serial > taken, "an older value came after a newer one");
    taken = serial;
  }
};

}  // namespace

Run latestCell() {
  const auto it = std::make_shared<Latest>();
  return {.threads = {[it] {
                        for (std::uint64_t serial = 1; serial <= 5; ++serial) it->send(serial);
                      },
                      [it] {
                        for (int i = 0; i < 4; ++i) it->receive();
                      }},
          .atEnd = [it] {
            it->receive();
            require(it->taken == 5, "the newest value is lost");
          }};
}

}  // namespace model
