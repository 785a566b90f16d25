#pragma once
#include "../../../../../runtime/suture/annotate.h"
