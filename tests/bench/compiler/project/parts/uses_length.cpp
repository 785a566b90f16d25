#include "parts/length.h"
