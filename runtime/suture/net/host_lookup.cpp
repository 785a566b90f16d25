#include <netdb.h>
#include <sched.h>
#include <suture/loop/deadline.h>
#include <suture/loop/event_descriptor.h>
#include <suture/net/host_lookup.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>

namespace suture::net {
namespace {

// Bounds the wait when we know where the host was: it need not take long to hear whether it has
// moved.
constexpr Duration kToHearAgain = std::chrono::milliseconds(250);

std::string asked(const Address& address) { return "look up the host '" + address.host + "'"; }

constexpr const char* kRemedy =
    "Correct the name, make it known to this machine, or use the host's number.";

std::string errorText(int error) {
  return error == EAI_SYSTEM ? std::strerror(errno) : gai_strerror(error);
}

Address at(const Address& address, const addrinfo& place) {
  Address found = address;
  char host[NI_MAXHOST] = "";
  getnameinfo(place.ai_addr, place.ai_addrlen, host, sizeof host, nullptr, 0, NI_NUMERICHOST);
  found.host = host;
  return found;
}

/// Makes the calling thread an ordinary one, whatever it has inherited from the control thread: no
/// signal interrupts it, and it has no real-time priority, nor a processor that it would share with
/// what has one, whatever a library does to find a name.
void becomeOrdinaryThread() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  const sched_param none{};
  sched_setscheduler(0, SCHED_OTHER, &none);
  cpu_set_t processes;  // as its first thread has them
  if (sched_getaffinity(getpid(), sizeof processes, &processes) == 0) {
    sched_setaffinity(0, sizeof processes, &processes);
  }
}

}  // namespace

std::vector<Address> lookUp(const Address& address) {
  if (address.isNumeric()) return {address};
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_ADDRCONFIG;
  addrinfo* all = nullptr;
  const int error = getaddrinfo(address.host.c_str(), nullptr, &hints, &all);
  if (error != 0) throw SetupError(asked(address), errorText(error), kRemedy);
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owned(all, &freeaddrinfo);
  std::vector<Address> places;
  for (const addrinfo* one = all; one != nullptr; one = one->ai_next) {
    places.push_back(at(address, *one));
  }
  // fe80::1%eth0 means something only on this machine, and an Address cannot hold it.
  std::erase_if(places, [](const Address& place) { return !place.isNumeric(); });
  if (places.empty()) throw SetupError(asked(address), "it has link-local numbers only", kRemedy);
  return places;
}

/// This is a question to the name service. It may outlive the HostLookup that asked.
struct HostLookup::Question {
  explicit Question(const Address& of) : address(of) {}

  void ask() {
    try {
      places = lookUp(address);
    } catch (const SetupError& error) {
      why = error.what();
    }
    answered.ring();
  }

  const Address address;
  const loop::EventDescriptor answered{asked(address)};
  std::vector<Address> places;
  std::string why;
};

HostLookup::HostLookup(loop::EventPort& port, const Address& address)
    : port_(port), address_(address) {}

kj::Promise<std::vector<Address>> HostLookup::places(Duration limit) {
  if (address_.isNumeric()) return std::vector<Address>{address_};
  if (!std::exchange(asking_, true)) {
    answer_ = kj::evalNow([this] { return ask(); })
                  .catch_([this](kj::Exception&& failure) {
                    asking_ = false;
                    why_ = loop::describe(failure);
                  })
                  .fork();
  }
  auto answered = answer_.addBranch().then([this] { return known(why_); });
  const Duration longest = known_.empty() ? limit : std::min(limit, kToHearAgain);
  return loop::unlessLate(port_.getTimer(), longest, kj::mv(answered), [this] {
    return known(asked(address_) + ": the name service does not answer. " + kRemedy);
  });
}

kj::Promise<std::vector<Address>> HostLookup::known(const std::string& why) const {
  if (known_.empty()) return loop::disconnected(why);
  return known_;
}

kj::Promise<void> HostLookup::ask() {
  std::shared_ptr<Question> question;
  try {
    question = std::make_shared<Question>(address_);
  } catch (const SetupError& error) {
    return loop::disconnected(error.what());
  }
  auto observer = kj::heap<loop::EventPort::FdObserver>(port_, question->answered.get(),
                                                        loop::EventPort::FdObserver::OBSERVE_READ);
  auto answered = observer->whenBecomesReadable();
  try {
    std::thread([question] {
      becomeOrdinaryThread();
      question->ask();
    }).detach();
  } catch (const std::system_error& error) {
    return loop::disconnected(asked(address_) + ": " + error.what() +
                              ". Let this process have threads.");
  }
  return answered.attach(kj::mv(observer)).then([this, question] {
    question->answered.take();
    asking_ = false;
    why_ = question->why;
    if (!question->places.empty()) known_ = question->places;
  });
}

}  // namespace suture::net
