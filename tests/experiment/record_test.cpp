// These say what becomes of what one side has seen.

#include "experiment/record.h"

#include <gtest/gtest.h>

#include <chrono>

namespace experiment {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;
using suture::Time;

TEST(Course, IsOnTheLineBetweenTwoPlaces) {
  Course course;
  EXPECT_EQ(course.at(Time{1ms}), Vector3d::Zero());
  course.add(Time{1ms}, {1, 0, 0});
  course.add(Time{3ms}, {2, 4, 0});
  EXPECT_EQ(course.at(Time{0ms}), Vector3d(1, 0, 0));
  EXPECT_EQ(course.at(Time{1ms}), Vector3d(1, 0, 0));
  EXPECT_EQ(course.at(Time{2ms}), Vector3d(1.5, 2, 0));
  EXPECT_EQ(course.at(Time{4ms}), Vector3d(2, 4, 0));
}

TEST(Course, KeepsWhatIsNew) {
  Course course;
  course.add(Time{2ms}, {1, 0, 0});
  course.add(Time{2ms}, {2, 0, 0});
  course.add(Time{1ms}, {3, 0, 0});
  EXPECT_EQ(course.places.size(), 1u);
}

TEST(Record, IsReadAsItWasWritten) {
  Record record;
  record.left.add(Time{1ms}, {1, 2, 3});
  record.knot.add(Time{2ms}, {4, 5, 6});
  record.guidance = {10, 20, 30};
  std::FILE* const file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  write(record, file);
  std::rewind(file);
  const Record read = readRecord(file);
  std::fclose(file);
  EXPECT_EQ(read.left.at(Time{1ms}), Vector3d(1, 2, 3));
  EXPECT_EQ(read.knot.at(Time{1ms}), Vector3d(4, 5, 6));
  EXPECT_TRUE(read.right.places.empty());
  EXPECT_EQ(read.guidance, record.guidance);
  EXPECT_FALSE(read.guidedAt(Time{9ns}));
  EXPECT_TRUE(read.guidedAt(Time{10ns}));
  EXPECT_FALSE(read.guidedAt(Time{20ns}));
  EXPECT_TRUE(read.guidedAt(Time{31ns}));
}

TEST(Record, OneThatIsCutOffIsRefused) {
  std::FILE* const file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  EXPECT_THROW(readRecord(file), std::runtime_error);
  std::fclose(file);
}

}  // namespace
}  // namespace experiment
