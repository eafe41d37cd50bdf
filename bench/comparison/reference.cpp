// SPDX-License-Identifier: MIT
// The cascade by Taylor series of order 30 in 80-bit arithmetic, 64 of them to a period: TRANSIENT KEPT OFFSET,
// the offset is added to the angle at the start.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using real = long double;
constexpr int order = 30, steps = 64;
const real pi = std::acos(-1.0L), b = 0.5L, w = 2.0 / 3, h = 2 * pi / w / steps;

// x' = v, v' = -b v - s + g c, s = sin x, c = cos x; wave = cos w t, other = sin w t
void step(real g, int at, real &angle, real &rate) {
   real x[order + 1], v[order + 1], s[order + 1], c[order + 1], wave[order + 1], other[order + 1];
   x[0] = angle, v[0] = rate, s[0] = std::sin(angle), c[0] = std::cos(angle);
   wave[0] = std::cos(2 * pi * at / steps), other[0] = std::sin(2 * pi * at / steps);
   for (int n = 0; n < order; ++n) {
      real sine = 0, cosine = 0;
      x[n + 1] = v[n] / (n + 1);
      v[n + 1] = (g * wave[n] - b * v[n] - s[n]) / (n + 1);
      for (int k = 0; k <= n; ++k) sine += (k + 1) * x[k + 1] * c[n - k], cosine -= (k + 1) * x[k + 1] * s[n - k];
      s[n + 1] = sine / (n + 1), c[n + 1] = cosine / (n + 1);
      wave[n + 1] = -w * other[n] / (n + 1), other[n + 1] = w * wave[n] / (n + 1);
   }
   angle = rate = 0;
   for (int n = order; n >= 0; --n) angle = angle * h + x[n], rate = rate * h + v[n];
}

int main(int, char **word) {
   const int transient = std::atoi(word[1]), kept = std::atoi(word[2]);
   std::vector<double> drives;
   for (double g; std::scanf("%lf", &g) == 1;) drives.push_back(g);
   std::vector<real> points(drives.size() * kept * 2);
#pragma omp parallel for schedule(dynamic)
   for (std::size_t i = 0; i < drives.size(); ++i) {
      real angle = -pi / 2 + std::atof(word[3]), rate = 0;
      for (int n = 0; n < transient + kept; ++n) {
         for (int at = 0; at < steps; ++at) step(drives[i], at, angle, rate);
         angle = std::remainder(angle, 2 * pi);
         if (n < transient) continue;
         points[2 * (i * kept + n - transient)] = angle;
         points[2 * (i * kept + n - transient) + 1] = rate;
      }
   }
   for (std::size_t i = 0; i < points.size(); i += 2)
      std::printf("%.17g %.21Lg %.21Lg\n", drives[i / 2 / kept], points[i], points[i + 1]);
}
