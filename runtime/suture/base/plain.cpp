#include <suture/base/plain.h>

namespace suture {

std::string plain(const std::string& text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0u;
    const bool secondControl = byte == 0xc2 && next >= 0x80 && next < 0xa0;  // U+0080 to U+009F
    if ((byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f || secondControl) {
      shown += '?';
      i += secondControl ? 1 : 0;
    } else {
      shown += text[i];
    }
  }
  return shown;
}

void assignCut(std::string& out, std::string_view text, std::size_t capacity) {
  constexpr std::string_view kDots = "...";
  if (text.size() <= capacity) {
    out = text;
    return;
  }
  std::size_t length = capacity - kDots.size();
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  out = text.substr(0, length);
  out += kDots;
}

std::string quotedForShell(std::string_view text) {
  std::string quoted = "\"";
  for (const char one : text) {
    if (std::string_view("\\\"$`").find(one) != std::string_view::npos) quoted += '\\';
    quoted += one;
  }
  return quoted + "\"";
}

std::string explained(std::string_view message) {
  // The page knows the message without its place in a file.
  constexpr std::string_view kPlace = ": error: ";
  std::string_view first = message.substr(0, message.find('\n'));
  if (const auto place = first.find(kPlace); place != std::string_view::npos) {
    first.remove_prefix(place + kPlace.size());
  }
  return std::string(message) + "\n`suture why " + quotedForShell(plain(std::string(first))) +
         "` tells more";
}

}  // namespace suture
