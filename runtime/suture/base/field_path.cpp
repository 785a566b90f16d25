#include <suture/base/field_path.h>

#include <algorithm>
#include <charconv>

namespace suture {
namespace {

constexpr std::string_view kCut = "...";

/// Returns the text that joins a part to the part within it.
std::string_view jointBefore(std::string_view inner) {
  return inner.empty() || inner.starts_with('[') ? "" : ".";
}

template <class Number>
class Digits {
 public:
  explicit Digits(Number number)
      : end_(std::to_chars(digits_.data(), digits_.data() + digits_.size(), number).ptr) {}
  std::string_view text() const { return {digits_.data(), end_}; }

 private:
  std::array<char, 24> digits_;
  const char* end_;
};

}  // namespace

void FieldPath::enterMember(std::string_view name) { put({name, jointBefore(text())}); }

void FieldPath::enterElement(std::uint64_t index) {
  put({"[", Digits(index).text(), "]", jointBefore(text())});
}

void FieldPath::enterKey(std::int64_t key) {
  put({"[", Digits(key).text(), "]", jointBefore(text())});
}

// Masks what is not plain text: a peer may have chosen the key to send control codes to a terminal.
void FieldPath::enterKey(std::string_view key) {
  constexpr std::size_t kLongest = 32;
  std::array<char, kLongest> shown;
  const auto end =
      std::transform(key.begin(), key.begin() + std::min(key.size(), kLongest), shown.begin(),
                     [](char c) { return c < ' ' || c > '~' ? '?' : c; });
  put({"[\"", {shown.begin(), end}, key.size() > kLongest ? "...\"]" : "\"]", jointBefore(text())});
}

bool FieldPath::beginsWith(std::string_view member) const {
  const std::string_view whole = text();
  return whole.starts_with(member) &&
         (whole.size() == member.size() || whole.substr(member.size()).find_first_of(".[") == 0);
}

void FieldPath::put(std::initializer_list<std::string_view> parts) {
  if (cut_) return;
  std::size_t size = 0;
  for (const std::string_view part : parts) size += part.size();
  cut_ = size + kCut.size() > begin_;
  if (cut_) return putOne(kCut);
  for (const std::string_view* part = parts.end(); part != parts.begin();) putOne(*--part);
}

void FieldPath::putOne(std::string_view part) {
  begin_ = static_cast<std::uint8_t>(begin_ - part.size());
  std::copy(part.begin(), part.end(), text_.begin() + begin_);
}

bool refusedAt(FieldPath* path, const char* member) {
  if (path != nullptr) path->enterMember(member);
  return false;
}

}  // namespace suture
