#include <suture/base/plain.h>
#include <suture/rt/standard_error.h>
#include <suture/session/telling.h>

#include <utility>

namespace suture {
namespace {

/// Says what brings a connection back that was lost for that reason. A process that ends stops its
/// components first, so the text for a stopped one is true of it as well.
const char* remedyFor(const std::string& reason) {
  if (reason.starts_with("closed")) {
    return "Start that process again if it has ended; it is connected anew when it is there";
  }
  if (reason.starts_with("ended")) {
    return "While that process goes on, restart either process, or call disconnect() and "
           "connect(); if it has ended, start it again";
  }
  return "It is connected anew when that process goes on";
}

}  // namespace

Telling::Telling(const std::string& process)
    : process_(process),
      taker_(std::make_shared<const Taker>([this](const std::string& line) { print(line); })) {}

void Telling::print(const std::string& line) const {
  rt::printUnlessFull(process_ + ": " + plain(line));
}

void Telling::giveTo(Taker taker) {
  const std::lock_guard lock(mutex_);
  taker_ = std::make_shared<const Taker>(std::move(taker));
}

void Telling::tell(const std::string& line) const {
  std::unique_lock lock(mutex_);
  const std::shared_ptr<const Taker> taker = taker_;
  lock.unlock();
  if (!*taker) return;
  try {
    (*taker)(line);
  } catch (...) {
    print(line);
  }
}

std::string lossText(std::string why) {
  if (why.ends_with('.')) why.pop_back();  // what TLS says is a whole sentence
  return "is lost, " + why + ". " + remedyFor(why);
}

}  // namespace suture
