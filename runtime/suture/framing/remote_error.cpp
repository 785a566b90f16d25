#include <suture/framing/remote_error.h>
#include <suture/loop/failure.h>

#include <charconv>
#include <string>
#include <string_view>

namespace suture::rpc {
namespace {

constexpr std::string_view kPrefix = "suture error ";

}  // namespace

kj::Exception remoteError(Errc error, const FieldPath& invalid) {
  const auto number = std::to_string(static_cast<unsigned>(error));
  std::string text = std::string(kPrefix) + number + ": " + toString(error);
  if (!invalid.empty()) text.append(": ").append(invalid.text());
  return failure(kj::Exception::Type::FAILED, text);
}

Errc errcOf(const kj::Exception& exception) {
  if (exception.getType() == kj::Exception::Type::DISCONNECTED) return Errc::OutcomeUnknown;
  if (exception.getType() == kj::Exception::Type::UNIMPLEMENTED) return Errc::NotImplemented;
  const std::string text = describe(exception);
  unsigned number = 0;
  if (text.starts_with(kPrefix)) {
    std::from_chars(text.data() + kPrefix.size(), text.data() + text.size(), number);
  }
  const bool known = number >= static_cast<unsigned>(Errc::NotConnected) &&
                     number <= static_cast<unsigned>(Errc::NotPermitted);
  return known ? static_cast<Errc>(number) : Errc::Invalid;
}

std::string reasonOf(const kj::Exception& exception) {
  const Errc error = errcOf(exception);
  if (error != Errc::Invalid) return toString(error);
  const std::string text = describe(exception);
  const std::size_t number = text.starts_with(kPrefix) ? text.find(": ") : std::string::npos;
  return number == std::string::npos ? text : text.substr(number + 2);
}

}  // namespace suture::rpc
