#include <fcntl.h>
#include <suture/deploy/report_descriptor.h>
#include <unistd.h>

#include <charconv>
#include <system_error>

namespace suture {

std::optional<int> descriptorIn(const std::string& text) {
  if (text == "-") return STDOUT_FILENO;
  int descriptor = -1;
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, descriptor);
  if (error != std::errc{} || after != end || descriptor < 0) return std::nullopt;
  return descriptor;
}

std::string whyNotWritable(const std::string& text) {
  const std::optional<int> descriptor = descriptorIn(text);
  if (!descriptor) return "it is no descriptor. Give - or a number";
  const std::string name = "descriptor " + std::to_string(*descriptor);
  const int flags = fcntl(*descriptor, F_GETFL);
  if (flags < 0) {
    return name + " is not open. Open it where this is started, as `" +
           std::to_string(*descriptor) + ">reports`";
  }
  if ((flags & O_ACCMODE) == O_RDONLY) {
    return name + " is not open for writing. Give one that is, or - for standard output";
  }
  return "";
}

}  // namespace suture
