// These run the endoscope and the tracker as a deployment has them: rates, latency, dropouts, a
// hand before a lens, and poses that come from pixels alone.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "registration/registration_table.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "timing/seconds.h"
#include "unit/vision/hanging.h"
#include "vision/knot_tracker.h"
#include "vision/synthetic_endoscope.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;
using suture::pass;

/// The camera looks straight down at what sways below it.
SceneFrames frames() {
  SceneFrames frames;
  frames.camera.linear().diagonal() << 1, -1, -1;
  frames.camera.translation().z() = -0.04;
  return frames;
}

/// Returns the strand in the scene: 15 mm to either side, at up to 30 mm/s.
Strand::Nodes strandAt(suture::Time time) {
  const double x = 0.015 * std::sin(2 * secondsBetween({}, time));
  Strand::Nodes nodes = hanging({-0.03, 0, -0.12}, {0, 0.006, -0.13}, {0.03, 0, -0.12});
  nodes.row(0).array() += x;
  return nodes;
}

/// Returns the knot in the frame of the left camera.
Vector3d knotAt(suture::Time time) {
  return frames().camera.inverse() * strandAt(time).col(Strand::kKnot);
}

class SwayingStrand final : public suture::PeriodicTask, public StrandView {
 public:
  SwayingStrand() : PeriodicTask({.period = 1ms}) { view_.keepState({.rows = 512}); }

  const StrandState& strand() const override { return state_; }
  void run() override {
    state_.stamp = suture::now();
    state_.nodes = strandAt(state_.stamp);
    state_.valid = true;
  }

 private:
  suture::Provided<StrandView> view_{*this, "Strand", *this};
  StrandState state_;
};

/// Passes on what it sees. While a hand is before one eye, the image of that eye is black.
class Lens final : public suture::PeriodicTask, public StereoImages {
 public:
  Lens() : PeriodicTask({.period = kPeriod}) { images_.keepState({.rows = 4}); }

  const StereoPair& images() const override { return pair_; }
  suture::Time exposed() const override { return pair_.left.stamp; }
  void run() override {
    if (!camera_.images(seen_) || seen_.left.stamp == pair_.left.stamp) return;
    pair_ = seen_;
    if (covered.load()) std::fill(pair_.right.data.begin(), pair_.right.data.end(), 0);
    arrived.push_back(pair_.left.stamp);
    ages.push_back(suture::now() - pair_.left.stamp);
    if (film != nullptr) film->push_back(pair_);
  }

  static constexpr suture::Duration kPeriod = 5ms;

  std::atomic<bool> covered{false};
  std::vector<suture::Time> arrived;   // the stamps of pairs
  std::vector<suture::Duration> ages;  // when they came
  std::vector<StereoPair>* film = nullptr;

 private:
  suture::Required<StereoImages> camera_{*this, "Camera"};
  suture::Provided<StereoImages> images_{*this, "Images", *this};
  StereoPair seen_, pair_;
};

struct Panel final : suture::Device {
  suture::Required<KnotVision> vision{*this, "Vision"};
  suture::Required<TrackedObject> knot{*this, "Knot"};
};

using Sightings = std::map<suture::Time, KnotSighting>;

/// Holds a whole system of strand, cameras and tracker.
class Theatre {
 public:
  explicit Theatre(const EndoscopeParameters& parameters) : endoscope(parameters) {
    manager_.add("Strand", strand_);
    manager_.add("Registration", registration_);
    manager_.add("Endoscope", endoscope);
    manager_.connect("Endoscope/Strand", "Strand/Strand");
    manager_.connect("Endoscope/Registration", "Registration/Registration");
    manager_.add("Lens", lens);
    manager_.add("Tracker", tracker);
    manager_.add("Panel", panel);
    manager_.connect("Lens/Camera", "Endoscope/Images");
    manager_.connect("Tracker/Images", "Lens/Images");
    manager_.connect("Panel/Vision", "Tracker/Vision");
    manager_.connect("Panel/Knot", "Tracker/Knot");
    manager_.start();
    // A value that no client has asked for is not published.
    (void)panel.vision.sighting();
    (void)panel.knot.measured_cp();
    (void)panel.knot.measured_cv();
  }
  ~Theatre() { manager_.stop(); }

