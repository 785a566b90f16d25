// A recorded knot is read back as it was; a broken recording is named with its line.

#include "recorder/knot_recording.h"

#include <gtest/gtest.h>
#include <suture/base/time.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/contains.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace robots::test {
namespace {

using Eigen::Vector3d;

/// Returns a row in which no field is as in a new row, or equal to another; few numbers are short
/// in decimal.
KnotRow someKnotRow() {
  KnotRow row;
  for (Eigen::Index i = 0; i < row.strand.nodes.size(); ++i) {
    row.strand.nodes(i) = 1.0 / static_cast<double>(i + 3);
  }
  row.strand.left_length = 0.1 / 3;
  row.strand.left_tension = 0.2 / 3;
  row.strand.right_tension = -0.1 / 7;
  row.strand.stamp = suture::fromNanoseconds(1'234'567'890'123'456'789);
  row.strand.valid = true;
  row.camera.translation() = Vector3d(0.1, 1.0 / 3, -1e-9);
  row.camera.linear() = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  row.tissue = -0.5 / 3;
  row.sighting.knot = Vector3d(1, 2, 3) / 7;
  row.sighting.left_tip = Vector3d(4, 5, 6) / 11;
  row.sighting.right_tip = Vector3d(7, 8, 9) / 13;
  row.sighting.stamp = suture::fromNanoseconds(1'234'567'890'000'000'001);
  row.sighting.valid = true;
  row.guiding = true;
  return row;
}

void expectEqual(const KnotSighting& found, const KnotSighting& expected) {
  EXPECT_EQ(found.knot, expected.knot);
  EXPECT_EQ(found.left_tip, expected.left_tip);
  EXPECT_EQ(found.right_tip, expected.right_tip);
  EXPECT_EQ(found.stamp, expected.stamp);
  EXPECT_EQ(found.valid, expected.valid);
}

void expectEqual(const StrandState& found, const StrandState& expected) {
  EXPECT_EQ(found.nodes, expected.nodes);
  EXPECT_EQ(found.left_length, expected.left_length);
  EXPECT_EQ(found.left_tension, expected.left_tension);
  EXPECT_EQ(found.right_tension, expected.right_tension);
  EXPECT_EQ(found.stamp, expected.stamp);
  EXPECT_EQ(found.valid, expected.valid);
}

void expectEqual(const KnotRow& found, const KnotRow& expected) {
  expectEqual(found.strand, expected.strand);
  EXPECT_EQ(found.camera.matrix(), expected.camera.matrix());
  EXPECT_EQ(found.tissue, expected.tissue);
  expectEqual(found.sighting, expected.sighting);
  EXPECT_EQ(found.guiding, expected.guiding);
}

class KnotRecordingTest : public testing::Test {
 private:
  const suture::TemporaryDirectory folder_;

 protected:
  const std::filesystem::path file_ = folder_.file("knot.jsonl");

  void record(const std::vector<KnotRow>& rows) const {
    std::ofstream out(file_);
    for (const KnotRow& row : rows) write(out, row);
  }
};

TEST_F(KnotRecordingTest, ReadsBackEachFieldExactly) {
  KnotRow unseen = someKnotRow();
  unseen.sighting = {};
  unseen.guiding = false;
  record({someKnotRow(), unseen});
  const std::vector<KnotRow> rows = readKnotRecording(file_).rows;
  ASSERT_EQ(rows.size(), 2u);
  expectEqual(rows[0], someKnotRow());
  expectEqual(rows[1], unseen);
}

TEST_F(KnotRecordingTest, FindsTheKnotInTheStrand) {
  KnotRow row;
  row.strand.nodes.col(30) = Vector3d(1, 2, 3);
  EXPECT_EQ(row.knot(), Vector3d(1, 2, 3));
}

TEST_F(KnotRecordingTest, NamesTheLineOfACut) {
  record({someKnotRow(), someKnotRow()});
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) * 3 / 4);
  const std::string refused = suture::refusal([&] { readKnotRecording(file_); });
  EXPECT_TRUE(suture::contains(refused, file_.string() + ":2")) << refused;
}

TEST_F(KnotRecordingTest, RefusesAFileThatIsNotThere) {
  const std::string refused = suture::refusal([&] { readKnotRecording(file_); });
  EXPECT_TRUE(suture::contains(refused, file_.string())) << refused;
  EXPECT_TRUE(suture::contains(refused, "it cannot be opened")) << refused;
}

}  // namespace
}  // namespace robots::test
