// These are values of each form that the printers for gdb know; gdb stops in stopHere().

#include <suture/base/sample.h>
#include <suture/base/slots/slots.h>

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <variant>

namespace {

using suture::store;

volatile int reached = 0;
[[gnu::noinline]] void stopHere() { reached = 1; }

}  // namespace

int main() {
  suture::BoundedText<8> text{};
  suture::OpenText openText;
  suture::BoundedList<double, 4> list{};
  suture::OpenList<double> openList;
  bool fits = store(std::string("servo"), text) && store(std::string("any length"), openText);
  fits = fits && store(std::vector{1.5, 2.5}, list) && store(std::vector{3.5}, openList);
  suture::BoundedMatrix<double, 3, 3> matrix{.rows = 2, .columns = 2, .data = {1, 3, 2, 4}};
  const suture::SlotOptional<double> nothing{}, some{.present = 1, .value = 7};
  const suture::SlotTuple<int, double> tuple{.head = 4, .tail = {.head = 0.5}};
  suture::SlotVariant<int, double> variant{};
  fits = fits && store(std::variant<int, double>(2.25), variant);
  const suture::Time stamp{std::chrono::milliseconds(1500)};
  const suture::Sample<double> fresh(0.25, stamp), lost(suture::Errc::Lost);
  const Eigen::Vector3d vector(1, 2, 3);
  Eigen::Matrix2d square;
  square << 1, 2, 3, 4;
  const Eigen::Quaterniond quaternion(1, 0, 0, 0);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  stopHere();
  const bool used = fits && nothing.present == 0 && some.present != 0 && tuple.head == 4 &&
                    fresh.hasValue() && !lost.hasValue() && vector.x() > 0 && square(0, 0) > 0 &&
                    quaternion.w() > 0 && pose(0, 0) > 0 && matrix.rows == 2 && variant.index == 1;
  return used && openText.size > 0 && openList.size > 0 && list.size > 0 && text.size > 0 ? 0 : 1;
}