  /// Lets time pass, and keeps what the tracker says.
  void watch(suture::Duration duration) {
    for (const suture::Time end = suture::now() + duration; suture::now() < end; pass(5ms)) {
      const KnotSighting& sighting = tracker.sighting();
      sightings[sighting.stamp] = sighting;
    }
  }

  Lens lens;
  KnotTracker tracker{TrackerParameters{}};
  Panel panel;
  Sightings sightings;

 private:
  SwayingStrand strand_;
  RegistrationTable registration_{frames()};

 public:
  SyntheticEndoscope endoscope;

 private:
  suture::Manager manager_{"vision"};
};

EndoscopeParameters steady() { return {.dropout = 0}; }

TEST(Endoscope, DrawsBeforeItsFirstCycle) {
  const Theatre theatre(steady());
  const StereoPair& pair = theatre.endoscope.images();
  EXPECT_EQ(pair.left.width, 640u) << "Mesa compiles with the first image, which takes long";
  EXPECT_EQ(pair.right.width, 640u);
  EXPECT_FALSE(pair.left.valid || pair.right.valid) << "nothing was before the cameras";
}

TEST(Endoscope, TakesPairsAtItsRate) {
  for (const auto& [period, pairs] : {std::pair(66'667us, 15.0), std::pair(16'667us, 60.0)}) {
    EndoscopeParameters parameters = steady();
    parameters.period = period;
    Theatre theatre(parameters);
    pass(1s);
    EXPECT_NEAR(static_cast<double>(theatre.lens.arrived.size()), pairs, 4)
        << "the first have no strand yet";
  }
}

TEST(Endoscope, LateImagesKeepTheirExposuresStamp) {
  for (const suture::Duration latency : {0ms, 30ms, 120ms}) {
    EndoscopeParameters parameters = steady();
    parameters.latency = latency;
    Theatre theatre(parameters);
    theatre.watch(600ms);
    ASSERT_GT(theatre.lens.ages.size(), 5u);
    for (const suture::Duration age : theatre.lens.ages) {
      EXPECT_GE(age, latency);
      EXPECT_LE(age, latency + 1ms + Lens::kPeriod) << "a cycle of the strand, and of the lens";
    }
    // Images show what was before the cameras then.
    int seen = 0;
    for (const auto& [stamp, sighting] : theatre.sightings) {
      if (!sighting.valid) continue;
      EXPECT_LT((sighting.knot - knotAt(stamp)).norm(), 0.001);
      ++seen;
    }
    EXPECT_GT(seen, 3);
  }
}

TEST(Endoscope, LosesItsShareOfPairs) {
  EndoscopeParameters parameters = steady();
  parameters.dropout = 0.4;
  Theatre theatre(parameters);
  theatre.watch(2s);
  EXPECT_NEAR(static_cast<double>(theatre.lens.arrived.size()), 0.6 * 30, 8);
  // A pair that is lost is no reason to forget what the one before it showed.
  const auto knot = theatre.panel.knot.measured_cp();
  EXPECT_TRUE(knot && knot->valid);
  EXPECT_TRUE(theatre.tracker.sighting().valid);
}

TEST(Endoscope, ASilentEndoscopeShowsNothing) {
  EndoscopeParameters parameters = steady();
  parameters.dropout = 1;
  Theatre theatre(parameters);
  theatre.watch(500ms);
  EXPECT_TRUE(theatre.lens.arrived.empty());
  EXPECT_FALSE(theatre.tracker.sighting().valid);
  const auto knot = theatre.panel.knot.measured_cp();
  EXPECT_TRUE(knot && !knot->valid);
}

