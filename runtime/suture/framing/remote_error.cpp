#include <suture/framing/remote_error.h>
#include <suture/loop/failure.h>

#include <charconv>
#include <string>
#include <string_view>

namespace suture::framing {
namespace {

constexpr std::string_view kPrefix = "suture error ";

/// Returns the number of the error that a text tells; 0 if it tells none that is a number.
unsigned numberIn(const std::string& text) {
  unsigned number = 0;
  if (!text.starts_with(kPrefix)) return number;
  std::from_chars(text.data() + kPrefix.size(), text.data() + text.size(), number);
  return number;
}

}  // namespace

kj::Exception remoteError(Errc error, const FieldPath& invalid) {
  const auto number = std::to_string(static_cast<unsigned>(error));
  std::string text = std::string(kPrefix) + number + ": " + toString(error);
  if (!invalid.empty()) text.append(": ").append(invalid.text());
  return loop::failure(kj::Exception::Type::FAILED, text);
}

Errc errcOf(const kj::Exception& exception) {
  if (exception.getType() == kj::Exception::Type::DISCONNECTED) return Errc::OutcomeUnknown;
  if (exception.getType() == kj::Exception::Type::UNIMPLEMENTED) return Errc::NotImplemented;
  const Errc told = toldErrc(numberIn(loop::describe(exception)));
  return told == Errc{} ? Errc::OutcomeUnknown : told;
}

std::string reasonOf(const kj::Exception& exception) {
  const Errc error = errcOf(exception);
  const std::string text = loop::describe(exception);
  const bool told = exception.getType() == kj::Exception::Type::FAILED;
  const bool known = numberIn(text) == static_cast<unsigned>(error);
  // The peer says more of what is invalid, and of an error that only it knows.
  if (!told || (known && error != Errc::Invalid)) return toString(error);
  const std::size_t number = text.starts_with(kPrefix) ? text.find(": ") : std::string::npos;
  return number == std::string::npos ? text : text.substr(number + 2);
}

}  // namespace suture::framing
