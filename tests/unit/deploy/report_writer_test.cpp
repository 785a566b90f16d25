// These reports go to a reader that does not read.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <suture/deploy/report_writer.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace suture {
namespace {

using nlohmann::json;

class Pipe {
 public:
  /// `flags` of the writing end.
  explicit Pipe(int flags) {
    EXPECT_EQ(pipe(ends_.data()), 0);
    fcntl(writer(), F_SETFL, fcntl(writer(), F_GETFL) | flags);
  }
  ~Pipe() {
    close(ends_[0]);
    closeWriter();
  }
  int writer() const { return ends_[1]; }
  void closeWriter() {
    if (ends_[1] >= 0) close(std::exchange(ends_[1], -1));
  }
  void fill() const {
    const int flags = fcntl(writer(), F_GETFL);
    fcntl(writer(), F_SETFL, flags | O_NONBLOCK);
    while (write(writer(), "\n", 1) == 1) {
    }
    fcntl(writer(), F_SETFL, flags);
  }
  /// Takes all that is there, as soon as there is something.
  std::string take() const {
    std::string text(1 << 20, ' ');
    const ssize_t size = read(ends_[0], text.data(), text.size());
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    return text;
  }

 private:
  std::array<int, 2> ends_{};
};

/// Returns the kinds of the messages in `text`, each of which must be whole.
std::vector<std::string> kindsIn(const std::string& text) {
  std::vector<std::string> kinds;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) kinds.push_back(json::parse(line).at("kind"));
  }
  return kinds;
}

class SlowReader : public testing::TestWithParam<int> {};

TEST_P(SlowReader, GetsWholeMessagesWithoutReports) {
  const Pipe pipe(GetParam());
  pipe.fill();
  ReportWriter writer(pipe.writer(), ReportWriter::Form::Json);
  writer.started();  // each of these would wait for the reader, or be lost
  writer.report({});
  writer.failure(std::string(5000, 'x'));
  EXPECT_EQ(kindsIn(pipe.take()), std::vector<std::string>{});
  writer.flush();
  writer.report({});
  EXPECT_EQ(kindsIn(pipe.take()), (std::vector<std::string>{"started", "failure", "report"}));
}

TEST_P(SlowReader, IsToldHowManyFailuresItMissed) {
  Pipe pipe(GetParam());
  pipe.fill();
  ReportWriter writer(pipe.writer(), ReportWriter::Form::Json);
  writer.failure(std::string(2 << 20, 'x'));
  for (int i = 0; i < 3; ++i) writer.failure("lost");
  pipe.take();
  std::string all;
  for (std::string part; !all.ends_with("\n"); all += part) {
    writer.flush();
    part = pipe.take();
  }
  EXPECT_EQ(kindsIn(all), std::vector<std::string>{"failure"});
  writer.report({});
  const std::string rest = pipe.take();
  EXPECT_EQ(kindsIn(rest), (std::vector<std::string>{"failure", "report"}));
  EXPECT_NE(rest.find("3 failures are left out here"), std::string::npos) << rest;
}

TEST_P(SlowReader, GetsWhatIsLongerThanThePipe) {
  Pipe pipe(GetParam());
  ReportWriter writer(pipe.writer(), ReportWriter::Form::Json);
  writer.failure(std::string(300'000, 'x'));
  writer.started();
  std::string all;
  std::thread reader([&] {
    for (std::string part; !(part = pipe.take()).empty();) all += part;
  });
  for (int i = 0; i < 100; ++i) writer.flush(std::chrono::milliseconds(10));
  pipe.closeWriter();
  reader.join();
  EXPECT_EQ(kindsIn(all), (std::vector<std::string>{"failure", "started"}));
}

INSTANTIATE_TEST_SUITE_P(Pipes, SlowReader, testing::Values(0, O_NONBLOCK));

TEST(ReportWriter, AGoneReaderIsNoError) {
  std::signal(SIGPIPE, SIG_IGN);
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  close(ends[0]);
  ReportWriter writer(ends[1], ReportWriter::Form::Text);
  writer.failure("x");
  writer.failure("x");
  EXPECT_EQ(writer.takeProblem(), "");
  close(ends[1]);
}

TEST(ReportWriter, AFullFileIsToldOnce) {
  const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(full, 0);
  ReportWriter writer(full, ReportWriter::Form::Text);
  writer.failure("x");
  EXPECT_EQ(writer.takeProblem(),
            "write reports: No space left on device. None is written any more: make room, or give "
            "another file with --report-fd");
  writer.failure("x");
  EXPECT_EQ(writer.takeProblem(), "");
  close(full);
}

}  // namespace
}  // namespace suture
