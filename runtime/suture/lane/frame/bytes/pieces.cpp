#include <suture/lane/frame/bytes/pieces.h>

#include <cstring>

namespace suture::frame {

bool Pieces::add(const Header& header, std::span<const std::byte> piece, Surplus& surplus) {
  if (gathered_ == 0) {
    whole_ = header.call;
    kind_ = header.number;
  }
  if (header.call != whole_ || header.number != kind_ || whole_ > limit_) return false;
  if (piece.size() != kMostPayload) return false;
  if (gathered_ + piece.size() >= whole_) return false;  // its end comes in another frame
  return append(piece, surplus);
}

bool Pieces::complete(const Header& header, std::span<std::byte>& payload, Surplus& surplus) {
  if (gathered_ == 0) return true;
  if (static_cast<std::uint16_t>(header.kind) != kind_) return false;
  if (gathered_ + payload.size() != whole_ || !append(payload, surplus)) return false;
  payload = gathered();
  gathered_ = 0;
  return true;
}

void Pieces::taken(Surplus& surplus) {
  if (gathered_ != 0 || this->surplus() == 0) return;
  const std::size_t beyond = this->surplus();
  storage_.resize(own_ / sizeof(std::uint64_t));
  storage_.shrink_to_fit();
  surplus.giveBack(beyond);
}

bool Pieces::append(std::span<const std::byte> more, Surplus& surplus) {
  const std::size_t words = wordBytes(gathered_ + more.size()) / sizeof(std::uint64_t);
  if (storage_.size() < words) {
    if (!surplus.take(surplusOf(words) - surplusOf(storage_.size()))) return false;
    storage_.resize(words);
  }
  std::memcpy(bytes() + gathered_, more.data(), more.size());
  gathered_ += more.size();
  return true;
}

}  // namespace suture::frame
