// These send blocks of bytes through generated code.

#include "round_trip.h"
#include "shapes/bulk.capnp.h"
#include "shapes/bulk.suture.h"

namespace shapes {

void toWire(const BulkSlot& slot, wire::Bulk::Builder out);
Errc fromWire(wire::Bulk::Reader in, BulkSlot& slot, suture::Duration shift);
bool isValid(const BulkSlot& slot, suture::FieldPath* path = nullptr);

namespace {

using Trip = RoundTrip<Bulk, BulkSlot, wire::Bulk>;

Bulk full() {
  Bulk value;
  value.samples = {1, -0.0, kDenormal, 4, 5, 6};
  value.triple = {-1, 2, 3};
  value.bytes = {0, 255};
  value.line = Eigen::Vector3f(1, 2, 3);
  for (int i = 0; i < 42; ++i) value.jacobian(i % 6, i / 6) = 0.5 * i;
  value.image = Eigen::MatrixXd::Constant(2, 4, 7);
  return value;
}

TEST(Bulk, ArrivesToTheBit) {
  Trip trip;
  Bulk received;
  trip.carry(full(), received);
  EXPECT_EQ(received.samples, full().samples);
  EXPECT_TRUE(std::signbit(received.samples[1]));
  EXPECT_EQ(received.triple, full().triple);
  EXPECT_EQ(received.bytes, full().bytes);
  EXPECT_EQ(received.line, full().line);
  EXPECT_EQ(received.jacobian, full().jacobian);
  EXPECT_EQ(received.image, full().image);
  EXPECT_TRUE(isValid(*trip.slot));
}

TEST(Bulk, IsOneBlockOfLittleEndianBytes) {
  Trip trip;
  const auto sent = trip.send(full()).asReader();
  EXPECT_EQ(sent.getSamples().size(), 6 * sizeof(double));
  EXPECT_EQ(sent.getTriple().size(), 3 * sizeof(std::int16_t));
  EXPECT_EQ(sent.getTriple()[2], 2);
  EXPECT_EQ(sent.getTriple()[3], 0);
  EXPECT_EQ(sent.getImage().getData().size(), 8 * sizeof(double));
}

TEST(Bulk, CutOrTooLongBytesAreRefused) {
  Trip trip;
  trip.send(full()).initSamples(6 * sizeof(double) - 1);
  EXPECT_EQ(trip.receive(), Errc::Invalid);
  trip.send(full()).initSamples(7 * sizeof(double));
  EXPECT_EQ(trip.receive(), Errc::TooLarge);
  trip.send(full()).initTriple(4);
  EXPECT_EQ(trip.receive(), Errc::Invalid);
  trip.send(full()).getImage().initData(9);
  EXPECT_EQ(trip.receive(), Errc::Invalid);
}

TEST(Bulk, AnEmptyMatrixMayHaveNoBlock) {
  Trip trip;
  auto image = trip.send(full()).getImage();
  image.setRows(0);
  image.disownData();
  EXPECT_EQ(trip.receive(), Errc{});
}

TEST(Bulk, NumbersAreJudgedLikeOthers) {
  Trip trip;
  Bulk value = full();
  value.samples[3] = kNaN;
  EXPECT_EQ(trip.refused(value), "samples[3]");
  value = full();
  value.triple[0] = 6;
  EXPECT_EQ(trip.refused(value), "triple[0]");
}

}  // namespace
}  // namespace shapes
