#pragma once
// This is the guide of a knot between four arms that a test places, with eyes that it covers.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>
#include <suture/standard/messages.suture.h>

#include <array>
#include <chrono>
#include <string>

#include "guidance/knot_guide.h"
#include "integration/teleoperation/scene/scripted_arm.h"
#include "integration/teleoperation/scene/test_console.h"
#include "registration/registration_table.h"
#include "support/pass.h"
#include "support/stepped.h"

namespace robots::test {

using namespace std::chrono_literals;
using Eigen::Vector3d;
using suture::pass;

/// Sees the knot where it hung at the beginning, unless it is covered. An image takes 30 ms.
struct Eyes final : suture::Device, KnotVision {
  Eyes() { seen_.knot.z() = -0.05; }
  const KnotSighting& sighting() const override {
    seen_.valid = !covered;
    if (!covered) seen_.stamp = suture::now() - 30ms;
    return seen_;
  }

  bool covered = false;
  mutable KnotSighting seen_;
  suture::Provided<KnotVision> vision{*this, "Vision", *this};
};

/// Counts what the guide says of its state, and keeps the last of it.
struct Listener final : suture::Device {
  Listener() {
    guidance.on().guidance_state([this](const GuidanceState& news) {
      ++heard;
      state = news;
    });
  }
  suture::Required<Guidance> guidance{*this, "Guidance"};
  unsigned heard = 0;
  GuidanceState state = GuidanceState::Disabled;
};

inline Eigen::Isometry3d at(const Vector3d& place) {
  return Eigen::Isometry3d(Eigen::Translation3d(place));
}

/// Keeps what the guide complained of last.
struct Complaints final : suture::Device {
  Complaints() {
    messages.on().error([this](const suture::Message& message) { error = message.text; });
  }
  suture::Required<suture::Messages> messages{*this, "Messages"};
  std::string error;
};

class Guide : public testing::Test {
 protected:
  explicit Guide(const SceneFrames& frames = {}, const GuideParameters& parameters = kPatient)
      : registration_(frames), guide_(parameters) {
    for (std::size_t i = 0; i < arms_.size(); ++i) {
      const bool isLeft = i % 2 == 0;
      arms_[i].place(at({isLeft ? -0.04 : 0.04, 0, -0.03}));
      manager_.add(kNames[i], arms_[i]);
      manager_.connect("Guide/" + kNames[i], kNames[i] + "/Arm");
    }
    manager_.connect("Guide/Vision", "Eyes/Vision");
    manager_.connect("Listener/Guidance", "Guide/Guidance");
    manager_.connect("Complaints/Messages", "Guide/Messages");
    manager_.connect("Guide/Registration", "Registration/Registration");
    manager_.start();
    EXPECT_TRUE(becomes(GuidanceState::Guiding));
    pass(10ms);
  }
  ~Guide() override { manager_.stop(); }

  bool becomes(GuidanceState state) {
    return suture::clockOfTest().until([&] { return guide_.guidance_state() == state; });
  }
  /// Both masters move by so much within the time.
  void moveMasters(const Vector3d& by, int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      for (ScriptedArm* master : {&arms_[0], &arms_[1]}) {
        master->place(Eigen::Translation3d(by / milliseconds) * master->pose());
      }
      pass(1ms);
    }
  }
  /// Both masters turn about z by so much within the time, rad.
  void turnMasters(double by, int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      for (ScriptedArm* master : {&arms_[0], &arms_[1]}) {
        master->place(master->pose() * Eigen::AngleAxisd(by / milliseconds, Vector3d::UnitZ()));
      }
      pass(1ms);
    }
    pass(5ms);
  }
  Vector3d left() const { return arms_[2].pose().translation(); }
  Vector3d right() const { return arms_[3].pose().translation(); }
  /// Makes what the registration tells take so much longer from now on.
  void registerLate(suture::Duration delay) {
    manager_.disconnect("Guide/Registration");
    manager_.connect("Guide/Registration", "Registration/Registration",
                     {.delay = {.answers = delay}});
  }
  void forgetGoals() {
    arms_[2].forgetGoals();
    arms_[3].forgetGoals();
  }
  std::size_t goals() const { return arms_[2].goals().size() + arms_[3].goals().size(); }
  void expectThatBothFollow() {
    const Vector3d leftBefore = left(), rightBefore = right();
    moveMasters({0.01, 0, 0}, 200);
    pass(5ms);
    EXPECT_NEAR((left() - leftBefore).x(), 0.004, 1e-6);
    EXPECT_NEAR((right() - rightBefore).x(), 0.004, 1e-6);
  }
  /// The slaves get no goals until the guide is enabled.
  void expectThatItWaitsForEnable() {
    forgetGoals();
    moveMasters({0, 0, 0.02}, 50);
    EXPECT_EQ(goals(), 0u);
    guide_.enable();
    ASSERT_TRUE(becomes(GuidanceState::Guiding));
    expectThatBothFollow();
  }

  static constexpr suture::Duration kPreparationLimit = 5s;
  static inline const GuideParameters kPatient{.preparation_limit = kPreparationLimit};
  static inline const std::array<std::string, 4> kNames{"LeftMaster", "RightMaster", "LeftSlave",
                                                        "RightSlave"};
  suture::Manager manager_{"console"};
  std::array<ScriptedArm, 4> arms_;
  Eyes eyes_;
  RegistrationTable registration_;
  KnotGuide guide_;
  Listener listener_;
  Complaints complaints_;
  TestConsole console_;

 private:
  // This adds them before the constructor's body, which connects them.
  const bool added_ = [this] {
    manager_.add("Eyes", eyes_);
    manager_.add("Registration", registration_);
    guide_.restartAfterFaults({.most = 1, .per = 24h});
    manager_.add("Guide", guide_);
    manager_.add("Listener", listener_);
    manager_.add("Complaints", complaints_);
    manager_.add("Console", console_);
    return true;
  }();
};

}  // namespace robots::test
