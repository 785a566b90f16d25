#pragma once
// Both ends of a scenario serve this.

#include <string>

#include "rt/scenarios/all_kinds.suture.h"

namespace scenarios {

using Served = suture::Provided<AllKinds>;
using Used = suture::Required<AllKinds>;
using robots::PosePrm;
using Vector = Eigen::Vector3d;

PosePrm recordOf(double x, const std::string& frame);

inline bool same(double a, double b) { return a == b; }
inline bool same(const Vector& a, const Vector& b) { return a == b; }
inline bool same(const std::string& a, const std::string& b) { return a == b; }
bool same(const PosePrm& a, const PosePrm& b);

inline double doubled(double value) { return 2 * value; }
inline Vector doubled(const Vector& value) { return 2 * value; }
inline std::string doubled(const std::string& value) { return value + value; }
PosePrm doubled(const PosePrm& value);

/// The thread that the runtime calls it in has it alone. Keeps a value of each prototype.
class Store : public AllKinds {
 public:
  void clear() override;
  void set_scalar(double value) override;
  void set_vector(const Vector& value) override;
  void set_record(const PosePrm& value) override;
  void set_text(const std::string& value) override;
  double scalar() const override { return scalar_; }
  Vector vector() const override { return vector_; }
  const PosePrm& record() const override { return record_; }
  const std::string& text() const override { return text_; }
  double twice_scalar(double value) const override { return doubled(value); }
  Vector twice_vector(const Vector& value) const override { return doubled(value); }
  const PosePrm& twice_record(const PosePrm& value) const override;
  const std::string& twice_text(const std::string& value) const override;
  double take_scalar() override { return swap_scalar(0); }
  Vector take_vector() override { return swap_vector(Vector::Zero()); }
  const PosePrm& take_record() override { return swap_record({}); }
  const std::string& take_text() override { return swap_text({}); }
  double swap_scalar(double value) override;
  Vector swap_vector(const Vector& value) override;
  const PosePrm& swap_record(const PosePrm& value) override;
  const std::string& swap_text(const std::string& value) override;

 protected:
  virtual Served::Events& emit() = 0;

 private:
  double scalar_ = 0;
  Vector vector_ = Vector::Zero();
  PosePrm record_, oldRecord_;
  std::string text_, oldText_;
  mutable PosePrm twiceRecord_;
  mutable std::string twiceText_;
};

}  // namespace scenarios
