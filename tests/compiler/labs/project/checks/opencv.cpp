// OpenCV's vectors derive from its matrices, which have enums without a name inside.

#include "values/opencv.h"
#include "connected.h"
#include "labs/opencv.capnp.h"
#include "labs/opencv.suture.h"

namespace lab {

void toWire(const SightSlot&, wire::Sight::Builder);
suture::Errc fromWire(wire::Sight::Reader, SightSlot&, suture::Duration);
bool isValid(const SightSlot&, suture::FieldPath* = nullptr);
void toWire(const cvTermCriteriaSlot&, wire::TermCriteria::Builder);
suture::Errc fromWire(wire::TermCriteria::Reader, cvTermCriteriaSlot&, suture::Duration);
bool isValid(const cvTermCriteriaSlot&, suture::FieldPath* = nullptr);

}  // namespace lab

namespace invented {

class TrackerProvider final : public suture::EventTask, public lab::Tracker {
 public:
  void stopAt(const cv::TermCriteria& criteria) override {
    sight_.rotation[1] = criteria.epsilon;
    require(port_.emit().lost(cv::KeyPoint(1, 2, 3), cv::TermCriteria::EPS).has_value(), "lost",
            "is not emitted");
  }
  const lab::Sight& sight() const override { return sight_; }
  void run() override {}

 private:
  lab::Sight sight_;
  suture::Provided<lab::Tracker> port_{*this, "Port", *this};
};

void connectOpenCv(Random&) {
  int events = 0;
  Connected<lab::Tracker, TrackerProvider> tracker([&](auto& port) {
    port.on().lost([&](const cv::KeyPoint& point, cv::TermCriteria::Type type) {
      events += point.pt.y == 2 && type == cv::TermCriteria::EPS ? 1 : 0;
    });
  });
  const cv::TermCriteria criteria(cv::TermCriteria::MAX_ITER, 10, 0.25);
  require(tracker.port().stopAt(criteria).has_value(), "stopAt", "is not sent");
  tracker.until([&] { return events == 1; }, "lost");
  const auto sight = tracker.port().sight.fresh().within(10s);
  require(sight && sight->rotation[1] == 0.25, "sight", "the read answers another value");
}

void checkOpenCv(Random& random) {
  checkType<lab::Sight, lab::SightSlot, lab::wire::Sight>("Sight", random);
  checkType<cv::TermCriteria, lab::cvTermCriteriaSlot, lab::wire::TermCriteria>("TermCriteria",
                                                                                random);

  lab::Sight sight;
  checkRefused<lab::SightSlot>(sight, "");
  sight.rotation[2] = kNaN;
  checkRefused<lab::SightSlot>(sight, "rotation.val[2]");
  sight.rotation[2] = 0;
  sight.camera.matrix(1, 3) = kNaN;
  checkRefused<lab::SightSlot>(sight, "camera.matrix.val[7]");
  connectOpenCv(random);
}

}  // namespace invented
