#pragma once
// These types of OpenCV derive from its matrices, or hold one another.

#include <suture/annotate.h>

#include <opencv2/core/affine.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

namespace lab {

SUTURE_EXTERNAL_TYPE(cv::Matx31d);
SUTURE_EXTERNAL_TYPE(cv::Matx41d);
SUTURE_EXTERNAL_TYPE(cv::Matx44d, name("Transform"));
SUTURE_EXTERNAL_TYPE(cv::Vec3d);
SUTURE_EXTERNAL_TYPE(cv::Vec4d);
SUTURE_EXTERNAL_TYPE(cv::Scalar);
SUTURE_EXTERNAL_TYPE(cv::Affine3d);
SUTURE_EXTERNAL_TYPE(cv::Point2f);
SUTURE_EXTERNAL_TYPE(cv::Size2f);
SUTURE_EXTERNAL_TYPE(cv::Rect);
SUTURE_EXTERNAL_TYPE(cv::Range);
SUTURE_EXTERNAL_TYPE(cv::KeyPoint);
SUTURE_EXTERNAL_TYPE(cv::DMatch);
SUTURE_EXTERNAL_TYPE(cv::RotatedRect);
SUTURE_EXTERNAL_TYPE(cv::TermCriteria);
SUTURE_EXTERNAL_TYPE(cv::TermCriteria::Type);

/// What a tracker saw.
struct SUTURE_TYPE() Sight {
  cv::Affine3d camera;
  cv::Scalar color;
  cv::Vec3d rotation;
  cv::Rect box;
  cv::RotatedRect turned;
  cv::Range rows;
  SUTURE_FIELD(capacity(16)) std::vector<cv::KeyPoint> points;
  SUTURE_FIELD(capacity(16)) std::vector<cv::DMatch> matches;
};

/// A tracker.
class SUTURE_INTERFACE() Tracker {
 public:
  virtual ~Tracker() = default;
  SUTURE_COMMAND() virtual void stopAt(const cv::TermCriteria& criteria) = 0;
  SUTURE_COMMAND() virtual const Sight& sight() const = 0;
  SUTURE_EVENT(queue(4)) suture::EventOf<cv::KeyPoint, cv::TermCriteria::Type> lost;
};

}  // namespace lab
