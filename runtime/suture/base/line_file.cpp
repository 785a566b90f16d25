#include <fcntl.h>
#include <poll.h>
#include <suture/base/errors.h>
#include <suture/base/line_file.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

namespace suture {
namespace {

constexpr mode_t kRights = 0666;  // the user's mask takes some away

bool mayBeWritten(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) {
    return !std::filesystem::is_directory(file, ignored) && access(file.c_str(), W_OK) == 0;
  }
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  return file.has_filename() && std::filesystem::is_directory(folder, ignored) &&
         access(folder.c_str(), W_OK | X_OK) == 0;
}

SetupError cannotBeWritten(const std::filesystem::path& file) {
  return SetupError("recording to " + file.string(), "the file cannot be written",
                    "Name a file in an existing folder that you may write to");
}

SetupError notTaken(const std::string& asked, int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return SetupError(asked, "the file system did not take all of it", "Make room there");
    case EPIPE:
      return SetupError(asked, "the reader of this pipe has gone",
                        "Start it anew with a reader that reads on");
    default:
      return SetupError(asked, std::string("not all of it was taken: ") + std::strerror(error),
                        "Look at the disk that it is on, or name another file");
  }
}

/// Waits for no reader of a pipe, which may never come, here or later.
int openWithoutWaiting(const std::filesystem::path& file) {
  const int descriptor =
      open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, kRights);
  if (descriptor >= 0) return descriptor;
  std::error_code ignored;
  if (errno != ENXIO || !std::filesystem::is_fifo(file, ignored)) throw cannotBeWritten(file);
  throw SetupError("recording to " + file.string(), "it is a pipe that nobody reads",
                   "Start its reader first, or name a file");
}

/// Returns false if what reads has taken nothing for 1 s.
bool awaitsMore(int descriptor) {
  constexpr int kPatience = 1000;  // ms
  pollfd asked{.fd = descriptor, .events = POLLOUT, .revents = 0};
  return poll(&asked, 1, kPatience) != 0;
}

/// While one exists, no SIGPIPE comes to this thread. It would end the process as soon as the
/// reader of a pipe is gone, which write() tells anyhow.
class NoPipeSignal {
 public:
  NoPipeSignal() : pending_(isPending()) {
    sigemptyset(&signal_);
    sigaddset(&signal_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &signal_, &before_);
  }
  ~NoPipeSignal() {
    int signal = 0;
    if (!pending_ && isPending()) sigwait(&signal_, &signal);  // returns at once
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;

 private:
  static bool isPending() {
    sigset_t pending;
    return sigpending(&pending) == 0 && sigismember(&pending, SIGPIPE) == 1;
  }

  sigset_t signal_{}, before_{};
  const bool pending_;  // before, so it is not of this write()
};

}  // namespace

LineFile::LineFile(std::filesystem::path file) : file_(std::move(file)) {
  if (!mayBeWritten(file_)) throw cannotBeWritten(file_);
}

LineFile::~LineFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

// A file system that knows no locks is used without one.
void LineFile::take() {
  if (descriptor_ >= 0 || problem_ == Problem::NotRead) return;
  descriptor_ = openWithoutWaiting(file_);
  struct stat status {};
  regular_ = fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  if (!regular_ || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(std::exchange(descriptor_, -1));
  throw SetupError("recording to " + file_.string(), "another recording is being written to it",
                   "End the process that writes it, or name another file");
}

bool LineFile::append(std::string_view lines) {
  if (descriptor_ < 0) return false;
  if (!replaced_) replaced_ = !regular_ || ftruncate(descriptor_, 0) == 0;
  struct stat before {};
  problem_ = Problem::NotTaken;
  error_ = errno;
  if (!replaced_ || fstat(descriptor_, &before) != 0) return false;
  if (regular_ && before.st_nlink == 0) {
    problem_ = Problem::Removed;
    return false;
  }
  if (writeAll(lines)) return true;
  // The lines that come once there is room must not follow a torn one. A device keeps nothing.
  if (regular_) std::ignore = ftruncate(descriptor_, before.st_size);
  return false;
}

SetupError LineFile::refusal() const {
  const std::string asked = "recording to " + file_.string();
  switch (problem_) {
    case Problem::Removed:
      return SetupError(asked, "the file was removed or replaced while it was written",
                        "Leave it there until the recording ends");
    case Problem::NotRead:
      return SetupError(asked, "the reader of this pipe has taken nothing for 1 s",
                        "Start it anew with a reader that reads on");
    case Problem::NotTaken: break;
  }
  return notTaken(asked, error_);
}

// The reader has a torn line now, behind which nothing may come.
void LineFile::giveUp() {
  problem_ = Problem::NotRead;
  close(std::exchange(descriptor_, -1));
}

bool LineFile::writeAll(std::string_view lines) {
  const NoPipeSignal guard;
  while (!lines.empty()) {
    const ssize_t taken = write(descriptor_, lines.data(), lines.size());
    if (taken < 0 && errno == EINTR) continue;
    if (taken < 0 && errno == EAGAIN) {
      if (awaitsMore(descriptor_)) continue;
      giveUp();
    }
    if (taken <= 0) {
      error_ = errno;
      return false;
    }
    lines.remove_prefix(static_cast<std::size_t>(taken));
  }
  return true;
}

}  // namespace suture
