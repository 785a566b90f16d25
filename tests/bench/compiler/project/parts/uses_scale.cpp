#include "parts/scale.suture.h"
