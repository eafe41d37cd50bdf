// SPDX-License-Identifier: MIT
// The same by Boost's odeint: runge_kutta4, member by member, the drive's cosine in each stage.
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <cstdio>
#include <ctime>

using state = std::array<double, 2>;

int main() {
   const int members = 512, steps = 256, periods = 5;
   const double nu = 2.0 / 3.0, h = 2 * M_PI / nu / steps;
   boost::numeric::odeint::runge_kutta4<state> stepper;
   double least = 1e9, sum = 0;
   for (int run = 0; run < 5; ++run) {
      const std::clock_t start = std::clock();
      for (int i = 1; i <= members; ++i) {
         const double g = 1 + 0.001 * i;
         state x{0.1, 0.0};
         auto rates = [=](const state &y, state &rate, double t) {
            rate[0] = y[1];
            rate[1] = -0.5 * y[1] - std::sin(y[0]) + g * std::cos(nu * t);
         };
         for (int k = 0; k < steps * periods; ++k) stepper.do_step(rates, x, k * h, h);
         sum += x[0];
      }
      least = std::fmin(least, 1e9 * double(std::clock() - start) / CLOCKS_PER_SEC / (double(members) * steps * periods));
   }
   std::printf("%8.2f\n", least);
   return std::isfinite(sum) ? 0 : 1;
}