// The first pair that is exposed with a hand before one eye is not valid, and no pose comes of it.
TEST(Tracker, ACoveredLensHidesEverythingAtOnce) {
  Theatre theatre(steady());
  theatre.watch(500ms);
  ASSERT_TRUE(theatre.tracker.sighting().valid);
  const std::size_t before = theatre.lens.arrived.size();
  theatre.lens.covered = true;
  ASSERT_TRUE(suture::clockOfTest().until([&] { return theatre.lens.arrived.size() > before; }));
  pass(TrackerParameters{}.period + Lens::kPeriod);
  EXPECT_EQ(theatre.lens.arrived.size(), before + 1) << "within one frame";
  const auto sighting = theatre.panel.vision.sighting();
  ASSERT_TRUE(sighting);
  EXPECT_FALSE(sighting->valid);
  EXPECT_EQ(sighting->stamp, theatre.lens.arrived.back());
  const auto knot = theatre.panel.knot.measured_cp();
  EXPECT_TRUE(knot && !knot->valid);
  const auto speed = theatre.panel.knot.measured_cv();
  EXPECT_TRUE(speed && !speed->valid);
  theatre.lens.covered = false;
  pass(100ms);
  EXPECT_TRUE(theatre.tracker.sighting().valid) << "and sees again";
}

// At up to 30 mm/s a sighting is 3 mm and more behind the knot; the pose is where the knot is now.
TEST(Tracker, PosesMakeUpForTheirAge) {
  EndoscopeParameters parameters = steady();
  parameters.latency = 80ms;
  Theatre theatre(parameters);
  theatre.watch(1s);
  double late = 0, pose = 0, speed = 0;
  for (int i = 0; i < 100; ++i, pass(10ms)) {
    const auto sample = theatre.panel.knot.measured_cp();
    const auto twist = theatre.panel.knot.measured_cv();
    ASSERT_TRUE(sample && sample->valid && twist && twist->valid);
    const Vector3d truth = knotAt(sample->stamp);
    EXPECT_LE(suture::now() - sample->stamp, TrackerParameters{}.period);
    late += (theatre.tracker.sighting().knot - truth).squaredNorm();
    pose += (sample->pose.translation() - truth).squaredNorm();
    const Vector3d moved = knotAt(sample->stamp + 1ms) - knotAt(sample->stamp - 1ms);
    speed += (twist->linear - moved / 0.002).squaredNorm();
  }
  EXPECT_LT(std::sqrt(pose), 0.5 * std::sqrt(late));
  EXPECT_LT(std::sqrt(pose / 100), 0.0012);
  EXPECT_LT(std::sqrt(speed / 100), 0.015);
}

/// Shows pairs that another system recorded, of which nothing else is left.
class Projector final : public suture::PeriodicTask, public StereoImages {
 public:
  explicit Projector(const std::vector<StereoPair>& film)
      : PeriodicTask({.period = 66'667us}), film_(film) {
    images_.keepState({.rows = 4});
  }

  const StereoPair& images() const override { return pair_; }
  suture::Time exposed() const override { return pair_.left.stamp; }
  void run() override {
    if (next_ < film_.size()) pair_ = film_[next_++];
  }

 private:
  suture::Provided<StereoImages> images_{*this, "Images", *this};
  const std::vector<StereoPair>& film_;
  std::size_t next_ = 0;
  StereoPair pair_;
};

// A system that has no strand, no registration and no endoscope, but only what they once showed,
// tells the same of each pair to the last bit.
TEST(Tracker, TellsTheSameWithoutAnyTruth) {
  std::vector<StereoPair> film;
  Sightings before;
  {
    Theatre theatre(steady());
    theatre.lens.film = &film;
    theatre.watch(1s);
    before = theatre.sightings;
  }
  ASSERT_GT(film.size(), 10u);
  Projector projector(film);
  KnotTracker tracker{TrackerParameters{}};
  suture::Manager manager("cinema");
  manager.add("Projector", projector);
  manager.add("Tracker", tracker);
  manager.connect("Tracker/Images", "Projector/Images");
  manager.start();
  int same = 0;
  for (int i = 0; i < 250; ++i, pass(5ms)) {
    const KnotSighting& now = tracker.sighting();
    const auto then = before.find(now.stamp);
    if (!now.valid || then == before.end()) continue;
    ASSERT_TRUE(then->second.valid);
    EXPECT_EQ(now.knot, then->second.knot);
    EXPECT_EQ(now.left_tip, then->second.left_tip);
    EXPECT_EQ(now.right_tip, then->second.right_tip);
    ++same;
  }
  manager.stop();
  EXPECT_GT(same, 100);
}

}  // namespace
}  // namespace robots::test
