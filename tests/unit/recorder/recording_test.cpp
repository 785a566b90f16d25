// A recording is read back as it was written; a broken one is named with its line.

#include "recorder/recording.h"

#include <gtest/gtest.h>
#include <suture/base/errors.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "recorder/recording_writer.h"
#include "support/eventually.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace robots::test {
namespace {

constexpr std::size_t kRecords = 4096;

class RecordingTest : public testing::Test {
 private:
  const suture::TemporaryDirectory folder_;

 protected:
  const std::filesystem::path file_ = folder_.file("recording.jsonl");
};

void begin(RecordingWriter<Record>& writer) {
  writer.open();
  writer.begin();
}

Eigen::Isometry3d somePose() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(0.1, 1.0 / 3, -1e-9);
  pose.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return pose;
}

TEST_F(RecordingTest, ReadsBackWhatWasPushed) {
  constexpr std::int64_t kRows = 1000;
  {
    RecordingWriter<Record> writer(file_, kRecords);
    begin(writer);
    ASSERT_TRUE(writer.push(FollowAnchors{.master_stamp = suture::fromNanoseconds(5),
                                          .master = somePose(),
                                          .slave_setpoint = somePose().inverse(),
                                          .scale = 0.2,
                                          .entry = 3,
                                          .view = somePose().linear(),
                                          .rotation_locked = false,
                                          .translation_locked = true}));
    ASSERT_TRUE(writer.push(ClutchNews{true, suture::fromNanoseconds(4)}));
    ASSERT_TRUE(writer.push(ClutchNews{false, suture::fromNanoseconds(8)}));
    ASSERT_TRUE(writer.push(StopNews{true, suture::fromNanoseconds(6)}));
    ASSERT_TRUE(writer.push(StopNews{false, suture::fromNanoseconds(7)}));
    for (std::int64_t i = 0; i < kRows; ++i) {
      ASSERT_TRUE(
          writer.push(ArmRow{suture::fromNanoseconds(i), somePose(), suture::fromNanoseconds(i - 1),
                             somePose().inverse(), i % 2 == 0}));
    }
  }
  const Recording recording = readRecording(file_);
  ASSERT_EQ(recording.arm.size(), std::size_t{kRows});
  EXPECT_EQ(recording.arm[7].stamp, suture::fromNanoseconds(7));
  EXPECT_FALSE(recording.arm[7].enabled);
  EXPECT_TRUE(recording.arm[8].enabled);
  EXPECT_EQ(recording.arm[7].goal_stamp, suture::fromNanoseconds(6));
  EXPECT_TRUE(recording.arm[7].measured.isApprox(somePose(), 1e-15));
  EXPECT_TRUE(recording.arm[7].setpoint.isApprox(somePose().inverse(), 1e-15));
  EXPECT_EQ(recording.lost, 0u);
  ASSERT_EQ(recording.clutch.size(), 2u);
  EXPECT_TRUE(recording.clutch[0].pressed);
  EXPECT_EQ(recording.clutch[0].stamp, suture::fromNanoseconds(4));
  EXPECT_FALSE(recording.clutch[1].pressed);
  ASSERT_EQ(recording.stops.size(), 2u);
  EXPECT_TRUE(recording.stops[0].pressed);
  EXPECT_EQ(recording.stops[0].stamp, suture::fromNanoseconds(6));
  EXPECT_FALSE(recording.stops[1].pressed);
  ASSERT_EQ(recording.followed.size(), 1u);
  EXPECT_EQ(recording.followed[0].master_stamp, suture::fromNanoseconds(5));
  EXPECT_EQ(recording.followed[0].scale, 0.2);
  EXPECT_EQ(recording.followed[0].entry, 3u);
  EXPECT_TRUE(recording.followed[0].slave_setpoint.isApprox(somePose().inverse(), 1e-15));
  EXPECT_TRUE(recording.followed[0].view.isApprox(somePose().linear(), 1e-15));
  EXPECT_FALSE(recording.followed[0].rotation_locked);
  EXPECT_TRUE(recording.followed[0].translation_locked);
}

