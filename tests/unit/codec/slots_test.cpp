// Slots become values of the user's types again.

#include <gtest/gtest.h>
#include <suture/base/slots/slots.h>

#include <deque>
#include <memory>
#include <vector>

namespace suture {
namespace {

/// Says that it has a copy, as each std::deque does, and has none.
struct Shelf {
  std::deque<std::unique_ptr<double>> parts;
};
struct ShelfSlot {
  BoundedList<SlotOptional<double>, 2> parts;
};
bool store(const Shelf& value, ShelfSlot& slot) { return suture::store(value.parts, slot.parts); }
void load(const ShelfSlot& slot, Shelf& value) { suture::load(slot.parts, value.parts); }

std::vector<Shelf> shelvesOf(const std::vector<std::vector<double>>& numbers) {
  std::vector<Shelf> result(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (const double number : numbers[i]) {
      result[i].parts.push_back(std::make_unique<double>(number));
    }
  }
  return result;
}

std::vector<std::vector<double>> numbersOf(const std::vector<Shelf>& shelves) {
  std::vector<std::vector<double>> result(shelves.size());
  for (std::size_t i = 0; i < shelves.size(); ++i) {
    for (const auto& number : shelves[i].parts) result[i].push_back(*number);
  }
  return result;
}

/// A vector moves its elements to a larger place by a copy if their move may throw.
TEST(Slots, AnUncopyableVectorGrowsAndShrinks) {
  const std::vector<std::vector<double>> stages[] = {{{1}}, {{2, 3}, {}, {4}}, {}, {{5}, {6, 7}}};
  std::vector<Shelf> loaded;
  for (const auto& numbers : stages) {
    BoundedList<ShelfSlot, 3> slot;
    ASSERT_TRUE(store(shelvesOf(numbers), slot));
    load(slot, loaded);
    EXPECT_EQ(numbersOf(loaded), numbers);
  }
}

TEST(Slots, RoomForUncopyableValuesIsNoError) {
  std::vector<Shelf> value = shelvesOf({{1}});
  reserveFor<BoundedList<ShelfSlot, 3>>(value);
  EXPECT_EQ(numbersOf(value), (std::vector<std::vector<double>>{{1}}));
}

}  // namespace
}  // namespace suture
