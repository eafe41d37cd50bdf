// SPDX-License-Identifier: MIT
// The cascade by Boost's odeint, one orbit after another, threads share them: TRANSIENT KEPT STEPS. STEPPER is
// one of odeint's, whose steps are fixed, or are begun as long as that and changed by it.
#include <array>
#include <boost/numeric/odeint.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace boost::numeric::odeint;
using state = std::array<double, 2>;

int main(int, char **word) {
   const int transient = std::atoi(word[1]), kept = std::atoi(word[2]), steps = std::atoi(word[3]);
   const double b = 0.5, w = 2.0 / 3, period = 2 * M_PI / w;
   std::vector<double> drives;
   for (double g; std::scanf("%lf", &g) == 1;) drives.push_back(g);
   std::vector<state> points(drives.size() * kept);

   const auto start = std::chrono::steady_clock::now();
#pragma omp parallel for schedule(dynamic)
   for (std::size_t i = 0; i < drives.size(); ++i) {
      const double g = drives[i];
      state y{-M_PI / 2, 0};
      auto rates = [=](const state &x, state &rate, double t) {
         rate = {x[1], -b * x[1] - std::sin(x[0]) + g * std::cos(w * t)};
      };
      for (int n = 0; n < transient + kept; ++n) {
         integrate_n_steps(STEPPER, rates, y, 0.0, period / steps, steps);
         y[0] = std::remainder(y[0], 2 * M_PI);
         if (n >= transient) points[i * kept + n - transient] = y;
      }
   }
   const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
   std::fprintf(stderr, "%g\n", took.count());
   for (std::size_t i = 0; i < points.size(); ++i)
      std::printf("%.17g %.17g %.17g\n", drives[i / kept], points[i][0], points[i][1]);
}
