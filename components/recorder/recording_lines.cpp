#include "recorder/recording_lines.h"

#include <suture/base/errors.h>

#include <nlohmann/json.hpp>
#include <ostream>

namespace robots {
namespace {

constexpr const char* kLost = "lost";

}  // namespace

void writeLost(std::ostream& out, std::uint64_t count) {
  out << nlohmann::json{{kLost, count}} << '\n';
}

void RecordingLines::next(const Take& take) {
  if (!in_.is_open()) in_.open(file_);
  in_.clear();  // more lines may have come behind the end
  std::string text;
  while (std::getline(in_, text)) {
    unfinished_ += text;
    if (in_.eof()) break;
    parse(take);
  }
}

void RecordingLines::rest(const Take& take) {
  next(take);
  if (!in_.is_open()) {
    throw suture::SetupError("reading the recording " + file_.string(), "it cannot be opened",
                             "Check that the recorder ran");
  }
  if (!unfinished_.empty()) parse(take);
}

void RecordingLines::parse(const Take& take) {
  ++lines_;
  try {
    const auto line = nlohmann::json::parse(unfinished_);
    if (line.contains(kLost)) {
      lost_ = line.at(kLost).get<std::uint64_t>();
    } else {
      take(line);
    }
  } catch (const nlohmann::json::exception& error) {
    throw suture::SetupError(
        "reading the recording " + file_.string() + ":" + std::to_string(lines_), error.what(),
        "The recorder may have been killed while it wrote; record anew");
  }
  unfinished_.clear();
}

}  // namespace robots
