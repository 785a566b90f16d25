#pragma once
#include <demo/arm.suture.h>
#include <suture/annotate.h>
#include <suture/component/component.h>
namespace demo {
const char* const kSlave = "Slave";
inline constexpr std::string_view kMaster = "Master";
inline constexpr char kCamera[] = "Camera";
extern const char* const kElsewhere;
suture::Required<Empty> made(suture::Component& owner, const char* name);
class SUTURE_COMPONENT() Client : public suture::Task {
 public:
  explicit Client() : listed_(*this, "Listed") {}

 private:
  bool left_ = true;
  SUTURE_REQUIRED(optional()) suture::Required<Empty> slave_{*this, kSlave};
  SUTURE_REQUIRED(optional()) suture::Required<Empty> master_ = {*this, kMaster};
  SUTURE_REQUIRED(optional()) suture::Required<Empty> camera_ = suture::Required<Empty>(*this, kCamera);
  SUTURE_REQUIRED(optional(), max_age(10ms)) suture::Required<Empty> listed_;
  SUTURE_REQUIRED(max_age(10ms)) suture::Required<Empty> either_{*this, left_ ? "Left" : "Right"};
  SUTURE_REQUIRED(optional()) suture::Required<Empty> extern_{*this, kElsewhere};
  SUTURE_REQUIRED(optional()) suture::Required<Empty> made_ = made(*this, "Made");
  static constexpr std::string_view kOwn = "Own";
  SUTURE_REQUIRED(optional()) suture::Required<Empty> own_{*this, kOwn};
  suture::Required<Empty> silent_{*this, kElsewhere};
};
class SUTURE_COMPONENT(max_age(10ms)) Other : public suture::Task {
  suture::Required<Empty> extern_{*this, kElsewhere};
  suture::Provided<Empty> provided_{*this, kElsewhere, made_};
  suture::Required<Empty> again_{*this, kSlave};
  suture::Required<Empty> twice_{*this, "Slave"};
  Empty made_;
};
}  // namespace demo
