#include "recorder/recording_writer.h"

#include <suture/base/errors.h>

#include <chrono>

namespace robots {
namespace {

using namespace std::chrono_literals;

// Four seconds of one arm at 1 kHz.
constexpr std::size_t kRecords = 4096;

}  // namespace

RecordingWriter::RecordingWriter(const std::filesystem::path& file)
    : PeriodicTask({.period = 50ms}), out_(file, std::ios::trunc), ring_(kRecords) {
  if (!out_) {
    throw suture::SetupError("recording to " + file.string(), "the file cannot be written",
                             "name a file in an existing folder that you may write to");
  }
  start();
}

RecordingWriter::~RecordingWriter() {
  stop();
  drain();
}

bool RecordingWriter::push(const Record& record) {
  const std::size_t pushed = pushed_.load(std::memory_order_relaxed);
  if (pushed - written_.load(std::memory_order_acquire) == ring_.size()) return false;
  ring_[pushed % ring_.size()] = record;
  pushed_.store(pushed + 1, std::memory_order_release);
  return true;
}

void RecordingWriter::drain() {
  std::size_t written = written_.load(std::memory_order_relaxed);
  while (written != pushed_.load(std::memory_order_acquire)) {
    write(out_, ring_[written % ring_.size()]);
    written_.store(++written, std::memory_order_release);
  }
  out_.flush();
}

}  // namespace robots
