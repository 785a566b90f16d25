// This defines what shapes/classes.h declares for a class that suturec cannot look into.

#include "shapes/classes.h"

shapes::Point suture::Wire<shapes::Polar>::to(const shapes::Polar& value) {
  shapes::Point form;
  form.x = value.radius();
  form.y = value.angle();
  return form;
}

shapes::Polar suture::Wire<shapes::Polar>::from(const shapes::Point& form) {
  return {form.x, form.y};
}
