// These events go through a real FIFO.

#include "person/event_file.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>
#include <vector>

#include "unit/person/fifo.h"
#include "unit/person/recorded_events.h"

namespace robots::test {
namespace {

/// Returns the codes of what came.
std::vector<int> codes(std::span<const input_event> events) {
  std::vector<int> result;
  for (const input_event& one : events) result.push_back(one.code);
  return result;
}

TEST(EventFile, HandsOverWhatHasCome) {
  Fifo fifo;
  fifo.plugIn();
  EventFile file(fifo.path());
  ASSERT_TRUE(file.open());
  EXPECT_TRUE(file.read().empty());
  fifo.write({axis(ABS_Y, 1), axis(ABS_RX, 2), report()});
  EXPECT_EQ(codes(file.read()), (std::vector<int>{ABS_Y, ABS_RX, SYN_REPORT}));
  EXPECT_TRUE(file.read().empty());
  EXPECT_TRUE(file.isOpen());
}

TEST(EventFile, KeepsHalfAnEvent) {
  Fifo fifo;
  fifo.plugIn();
  EventFile file(fifo.path());
  ASSERT_TRUE(file.open());
  const std::vector<input_event> events{axis(ABS_Y, 1), axis(ABS_RX, 2), axis(ABS_RY, 3)};
  constexpr std::size_t kCut = sizeof(input_event) + 5, kSecondCut = kCut + 7;
  fifo.write(events, 0, kCut);
  EXPECT_EQ(codes(file.read()), std::vector<int>{ABS_Y});
  fifo.write(events, kCut, kSecondCut);
  EXPECT_TRUE(file.read().empty());
  fifo.write(events, kSecondCut, 3 * sizeof(input_event));
  const auto rest = file.read();
  EXPECT_EQ(codes(rest), (std::vector<int>{ABS_RX, ABS_RY}));
  EXPECT_EQ(rest.back().value, 3);
}

TEST(EventFile, HandsOverManyByTurns) {
  Fifo fifo;
  fifo.plugIn();
  EventFile file(fifo.path());
  ASSERT_TRUE(file.open());
  fifo.write(std::vector<input_event>(100, axis(ABS_X, 1)));
  EXPECT_EQ(file.read().size(), 64u);
  EXPECT_EQ(file.read().size(), 36u);
}

TEST(EventFile, ForgetsHalfAnEventWithoutWriter) {
  Fifo fifo;
  fifo.plugIn();
  EventFile file(fifo.path());
  ASSERT_TRUE(file.open());
  fifo.write({axis(ABS_X, 1)}, 0, 5);
  EXPECT_TRUE(file.read().empty());
  fifo.pullOut();
  EXPECT_TRUE(file.read().empty());
  EXPECT_FALSE(file.isOpen());
  EXPECT_EQ(file.error(), 0);

  fifo.plugIn();
  ASSERT_TRUE(file.open());
  fifo.write({axis(ABS_RX, 2)});
  EXPECT_EQ(codes(file.read()), std::vector<int>{ABS_RX});
}

TEST(EventFile, SaysWhyItCannotBeOpened) {
  const suture::TemporaryDirectory folder;
  EventFile missing(folder.file("none"));
  EXPECT_FALSE(missing.open());
  EXPECT_EQ(missing.error(), ENOENT);

  std::ofstream(folder.file("ordinary")) << "text";
  EventFile ordinary(folder.file("ordinary"));
  EXPECT_FALSE(ordinary.open()) << "it would be read again and again";
  EXPECT_EQ(ordinary.error(), ENODEV);
}

}  // namespace
}  // namespace robots::test
