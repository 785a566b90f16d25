#include <gtest/gtest.h>
#include <suture/codec/wire.h>

namespace suture::codec {
namespace {

// capnp's empty blob has no address at all, which memcpy() must not be given: UBSan tells.
TEST(Wire, EmptyTextAndEmptyBytesAreRead) {
  BoundedText<4> text{.size = 1, .data = "x"};
  EXPECT_EQ(fromWire(capnp::Text::Reader(), text), Errc{});
  EXPECT_EQ(text.size, 0u);
  BoundedList<std::uint8_t, 4> bytes{.size = 1, .data = {7}};
  EXPECT_EQ(fromWire(capnp::Data::Reader(), bytes), Errc{});
  EXPECT_EQ(bytes.size, 0u);
}

}  // namespace
}  // namespace suture::codec
