// This gives the reader of frames a stream of right ones that a fault has hit: what it hands out is
// what was written, in its order, from the first on.

#include <suture/lane/frame/bytes/frame_reader.h>
#include <suture/lane/frame/bytes/frame_writer.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "tests/fuzz/input.h"
#include "tests/fuzz/require.h"

namespace {

using namespace suture::frame;
using suture::fuzz::Input;
using suture::fuzz::require;

constexpr std::uint32_t kEpoch = 3;
constexpr std::size_t kLargest = 500;

std::byte fillOf(std::uint32_t sequence) { return static_cast<std::byte>(sequence * 7); }

std::vector<std::byte> rightFrames(Input& input, std::size_t count) {
  FrameWriter writer(kEpoch);
  for (std::uint32_t i = 1; i <= count; ++i) {
    const std::size_t size = input.two() % (kLargest + 1);
    const auto kind = static_cast<Kind>(input.byte() % kKinds);
    std::fill_n(writer.begin({.kind = kind, .call = i}, size), size, fillOf(i));
    writer.finish();
  }
  return {writer.unsent().begin(), writer.unsent().end()};
}

void hit(std::vector<std::byte>& bytes, Input& input) {
  if (bytes.empty()) return;
  const std::size_t at = input.two() % bytes.size(), count = input.byte();
  const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  switch (input.byte() % 5) {
    case 0: *place ^= static_cast<std::byte>(count); break;
    case 1: bytes.resize(at); break;
    case 2:
      bytes.erase(place, place + static_cast<std::ptrdiff_t>(std::min(count, bytes.size() - at)));
      break;
    case 3: bytes.insert(place, count, static_cast<std::byte>(input.byte())); break;
    case 4: {
      const std::vector<std::byte> copy(place, bytes.end());
      bytes.insert(place, copy.begin(), copy.end());
    }
  }
}

void read(const std::vector<std::byte>& bytes, std::size_t chunk, std::size_t count) {
  FrameReader reader(kEpoch);
  std::uint32_t sequence = 0;
  for (std::size_t done = 0; done < bytes.size() && reader.fault() == Fault::None;) {
    const auto space = reader.space();
    require(!space.empty());
    const std::size_t part = std::min({chunk, space.size(), bytes.size() - done});
    std::memcpy(space.data(), bytes.data() + done, part);
    reader.arrived(part);
    done += part;
    while (const Header* const header = reader.next()) {
      require(header->sequence == ++sequence && header->call == sequence && sequence <= count);
      const auto payload = reader.payload();
      require(std::all_of(payload.begin(), payload.end(),
                          [&](std::byte byte) { return byte == fillOf(sequence); }));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  const std::size_t chunk = input.two() + 1, count = input.byte() % 20;
  std::vector<std::byte> bytes = rightFrames(input, count);
  for (int faults = 0; faults < 8 && !input.ended() && bytes.size() < 1u << 20; ++faults) {
    hit(bytes, input);
  }
  read(bytes, chunk, count);
  return 0;
}
