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

}  // namespace suture
