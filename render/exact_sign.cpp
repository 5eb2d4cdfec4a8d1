#include "render/exact_sign.h"

#include <gmpxx.h>

namespace lumaknot {

int exact_volume_sign(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const auto exact = [](const Vec3d& v) {
    return Vec3<mpq_class>{mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
  };
  const Vec3<mpq_class> p = exact(a), q = exact(b), r = exact(c);
  const mpq_class volume =
      p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
  return sgn(volume);
}

}  // namespace lumaknot
