#pragma once
#include "../../../../../runtime/annotate.h"
