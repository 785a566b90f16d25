#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Many {
  int *a, *b, *c, *d, *e, *f, *g, *h, *i, *j, *k, *l, *m, *n, *o, *p, *q, *r, *s, *t, *u, *v;
};
}  // namespace demo
