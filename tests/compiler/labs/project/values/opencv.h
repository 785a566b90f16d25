#pragma once
// OpenCV's vectors derive from its matrices, which have enums without a name inside.

#include "labs/opencv.h"
#include "members.h"

namespace invented {

template <class T, int Rows, int Columns>
auto fields(cv::Matx<T, Rows, Columns>& v, Tag) {
  return list(v.val);
}
template <class T, int Rows, int Columns>
auto fields(const cv::Matx<T, Rows, Columns>& v, Tag) {
  return list(v.val);
}
auto fields(As<cv::Affine3d> auto& v, Tag) { return list(v.matrix); }
auto fields(As<cv::Point2f> auto& v, Tag) { return list(v.x, v.y); }
auto fields(As<cv::Size2f> auto& v, Tag) { return list(v.width, v.height); }
auto fields(As<cv::Rect> auto& v, Tag) { return list(v.x, v.y, v.width, v.height); }
auto fields(As<cv::Range> auto& v, Tag) { return list(v.start, v.end); }
auto fields(As<cv::KeyPoint> auto& v, Tag) {
  return list(v.pt, v.size, v.angle, v.response, v.octave, v.class_id);
}
auto fields(As<cv::DMatch> auto& v, Tag) {
  return list(v.queryIdx, v.trainIdx, v.imgIdx, v.distance);
}
auto fields(As<cv::RotatedRect> auto& v, Tag) { return list(v.center, v.size, v.angle); }
auto fields(As<cv::TermCriteria> auto& v, Tag) { return list(v.type, v.maxCount, v.epsilon); }
auto fields(As<lab::Sight> auto& v, Tag) {
  return list(v.camera, v.color, v.rotation, v.box, v.turned, v.rows, bounded(v.points, 16),
              bounded(v.matches, 16));
}

}  // namespace invented
