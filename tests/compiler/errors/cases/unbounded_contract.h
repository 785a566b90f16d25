#pragma once
#include <demo/open.suture.h>
#include <suture/annotate.h>
#include <suture/component/component.h>
namespace demo {
class SUTURE_COMPONENT() Speaker : public suture::Device {
  suture::Required<Speech> fine_{*this, "Fine"};
};
class SUTURE_COMPONENT() Listener : public suture::EventTask {
  suture::Required<Speech> first_{*this, "First"};
  suture::Required<Speech> second_{*this, "Second"};
};
class SUTURE_COMPONENT() Robot : public suture::EventTask, public Speech {
 public:
  void move(const std::vector<Joints>& path) override;
  void say(const std::string& text) override;
  const Joints& measured() const override;

 private:
  suture::Provided<Speech> speech_{*this, "Speech", *this};
};
}  // namespace demo
