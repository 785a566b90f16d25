#include <suture/transport/rpc/failure.h>
#include <suture/transport/rpc/remote_error.h>

#include <charconv>
#include <string>
#include <string_view>

namespace suture::rpc {
namespace {

constexpr std::string_view kPrefix = "suture error ";

}  // namespace

kj::Exception remoteError(Errc error) {
  const auto number = std::to_string(static_cast<unsigned>(error));
  return failure(kj::Exception::Type::FAILED,
                 std::string(kPrefix) + number + ": " + toString(error));
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
  const std::string text = describe(exception);
  return error == Errc::Invalid && !text.starts_with(kPrefix) ? text : toString(error);
}

}  // namespace suture::rpc
