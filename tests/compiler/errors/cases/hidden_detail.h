#pragma once
#include <suture/annotate.h>
#include <suture/component/component.h>
namespace detail {
class SUTURE_COMPONENT() Arm : public suture::EventTask {};
}  // namespace detail
