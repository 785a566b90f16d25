#include <suture/lane/frame/bytes/pieces.h>

#include <cstring>

namespace suture::frame {

bool Pieces::add(const Header& header, std::span<const std::byte> piece) {
  if (gathered_ == 0) whole_ = header.call;
  if (piece.size() != kMostPayload || header.call != whole_ || whole_ > limit_) return false;
  if (gathered_ + piece.size() >= whole_) return false;  // its end comes in another frame
  append(piece);
  return true;
}

bool Pieces::complete(std::span<std::byte>& payload) {
  if (gathered_ == 0) return true;
  if (gathered_ + payload.size() != whole_) return false;
  payload = {append(payload), whole_};
  gathered_ = 0;
  return true;
}

/// Returns where all of them begin.
std::byte* Pieces::append(std::span<const std::byte> bytes) {
  const std::size_t words = wordBytes(gathered_ + bytes.size()) / sizeof(std::uint64_t);
  if (storage_.size() < words) storage_.resize(words);
  auto* const begin = reinterpret_cast<std::byte*>(storage_.data());
  std::memcpy(begin + gathered_, bytes.data(), bytes.size());
  gathered_ += bytes.size();
  return begin;
}

}  // namespace suture::frame
