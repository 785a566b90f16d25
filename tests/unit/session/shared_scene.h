#pragma once
// These tests have what the sessions of a serving process share, without a socket.

#include <gtest/gtest.h>
#include <suture/session/provider/shared/shared_by_sessions.h>

#include <memory>
#include <utility>

#include "support/patience.h"

namespace suture {

class SharedScene : public testing::Test {
 protected:
  /// Runs `work` on the control thread.
  template <class Work>
  auto there(Work work) {
    return control_.run(kPatience, std::move(work));
  }

  void SetUp() override {
    there([this] {
      shared_ = std::make_unique<SharedBySessions>(
          ServingProcess{control_, lanes_, directory_, threads_, 1, Policy()});
    });
  }
  void TearDown() override {
    there([this] { shared_.reset(); });
  }

  Directory directory_{"robot"};
  Lanes lanes_;
  ServiceThreads threads_;
  loop::ControlThread control_;
  std::unique_ptr<SharedBySessions> shared_;
};

}  // namespace suture
