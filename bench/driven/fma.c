/* SPDX-License-Identifier: MIT */
/* How many multiply-adds a nanosecond this core does in vectors: ten chains of `LANES` doubles each. */
#include <stdio.h>
#include <time.h>

typedef double vector __attribute__((vector_size(8 * LANES)));

int main(void) {
   const long rounds = 20000000;
   vector x[10], a, b;
   for (int j = 0; j < LANES; ++j) { a[j] = 0.999999; b[j] = 1e-7; }
   for (int i = 0; i < 10; ++i) x[i] = b;
   double least = 1e9;
   for (int run = 0; run < 3; ++run) {
      const clock_t start = clock();
      for (long k = 0; k < rounds; ++k) {
#pragma GCC unroll 10
         for (int i = 0; i < 10; ++i) x[i] = x[i] * a + b;
      }
      const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
      if (seconds < least) least = seconds;
   }
   for (int i = 1; i < 10; ++i) x[0] += x[i];
   printf("%8.2f\n", 10.0 * LANES * rounds / least / 1e9);
   return x[0][0] > 1e9;
}
