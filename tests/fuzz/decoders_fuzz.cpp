// This gives any bytes to the decoders of generated types: the first byte chooses the type, and the
// rest is taken for a message from a socket, which goes the same way here.

#include <kj/exception.h>
#include <suture/framing/received_message.h>

#include <algorithm>

#include "tests/fuzz/random_message.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using namespace suture;
using namespace suture::fuzz;

const Decoder& chosen(std::uint8_t byte) { return decoders()[byte % decoders().size()]; }

void receive(const Decoder& decoder, std::span<const std::byte> bytes) {
  framing::StreamLimits limits;
  limits.messageBytes = 1u << 16;
  const auto header = framing::parseMessageHeader(bytes, limits).header;
  if (!header || header->totalBytes > bytes.size()) return;
  auto words = kj::heapArray<capnp::word>(header->totalBytes / sizeof(capnp::word));
  std::memcpy(words.begin(), bytes.data(), header->totalBytes);
  capnp::ReaderOptions options;
  options.traversalLimitInWords =
      2 * limits.messageBytes / sizeof(capnp::word);  // as MessageStream does
  framing::ReceivedMessage message(kj::mv(words), *header, options);
  decoder.check(message);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    receive(chosen(data[0]), std::as_bytes(std::span(data, size)).subspan(1));
  } catch (const kj::Exception&) {  // capnp refuses in this way what is no message
  }
  return 0;
}

// Now and then this makes a whole message of the schema, since mutated bytes seldom become one.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  if (size > 0 && seed % 8 != 0) return LLVMFuzzerMutate(data, size, most);
  Random random(seed);
  const auto type = static_cast<std::uint8_t>(random() % decoders().size());
  const auto frame = randomFrame(chosen(type), random);
  if (frame.size() + 1 > most) return LLVMFuzzerMutate(data, size, most);
  data[0] = type;
  std::memcpy(data + 1, frame.data(), frame.size());
  return frame.size() + 1;
}
