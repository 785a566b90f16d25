#pragma once
// There are two components. All traffic goes from the thread of one task to that of the other.

#include <suture/component/task/event_task.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>

#include "echo.suture.h"
#include "harness/sink.h"

namespace peers {

/// It is the server's.
class Responder final : public suture::EventTask, public Echo, public BlobEcho {
 public:
  explicit Responder(const Sink& sink) : sink_(sink) {
    feed_.makeOptional();
    feed_.on().pose([this](const Pose& pose) { sink_(pose); });
  }
  ~Responder() override { stop(); }

  void bounce(const Pose& pose) override { echo_.emit().bounced(pose); }
  Pose ping(const Pose& pose) override { return pose; }
  void push(const Pose& pose) override { sink_(pose); }
  void bounce(const Blob& blob) override { blobs_.emit().bounced(blob); }
  void run() override {}

 private:
  const Sink sink_;
  suture::Provided<Echo> echo_{*this, "Echo", *this};
  suture::Provided<BlobEcho> blobs_{*this, "BlobEcho", *this};
  suture::Required<Feed> feed_{*this, "Feed"};
};

/// It is the client's: the measurement runs in its thread.
class Requester final : public suture::EventTask, public Feed {
 public:
  Requester() : EventTask({.longestSleep = std::chrono::milliseconds(5)}) {
    echo.makeOptional();
    blobs.makeOptional();
  }
  ~Requester() override { stop(); }

  /// Runs `work` in the task's thread, and waits for its end. Another thread calls it, once, after
  /// start().
  void runInTask(const std::function<void()>& work) {
    work_.store(&work);
    ended_.get_future().wait();
  }

  void run() override {
    if (const auto* const work = work_.exchange(nullptr); work != nullptr) {
      (*work)();
      ended_.set_value();
    }
  }

  suture::Required<Echo> echo{*this, "Echo"};
  suture::Required<BlobEcho> blobs{*this, "BlobEcho"};
  suture::Provided<Feed> feed{*this, "Feed", *this};

 private:
  std::atomic<const std::function<void()>*> work_{nullptr};
  std::promise<void> ended_;
};

}  // namespace peers
