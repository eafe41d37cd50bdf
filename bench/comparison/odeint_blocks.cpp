// SPDX-License-Identifier: MIT
// The cascade by Boost's odeint, 64 members as one system, whose loops become vectors: TRANSIENT KEPT STEPS.
#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace boost::numeric::odeint;
constexpr std::size_t block = 64;
using state = std::array<double, 2 * block>;

int main(int, char **word) {
   const int transient = std::atoi(word[1]), kept = std::atoi(word[2]), steps = std::atoi(word[3]);
   const double b = 0.5, w = 2.0 / 3, period = 2 * M_PI / w;
   std::vector<double> drives;
   for (double g; std::scanf("%lf", &g) == 1;) drives.push_back(g);
   std::vector<std::array<double, 2>> points(drives.size() * kept);

   const auto start = std::chrono::steady_clock::now();
#pragma omp parallel for schedule(dynamic)
   for (std::size_t first = 0; first < drives.size(); first += block) {
      const std::size_t members = std::min(block, drives.size() - first);
      double g[block] = {};
      std::copy_n(&drives[first], members, g);
      state y{};
      std::fill_n(y.begin(), block, -M_PI / 2);
      auto rates = [&](const state &x, state &rate, double t) {
         const double wave = std::cos(w * t);
         for (std::size_t i = 0; i < block; ++i) {
            rate[i] = x[block + i];
            rate[block + i] = -b * x[block + i] - std::sin(x[i]) + g[i] * wave;
         }
      };
      STEPPER stepper;
      for (int n = 0; n < transient + kept; ++n) {
         integrate_n_steps(stepper, rates, y, 0.0, period / steps, steps);
         for (std::size_t i = 0; i < block; ++i) y[i] = std::remainder(y[i], 2 * M_PI);
         for (std::size_t i = 0; i < members && n >= transient; ++i)
            points[(first + i) * kept + n - transient] = {y[i], y[block + i]};
      }
   }
   const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
   std::fprintf(stderr, "%g\n", took.count());
   for (std::size_t i = 0; i < points.size(); ++i)
      std::printf("%.17g %.17g %.17g\n", drives[i / kept], points[i][0], points[i][1]);
}