TEST_F(RecordingTest, IsReadWhileItIsWritten) {
  RecordingReader reader(file_);
  EXPECT_TRUE(reader.next().arm.empty()) << "nobody has begun";
  EXPECT_THROW(reader.rest(), suture::SetupError);
  std::ostringstream text;
  for (std::int64_t i = 0; i < 3; ++i) {
    write(text, ArmRow{suture::fromNanoseconds(i), somePose(), {}, somePose()});
  }
  const std::string all = text.str();
  std::ofstream out(file_);
  std::vector<ArmRow> rows;
  for (const std::size_t end : {std::size_t{10}, all.size() / 2, all.size() - 1, all.size()}) {
    out << all.substr(static_cast<std::size_t>(out.tellp()),
                      end - static_cast<std::size_t>(out.tellp()))
        << std::flush;
    for (const ArmRow& row : reader.next().arm) rows.push_back(row);
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(std::count(
                               all.begin(), all.begin() + static_cast<std::ptrdiff_t>(end), '\n')));
  }
  EXPECT_EQ(rows.back().stamp, suture::fromNanoseconds(2));
  EXPECT_TRUE(reader.rest().arm.empty());
}

TEST_F(RecordingTest, NamesTheLineOfABreak) {
  {
    RecordingWriter<Record> writer(file_, kRecords);
    begin(writer);
    writer.push(ArmRow{});
  }
  std::ofstream(file_, std::ios::app) << "{\"stamp\":12";
  try {
    readRecording(file_);
    FAIL() << "a torn line was accepted";
  } catch (const suture::SetupError& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.starts_with("reading the recording " + file_.string() + ":2: ")) << text;
    EXPECT_TRUE(text.ends_with("The recorder may have been killed while it wrote; record anew"));
  }
}

TEST_F(RecordingTest, CountsWhatTheDiskDoesNotTake) {
  RecordingWriter<Record> writer("/dev/full", kRecords);
  begin(writer);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(writer.push(ArmRow{}));
  EXPECT_TRUE(suture::eventually([&] { return writer.lost() == 3; }));
  EXPECT_TRUE(writer.push(ArmRow{}));
  EXPECT_TRUE(suture::eventually([&] { return writer.lost() == 4; })) << "and what comes later";
}

TEST_F(RecordingTest, CountsWhatARemovedFileMisses) {
  testing::internal::CaptureStderr();
  {
    RecordingWriter<Record> writer(file_, kRecords);
    begin(writer);
    EXPECT_TRUE(suture::eventually([&] { return std::filesystem::exists(file_); }));
    std::filesystem::remove(file_);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(writer.push(ArmRow{}));
    EXPECT_TRUE(suture::eventually([&] { return writer.lost() == 3; }));
    EXPECT_TRUE(writer.push(ArmRow{}));
    EXPECT_TRUE(suture::eventually([&] { return writer.lost() == 4; }));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "recording to " + file_.string() +
                ": the file was removed or replaced while it was written. Leave it there until "
                "the recording ends\n")
      << "once";
}

TEST_F(RecordingTest, SaysHowManyRowsItLacks) {
  constexpr std::size_t kRoom = 8;
  {
    RecordingWriter<Record> writer(file_, kRoom);
    writer.open();  // it writes nothing until it begins
    for (std::size_t i = 0; i < kRoom; ++i) ASSERT_TRUE(writer.push(ArmRow{}));
    for (int i = 0; i < 3; ++i) ASSERT_FALSE(writer.push(ArmRow{}));
    writer.begin();
  }
  const Recording recording = readRecording(file_);
  EXPECT_EQ(recording.arm.size(), kRoom);
  EXPECT_EQ(recording.lost, 3u);
}

TEST_F(RecordingTest, AnEarlierRecordingStaysAtFirst) {
  std::ofstream(file_) << "kept\n";
  { RecordingWriter<Record> refused(file_, kRecords); }
  {
    RecordingWriter<Record> first(file_, kRecords), second(file_, kRecords);
    first.open();
    EXPECT_NE(suture::refusal([&] { second.open(); }).find("another recording is being written"),
              std::string::npos);
  }
  EXPECT_EQ(std::filesystem::file_size(file_), 5u);
  {
    RecordingWriter<Record> writer(file_, kRecords);
    begin(writer);
  }
  EXPECT_EQ(std::filesystem::file_size(file_), 0u);
}

TEST_F(RecordingTest, RefusesFilesItCannotUse) {
  EXPECT_EQ(suture::refusal([this] { readRecording(file_); }),
            "reading the recording " + file_.string() +
                ": it cannot be opened. Check that the recorder ran");
  EXPECT_TRUE(suture::refusal([] {
                RecordingWriter<Record> writer("/nowhere/at/all.jsonl", kRecords);
              }).starts_with("recording to /nowhere/at/all.jsonl: the file cannot be written. "));
}

}  // namespace
}  // namespace robots::test
