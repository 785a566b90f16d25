// The words of a foreign name run together in the name of its slot, and a nested type has the name of another.
#pragma once
#include <suture/annotate.h>

namespace arm {
struct Tip { double x = 0; };
enum class Side { Left, Right };
}  // namespace arm

namespace ar {
struct mTip { double x = 0; };
enum class mSide { Left, Right };
}  // namespace ar

namespace cases {

SUTURE_EXTERNAL_TYPE(arm::Tip, all());
SUTURE_EXTERNAL_TYPE(ar::mTip, all());
SUTURE_EXTERNAL_TYPE(arm::Side);
SUTURE_EXTERNAL_TYPE(ar::mSide);

}  // namespace cases
