// These send Eigen types of all kinds through generated code.

#include "round_trip.h"
#include "shapes/containers.capnp.h"
#include "shapes/containers.suture.h"

namespace shapes {

void toWire(const MatricesSlot& slot, wire::Matrices::Builder out);
Errc fromWire(wire::Matrices::Reader in, MatricesSlot& slot, suture::Duration shift);
bool isValid(const MatricesSlot& slot, suture::FieldPath* path = nullptr);

namespace {

using Trip = RoundTrip<Matrices, MatricesSlot, wire::Matrices>;

Matrices full() {
  Matrices value;
  value.joints = Eigen::Vector4d(1, -0.0, kDenormal, 4);
  value.row = Eigen::RowVector2d(5, 6);
  value.any.resize(2, 3);
  value.any << 1, 2, 3, 4, 5, 6;
  value.counts.resize(1, 2);
  value.counts << -1, 7;
  value.columns.resize(3, 2);
  value.columns << 1, 2, 3, 4, 5, 6;
  value.limited = Eigen::Matrix<float, 5, 1>::Constant(0.5f);
  for (int i = 0; i < 20; ++i) value.fixed(i % 4, i / 4) = 0.1 * i;
  value.cloud = {{1, 2, 3}, {4, 5, 6}};
  value.wrenches = {Eigen::Matrix<float, 6, 1>::Ones()};
  value.scaled = Eigen::Translation3d(1, 2, 3) * Eigen::Scaling(0.0, 2.0, 3.0);
  value.wait = std::chrono::duration<double, std::milli>(0.1);
  return value;
}

void expectEqual(const Matrices& a, const Matrices& b) {
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.row, b.row);
  EXPECT_EQ(a.any, b.any);
  EXPECT_EQ(a.counts, b.counts);
  EXPECT_EQ(a.columns, b.columns);
  EXPECT_EQ(a.limited, b.limited);
  EXPECT_EQ(a.fixed, b.fixed);
  EXPECT_EQ(a.cloud, b.cloud);
  EXPECT_EQ(a.wrenches, b.wrenches);
  EXPECT_EQ(a.scaled.matrix(), b.scaled.matrix());
  EXPECT_EQ(a.wait, b.wait);
}

TEST(Matrices, FullOnesArrive) {
  Trip trip;
  Matrices received;
  trip.carry(full(), received);
  expectEqual(received, full());
  EXPECT_TRUE(std::signbit(received.joints[1]));
  EXPECT_TRUE(isValid(*trip.slot));
}

TEST(Matrices, EmptyOnesReplaceWhatWasThere) {
  Trip trip;
  Matrices received = full();
  trip.carry(Matrices{}, received);
  EXPECT_EQ(received.joints.size(), 0);
  EXPECT_EQ(received.any.size(), 0);
  EXPECT_EQ(received.columns.cols(), 0);
  EXPECT_TRUE(received.cloud.empty());
}

TEST(Matrices, VectorsTravelFlat) {
  Trip trip;
  auto sent = trip.send(full());
  ASSERT_EQ(sent.getCloud().size(), 6u);
  EXPECT_EQ(sent.getCloud()[4], 5);
  sent.initCloud(5);
  EXPECT_EQ(trip.receive(), Errc::Invalid);
  sent.initCloud(12);
  EXPECT_EQ(trip.receive(), Errc::TooLarge);
}

TEST(Matrices, OneBeyondCapacityDoesNotFit) {
  const auto fits = [](auto change) {
    Matrices value = full();
    change(value);
    return Trip().fits(value);
  };
  EXPECT_FALSE(fits([](Matrices& value) { value.joints.setZero(5); }));
  EXPECT_FALSE(fits([](Matrices& value) { value.row.setZero(4); }));
  EXPECT_FALSE(fits([](Matrices& value) { value.any.setZero(3, 1); }));
  EXPECT_FALSE(fits([](Matrices& value) { value.any.setZero(1, 4); }));
  EXPECT_TRUE(fits([](Matrices& value) { value.columns.setZero(3, 4); }));
  EXPECT_FALSE(fits([](Matrices& value) { value.columns.setZero(3, 5); }));
  EXPECT_FALSE(fits([](Matrices& value) { value.cloud.resize(4); }));
}

TEST(Matrices, ExtentsThatContradictTheDataAreRefused) {
  Trip trip;
  auto any = trip.send(full()).getAny();
  any.setRows(1);
  EXPECT_EQ(trip.receive(), Errc::Invalid);
  any.setRows(3);
  EXPECT_EQ(trip.receive(), Errc::TooLarge);
}

TEST(Matrices, VectorsNameTheWrongCoefficientMatricesThemselves) {
  const auto refused = [](auto change) {
    Matrices value = full();
    change(value);
    return Trip().refused(value);
  };
  EXPECT_EQ(refused([](Matrices&) {}), "");
  EXPECT_EQ(refused([](Matrices& value) { value.joints[3] = kNaN; }), "joints[3]");
  EXPECT_EQ(refused([](Matrices& value) { value.any(1, 2) = kNaN; }), "any");
  EXPECT_EQ(refused([](Matrices& value) { value.fixed(3, 4) = kNaN; }), "fixed");
  EXPECT_EQ(refused([](Matrices& value) { value.columns(2, 1) = kNaN; }), "columns[1][2]");
  EXPECT_EQ(refused([](Matrices& value) { value.cloud[1].z() = kNaN; }), "cloud[1][2]");
  EXPECT_EQ(refused([](Matrices& value) { value.scaled(0, 3) = kNaN; }), "scaled");
  EXPECT_EQ(refused([](Matrices& value) {
              value.wait = std::chrono::duration<double, std::milli>(kNaN);
            }),
            "wait");
}

}  // namespace
}  // namespace shapes
