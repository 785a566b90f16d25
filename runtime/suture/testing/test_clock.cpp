#include <suture/base/errors.h>
#include <suture/base/virtual_time.h>
#include <suture/testing/one_processor.h>
#include <suture/testing/scheduler.h>
#include <suture/testing/test_clock.h>

#include <utility>

namespace suture {

using testing_detail::Scheduler;

TestClock::TestClock(TestClockOptions options)
    : processor_(options.threads == Threads::OneAtATime
                     ? std::make_unique<testing_detail::OneProcessor>()
                     : nullptr),
      scheduler_(std::make_unique<Scheduler>(std::move(options))) {
  VirtualTime* none = nullptr;
  if (!detail::virtualTime.compare_exchange_strong(none, scheduler_.get())) {
    throw SetupError("making a TestClock", "this process has one", "Destroy that first");
  }
  scheduler_->adoptTest();
}

TestClock::~TestClock() {
  scheduler_->finish();
  detail::virtualTime.store(nullptr);
}

void TestClock::advance(Duration duration) { scheduler_->spend(duration); }

void TestClock::spend(Duration duration) {
  VirtualTime* const time = virtualTime();
  if (time != nullptr) time->spend(duration);
}

void TestClock::suspend(Duration duration) { scheduler_->suspend(duration); }

const Trace& TestClock::trace() const {
  if (scheduler_->isTraced()) return scheduler_->trace();
  throw SetupError("reading the trace of a TestClock", "it keeps none",
                   "Make it with TestClockOptions::traced");
}

TestClock::Hold::Hold(TestClock& clock) : clock_(clock) { clock_.scheduler_->hold(); }

TestClock::Hold::~Hold() { clock_.scheduler_->release(); }

TestClock::Process::Process(TestClock& clock)
    : scheduler_(*clock.scheduler_), number_(scheduler_.addProcess()) {}

void TestClock::Process::run(const std::function<void()>& work) {
  const struct Inside {
    explicit Inside(std::size_t process) { Scheduler::enterProcess(process); }
    ~Inside() { Scheduler::enterProcess(0); }  // also when `work` throws
  } inside(number_);
  work();
}

void TestClock::Process::freeze() { scheduler_.freeze(number_); }

void TestClock::Process::thaw() { scheduler_.thaw(number_); }

}  // namespace suture
