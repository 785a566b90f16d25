#include "experiment/record.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>

namespace experiment {
namespace {

using Eigen::Vector3d;
using Place = Course::Place;

Vector3d vectorOf(const Place& place) { return {place.x, place.y, place.z}; }

void require(bool done) {
  if (!done) throw std::runtime_error("the record of a trial in real time is not complete");
}

template <class Value>
void put(const std::vector<Value>& values, std::FILE* file) {
  const std::size_t count = values.size();
  require(std::fwrite(&count, sizeof(count), 1, file) == 1 &&
          std::fwrite(values.data(), sizeof(Value), count, file) == count);
}

template <class Value>
void take(std::vector<Value>& values, std::FILE* file) {
  std::size_t count = 0;
  require(std::fread(&count, sizeof(count), 1, file) == 1);
  values.resize(count);
  require(std::fread(values.data(), sizeof(Value), count, file) == count);
}

template <class Rec>
auto coursesOf(Rec& record) {
  return std::array{&record.left, &record.right, &record.leftSetpoint, &record.rightSetpoint,
                    &record.knot};
}

}  // namespace

void Course::add(suture::Time stamp, const Vector3d& place) {
  const std::int64_t count = suture::toNanoseconds(stamp);
  if (!places.empty() && places.back().stamp >= count) return;
  places.push_back({count, place.x(), place.y(), place.z()});
}

Vector3d Course::at(suture::Time then) const {
  if (places.empty()) return Vector3d::Zero();
  const std::int64_t count = suture::toNanoseconds(then);
  const auto after =
      std::lower_bound(places.begin(), places.end(), count,
                       [](const Place& place, std::int64_t stamp) { return place.stamp < stamp; });
  if (after == places.begin()) return vectorOf(*after);
  const Place& before = *std::prev(after);
  if (after == places.end()) return vectorOf(before);
  const double share =
      static_cast<double>(count - before.stamp) / static_cast<double>(after->stamp - before.stamp);
  return vectorOf(before) + share * (vectorOf(*after) - vectorOf(before));
}

bool Record::guidedAt(suture::Time then) const {
  const auto changes =
      std::upper_bound(guidance.begin(), guidance.end(), suture::toNanoseconds(then)) -
      guidance.begin();
  return changes % 2 == 1;
}

void write(const Record& record, std::FILE* file) {
  for (const Course* const course : coursesOf(record)) put(course->places, file);
  put(record.guidance, file);
  require(std::fflush(file) == 0);
}

Record readRecord(std::FILE* file) {
  Record record;
  for (Course* const course : coursesOf(record)) take(course->places, file);
  take(record.guidance, file);
  return record;
}

}  // namespace experiment
