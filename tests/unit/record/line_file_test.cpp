// A recording loses its file or the reader of its pipe while it is written.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <suture/base/line_file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>

#include "support/refusal.h"
#include "support/small_files.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

/// Returns more than a pipe holds.
std::string manyLines() {
  std::string lines;
  while (lines.size() < 500'000) lines += "a line of a recording\n";
  return lines;
}

class LineFileTest : public testing::Test {
 protected:
  const TemporaryDirectory directory_;
  const std::string path_ = directory_.file("run.jsonl");
};

TEST_F(LineFileTest, TakesNothingOnceItsFileIsRemoved) {
  LineFile file(path_);
  file.take();
  EXPECT_TRUE(file.append("kept\n"));
  std::filesystem::remove(path_);
  EXPECT_FALSE(file.append("lost\n"));
  EXPECT_STREQ(file.refusal().what(),
               ("recording to " + path_ +
                ": the file was removed or replaced while it was written. Leave it there until "
                "the recording ends")
                   .c_str());
}

TEST_F(LineFileTest, TakesNothingOnceAnotherFileReplacesIt) {
  LineFile file(path_);
  file.take();
  EXPECT_TRUE(file.append("kept\n"));
  std::ofstream(directory_.file("other")) << "other\n";
  std::filesystem::rename(directory_.file("other"), path_);
  EXPECT_FALSE(file.append("lost\n"));
}

TEST_F(LineFileTest, FollowsItsFilesNewName) {
  LineFile file(path_);
  file.take();
  EXPECT_TRUE(file.append("one\n"));
  std::filesystem::rename(path_, directory_.file("renamed"));
  EXPECT_TRUE(file.append("two\n"));
  EXPECT_EQ(std::filesystem::file_size(directory_.file("renamed")), 8u);
}

// A full disk is not the only reason: this one is the largest size that a file may have.
TEST_F(LineFileTest, TellsWhyItTookNotAll) {
  LineFile file(path_);
  file.take();
  {
    const SmallFiles limit(4);
    EXPECT_FALSE(file.append("a line that is longer\n"));
  }
  EXPECT_STREQ(file.refusal().what(),
               ("recording to " + path_ +
                ": not all of it was taken: File too large. Look at the disk that it is on, or "
                "name another file")
                   .c_str());
}

class LinePipeTest : public LineFileTest {
 protected:
  LinePipeTest() {
    EXPECT_EQ(mkfifo(path_.c_str(), 0600), 0);
    reader_ = open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  }
  ~LinePipeTest() override { close(reader_); }

  int reader_ = -1;
};

TEST_F(LinePipeTest, AnIdleReaderIsGivenUp) {
  LineFile file(path_);
  file.take();
  EXPECT_FALSE(file.append(manyLines()));
  EXPECT_STREQ(file.refusal().what(),
               ("recording to " + path_ +
                ": the reader of this pipe has taken nothing for 1 s. Start it anew with a reader "
                "that reads on")
                   .c_str());
  file.take();  // as its owner does when it is restarted
  EXPECT_FALSE(file.append("a line behind a torn one\n"));
}

TEST_F(LinePipeTest, TellsThatItsReaderHasGone) {
  LineFile file(path_);
  file.take();
  EXPECT_TRUE(file.append("read\n"));
  EXPECT_EQ(close(std::exchange(reader_, -1)), 0);
  EXPECT_FALSE(file.append("lost\n"));
  EXPECT_STREQ(file.refusal().what(),
               ("recording to " + path_ +
                ": the reader of this pipe has gone. Start it anew with a reader that reads on")
                   .c_str());
}

TEST_F(LinePipeTest, WaitsForAReaderThatIsSlow) {
  const std::string lines = manyLines();
  std::string heard;
  LineFile file(path_);
  file.take();
  std::thread slow([&] {
    char some[4096];
    while (heard.size() < lines.size()) {
      const ssize_t taken = read(reader_, some, sizeof(some));
      if (taken > 0) heard.append(some, static_cast<std::size_t>(taken));
    }
  });
  EXPECT_TRUE(file.append(lines));
  slow.join();
  EXPECT_EQ(heard, lines);
}

}  // namespace
}  // namespace suture
