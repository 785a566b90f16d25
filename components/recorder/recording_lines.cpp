#include "recorder/recording_lines.h"

#include <suture/base/errors.h>

#include <nlohmann/json.hpp>

namespace robots {

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
    take(nlohmann::json::parse(unfinished_));
  } catch (const nlohmann::json::exception& error) {
    throw suture::SetupError(
        "reading the recording " + file_.string() + ":" + std::to_string(lines_), error.what(),
        "The recorder may have been killed while it wrote; record anew");
  }
  unfinished_.clear();
}

}  // namespace robots
