#include "rt/scenarios/store.h"

#include <utility>

namespace scenarios {

PosePrm recordOf(double x, const std::string& frame) {
  PosePrm record;
  record.moving_frame = frame;
  record.position.translation().x() = x;
  return record;
}

bool same(const PosePrm& a, const PosePrm& b) {
  return a.moving_frame == b.moving_frame && a.position.isApprox(b.position, 0);
}

PosePrm doubled(const PosePrm& value) {
  return recordOf(2 * value.position.translation().x(), value.moving_frame + value.moving_frame);
}

void Store::clear() {
  scalar_ = 0;
  vector_.setZero();
  record_ = {};
  text_.clear();
  emit().cleared();
}

void Store::set_scalar(double value) {
  scalar_ = value;
  emit().scalar_set(value);
}

void Store::set_vector(const Vector& value) {
  vector_ = value;
  emit().vector_set(value);
}

void Store::set_record(const PosePrm& value) {
  record_ = value;
  (void)emit().record_set(value);
}

void Store::set_text(const std::string& value) {
  text_ = value;
  (void)emit().text_set(value);
}

const PosePrm& Store::twice_record(const PosePrm& value) const {
  return twiceRecord_ = doubled(value);
}

const std::string& Store::twice_text(const std::string& value) const {
  return twiceText_ = doubled(value);
}

double Store::swap_scalar(double value) { return std::exchange(scalar_, value); }

Vector Store::swap_vector(const Vector& value) { return std::exchange(vector_, value); }

const PosePrm& Store::swap_record(const PosePrm& value) {
  return oldRecord_ = std::exchange(record_, value);
}

const std::string& Store::swap_text(const std::string& value) {
  return oldText_ = std::exchange(text_, value);
}

}  // namespace scenarios
