#include <suture/loop/failure.h>

#include <string_view>

namespace suture::rpc {

kj::Exception failure(kj::Exception::Type type, const std::string& text) {
  return kj::Exception(type, "suture", 0, kj::heapString(text.data(), text.size()));
}

std::string describe(const kj::Exception& exception) {
  std::string_view text = exception.getDescription().cStr();
  for (std::string_view prefix : {"remote exception: ", "std::exception: "}) {
    if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
  }
  return std::string(text);
}

}  // namespace suture::rpc
