#pragma once
#include <demo/arm.h>
#include <suture/annotate.h>
#include <suture/component/component.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
namespace demo {
struct SUTURE_TYPE() Parameters {
  int x = 0;
};
struct SUTURE_TYPE() Options {
  int x = 0;
};
class SUTURE_COMPONENT() Nothing {};
class SUTURE_COMPONENT() Unmade : public suture::EventTask {
 public:
  explicit Unmade(int number);
};
class SUTURE_COMPONENT() Ambiguous : public suture::Device {
 public:
  explicit Ambiguous(const Parameters& parameters);
  explicit Ambiguous(const Options& options);
};
class SUTURE_COMPONENT() Half : public suture::Task, public Arm {};
class SUTURE_COMPONENT() Wrong : public suture::Task {
  suture::Required<Parameters> arm_{*this, "Arm"};
};
}  // namespace demo
