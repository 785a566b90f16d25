#include <suture/base/errors.h>
#include <suture/transport/rpc/control_thread.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <future>

namespace suture::rpc {
namespace {

kj::AutoCloseFd makeEventDescriptor() {
  const int descriptor = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (descriptor < 0) {
    throw SetupError("start the control thread", std::string("eventfd: ") + std::strerror(errno),
                     "Raise the limit of open files (ulimit -n).");
  }
  return kj::AutoCloseFd(descriptor);
}

}  // namespace

ControlThread::Loop::Loop(int eventDescriptor)
    : io(kj::setupAsyncIo()),
      rung(io.unixEventPort, eventDescriptor, kj::UnixEventPort::FdObserver::OBSERVE_READ),
      tasks(*this) {}

void ControlThread::Loop::taskFailed(kj::Exception&& exception) {
  std::fprintf(stderr, "suture: a background task failed: %s\n", describe(exception).c_str());
}

ControlThread::ControlThread()
    : eventDescriptor_(makeEventDescriptor()), doorbell_(eventDescriptor_.get()) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::promise<void> started;
  thread_ = std::thread([this, &started] {
    Loop loop(eventDescriptor_);
    loop_ = &loop;
    started.set_value();
    main();
  });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  started.get_future().wait();
}

ControlThread::~ControlThread() noexcept {
  post([this] { loop_->stop->fulfill(); });
  thread_.join();
}

void ControlThread::main() {
  auto stop = kj::newPromiseAndFulfiller<void>();
  loop_->stop = kj::mv(stop.fulfiller);
  auto attending = attend().eagerlyEvaluate(nullptr);
  stop.promise.exclusiveJoin(kj::mv(attending)).wait(loop_->io.waitScope);
  std::lock_guard lock(mutex_);
  posted_.clear();
}

void ControlThread::post(kj::Function<void()> work) {
  // Rung under the lock, so that the destructor's own post comes after every other one has let go.
  std::lock_guard lock(mutex_);
  posted_.push_back(kj::mv(work));
  anyPosted_.store(true, std::memory_order_release);
  doorbell_.ring();
}

void ControlThread::requireOther() const {
  if (isCurrent()) throw std::logic_error("ControlThread::run() would wait for itself");
}

void ControlThread::add(Pump& pump) { pumps_.push_back(&pump); }

void ControlThread::remove(Pump& pump) {
  // A hole, not an erase: the caller may be in the middle of runPumps().
  std::replace(pumps_.begin(), pumps_.end(), &pump, static_cast<Pump*>(nullptr));
}

// The edge of the eventfd is enough; its counter is never read. An edge that fires while no promise
// waits is dropped, so the promise is made before looking at what has been rung for.
kj::Promise<void> ControlThread::attend() {
  auto rung = loop_->rung.whenBecomesReadable();
  do {
    doorbell_.standUp();
    runPosted();
    runPumps();
  } while (!doorbell_.lieDown());
  return rung.then([this] { return attend(); });
}

void ControlThread::runPosted() {
  if (!anyPosted_.load(std::memory_order_acquire)) return;
  std::vector<kj::Function<void()>> work;
  {
    std::lock_guard lock(mutex_);
    work.swap(posted_);
    anyPosted_.store(false, std::memory_order_relaxed);
  }
  for (auto& item : work) {
    KJ_IF_MAYBE (exception, kj::runCatchingExceptions([&] { item(); })) {
      loop_->taskFailed(kj::mv(*exception));
    }
  }
}

void ControlThread::runPumps() {
  for (std::size_t i = 0; i < pumps_.size(); ++i) {
    if (pumps_[i] != nullptr) pumps_[i]->pump();
  }
  std::erase(pumps_, nullptr);
}

}  // namespace suture::rpc
