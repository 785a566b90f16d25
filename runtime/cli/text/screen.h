#pragma once
// This shows values to people.

#include <suture/base/errors.h>
#include <suture/base/plain.h>
#include <suture/base/time.h>
#include "cli/values/json.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace suture::cli {

/// Returns a value on as many lines as it needs, each with `indent` spaces before it; ends with a
/// line break. Short ones stay on one line; a pose is shown as a matrix.
std::string valueText(const Json& value, unsigned indent = 0);
/// Returns the same on one line, without indent or line break.
std::string valueLine(const Json& value);

/// Returns rows of cells, each column as wide as its widest cell, the last one as it is.
std::string columns(const std::vector<std::vector<std::string>>& rows, unsigned indent = 0);

/// Returns "3.1 ms".
std::string milliseconds(double value);
double inMilliseconds(Duration duration);
/// Returns ", known to 40 us": how wrong a time may be for another clock, rounded up; "" for
/// zero.
std::string knownTo(Duration error);

/// Says that the reader of standard output has gone, so that there is nothing more to do.
class ReaderGone : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// These write to standard output at once: a text for people; JSON for programs, laid out or on one
/// line. Each throws ReaderGone, or SetupError if the text is lost otherwise.
void print(const std::string& text);
void printJson(const Json& json);
void printLine(const Json& json);

}  // namespace suture::cli
