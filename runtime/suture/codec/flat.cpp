#include <capnp/serialize.h>
#include <suture/codec/flat.h>

#include <algorithm>
#include <cstring>

namespace suture::codec {

std::vector<std::byte> flatBytes(capnp::MessageBuilder& message) {
  const kj::Array<capnp::word> words = capnp::messageToFlatArray(message);
  const auto bytes = words.asBytes();
  const auto* const begin = reinterpret_cast<const std::byte*>(bytes.begin());
  return {begin, begin + bytes.size()};
}

Errc readFlat(std::span<const std::byte> bytes,
              const std::function<Errc(capnp::AnyPointer::Reader)>& read) {
  if (bytes.empty() || bytes.size() % sizeof(capnp::word) != 0) return Errc::Invalid;
  // A message has to be aligned, and the caller's bytes need not be.
  auto words = kj::heapArray<capnp::word>(bytes.size() / sizeof(capnp::word));
  std::memcpy(words.asBytes().begin(), bytes.data(), bytes.size());
  capnp::ReaderOptions options;
  options.traversalLimitInWords =
      std::max<std::uint64_t>(options.traversalLimitInWords, words.size());
  Errc error = Errc::Invalid;
  const auto failure = kj::runCatchingExceptions([&] {
    capnp::FlatArrayMessageReader message(words, options);
    if (message.getEnd() != words.end()) return;
    error = read(message.getRoot<capnp::AnyPointer>());
  });
  return failure == nullptr ? error : Errc::Invalid;
}

}  // namespace suture::codec
