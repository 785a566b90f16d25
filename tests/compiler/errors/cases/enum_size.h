#pragma once
#include <suture/annotate.h>
namespace demo {
#define TEN(x) x##0, x##1, x##2, x##3, x##4, x##5, x##6, x##7, x##8, x##9
#define HUNDRED(x) TEN(x##0), TEN(x##1), TEN(x##2), TEN(x##3), TEN(x##4), TEN(x##5), TEN(x##6), TEN(x##7), TEN(x##8), TEN(x##9)
#define THOUSAND(x) HUNDRED(x##0), HUNDRED(x##1), HUNDRED(x##2), HUNDRED(x##3), HUNDRED(x##4), HUNDRED(x##5), HUNDRED(x##6), HUNDRED(x##7), HUNDRED(x##8), HUNDRED(x##9)
#define MANY(x) THOUSAND(x##0), THOUSAND(x##1), THOUSAND(x##2), THOUSAND(x##3), THOUSAND(x##4), THOUSAND(x##5), THOUSAND(x##6), THOUSAND(x##7), THOUSAND(x##8), THOUSAND(x##9)
enum class SUTURE_TYPE() Large { MANY(a), MANY(b), MANY(c), MANY(d), MANY(e), MANY(f), MANY(g) };
}  // namespace demo
