#include <suture/loop/failure.h>

#include <string_view>

namespace suture::loop {
namespace {

constexpr std::string_view kRemote = "remote exception: ";  // the library writes it

}  // namespace

kj::Exception failure(kj::Exception::Type type, const std::string& text) {
  return kj::Exception(type, "suture", 0, kj::heapString(text.data(), text.size()));
}

bool isRemote(const kj::Exception& exception) {
  return std::string_view(exception.getDescription().cStr()).starts_with(kRemote);
}

std::string describe(const kj::Exception& exception) {
  std::string_view text = exception.getDescription().cStr();
  for (std::string_view prefix : {kRemote, std::string_view("std::exception: ")}) {
    if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
  }
  return std::string(text);
}

}  // namespace suture::loop
