/* ---- The mathematics. Metres, seconds, radians; what is in degrees says so. Nothing here knows of the page. ---- */

const degree = Math.PI / 180;

/* The arithmetic-geometric mean of 1 and b: K(k) is pi/2 over that of b = sqrt(1 - k^2). */
function mean(b) {
   let a = 1;
   while (Math.abs(a - b) > 1e-15 * a) [a, b] = [(a + b) / 2, Math.sqrt(a * b)];
   return a;
}

/* Carlson's R_F(x, y, z): duplication (DLMF 19.26.18), then the series about the mean (19.36.1). */
function carlson(x, y, z) {
   let a = (x + y + z) / 3;
   while (Math.max(Math.abs(a - x), Math.abs(a - y), Math.abs(a - z)) > 1e-3 * a) {
      const [p, q, r] = [Math.sqrt(x), Math.sqrt(y), Math.sqrt(z)];
      const product = p * q + q * r + r * p;
      [x, y, z, a] = [x, y, z, a].map((value) => (value + product) / 4);
   }
   const [dx, dy] = [1 - x / a, 1 - y / a];
   const dz = -dx - dy;
   const [e2, e3] = [dx * dy - dz * dz, dx * dy * dz];
   return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / Math.sqrt(a);
}

/* The means of 1 and kc, as jacobi wants them: the first pair last, and before it what they tend to */
function ladder(kc) {
   const pairs = [];
   let [a, b] = [1, kc];
   while (pairs.length === 0 || Math.abs(a - b) > 1e-15 * a) {
      pairs.unshift([a, b]);
      [a, b] = [(a + b) / 2, Math.sqrt(a * b)];
   }
   return { limit: a, pairs };
}

/* sn, cn and dn of u for kc = sqrt(1 - k^2), by Gauss' transformation: cn/sn of the means' limit, then back up
   (Bulirsch 1965). Only sums of positive terms, so that kc may be as small as it likes; |u| is at most K. */
function jacobi(u, { limit, pairs }) {
   if (Math.abs(u) < 1e-8) return { sn: u, cn: 1, dn: 1 };
   let a = limit;
   let y = a / Math.tan(a * u);
   let dn = 1;
   for (const [above, root] of pairs) {
      const w = y * y / a;
      y *= dn;
      dn = (root + w) / (above + w);
      a = above;
   }
   const sn = Math.sign(u) / Math.sqrt(1 + y * y);
   return { sn, cn: y * sn, dn };
}

/* The same for kc = 0, on the separatrix */
function hyperbolic(u) {
   return { sn: Math.tanh(u), cn: 1 / Math.cosh(u), dn: 1 / Math.cosh(u) };
}

/* Numbers of two words, [high, low]: what 1 - k^2 is made of, since next to the separatrix it is a small difference.
   Dekker 1971; a number of one word may stand for its two. */
function exactSum(a, b) {
   const total = a + b;
   const part = total - a;
   return [total, (a - (total - part)) + (b - part)];
}

function exactProduct(a, b) {
   const halves = (x) => {
      const big = 134217729 * x;
      const high = big - (big - x);
      return [high, x - high];
   };
   const [[a1, a2], [b1, b2]] = [halves(a), halves(b)];
   return [a * b, a1 * b1 - a * b + a1 * b2 + a2 * b1 + a2 * b2];
}

function plus([a, low], [b, lower]) {
   const [total, rest] = exactSum(a, b);
   return exactSum(total, rest + (low + lower));
}

function times([a, low], [b, lower]) {
   const [product, rest] = exactProduct(a, b);
   return exactSum(product, rest + (a * lower + low * b));
}

function dividedBy([a, low], b) {
   const quotient = a / b;
   const [product, rest] = exactProduct(quotient, b);
   return exactSum(quotient, (a - product - rest + low) / b);
}

/* sin^2 of half an angle of at most 90 degrees, by the sine's series */
function squaredSine(degrees) {
   const x = dividedBy(times(degrees, [Math.PI, 1.2246467991473532e-16]), 360);
   const square = times(x, x);
   let series = [1, 0];
   for (let n = 13; n > 0; n--) {
      const [a, b] = dividedBy(times(square, series), 2 * n * (2 * n + 1));
      series = plus([1, 0], [-a, -b]);
   }
   const sine = times(x, series);
   return times(sine, sine);
}

/* Of half an angle in degrees: whole turns, sine and cosine, and the cosine's square in two words. An angle of seven
   decimals is taken for those decimals, so that 179.999999 is a millionth from the top, and not nearly so. */
function halfAngle(degrees) {
   const turns = Math.round(degrees / 360);
   const rest = Math.abs(degrees - 360 * turns);
   const units = Math.round(1e7 * rest);
   const decimal = units / 1e7 === rest;
   const squared = rest > 90
      ? squaredSine(decimal ? dividedBy([1.8e9 - units, 0], 1e7) : exactSum(180, -rest))
      : plus([1, 0], squaredSine(decimal ? dividedBy([units, 0], 1e7) : [rest, 0]).map((word) => -word));
   return { turns, squared, cosine: Math.sqrt(squared[0]), sine: Math.sin((degrees - 360 * turns) * degree / 2) };
}

/* The exact motion from a start: { release } or { amplitude } (through the bottom, swinging out to it), both in
   degrees, or { angle, rate } in degrees and rad/s. As furiko's `started`: with r = rate/(2 omega),
   k^2 = sin^2(angle/2) + r^2 and 1 - k^2 = cos^2(angle/2) - r^2, each from the state, on both sides of the separatrix.
   DLMF 22.19. */
function exactMotion(start, length, gravity) {
   const omega = Math.sqrt(gravity / length);
   const { turns, sine, cosine, squared } = halfAngle(start.release ?? start.amplitude ?? start.angle);
   const direction = (start.amplitude ?? start.rate) < 0 ? -1 : 1;
   const fromBottom = "amplitude" in start;
   const rate = fromBottom ? 0 : start.rate ?? 0;
   const r = Math.abs(rate) / (2 * omega);
   const k = Math.hypot(sine, r);
   const rr = dividedBy(times(exactProduct(rate, rate), [length, 0]), 4 * gravity);
   const gap = plus(squared, rr.map((word) => -word))[0];
   const shared = { omega, k };
   if (k === 0) return { ...shared, ratio: 1, period: 2 * Math.PI / omega, amplitude: 0,
      regime: "libration", at: () => ({ angle: 2 * Math.PI * turns, rate: 0 }) };
   if (cosine === 0 && r === 0) return { ...shared, ratio: Infinity, period: Infinity, amplitude: 180,
      regime: "separatrix", at: () => ({ angle: start.release * degree, rate: 0 }) };

   const rotates = gap < 0;
   const kc = rotates ? Math.sqrt(-gap) / k : Math.sqrt(gap);
   const quarter = Math.PI / 2 / mean(kc);
   const means = kc === 0 ? null : ladder(kc);
   const pace = direction * omega * (rotates ? k : 1);
   const u0 = fromBottom ? 0 : sine * (rotates ? carlson(cosine ** 2, (r / k) ** 2, 1)
      : carlson(r ** 2, (k * cosine) ** 2, k ** 2));

   function at(time) {
      const u = u0 + pace * time;
      const halves = Math.round(u / (2 * quarter));
      const { sn, cn, dn } = kc === 0 ? hyperbolic(u) : jacobi(u - 2 * quarter * halves, means);
      if (rotates) return { angle: 2 * Math.atan2(sn, cn) + 2 * Math.PI * (turns + halves),
         rate: 2 * pace * dn };
      const sign = halves % 2 === 0 ? 1 : -1;
      return { angle: 2 * Math.atan2(sign * k * sn, dn) + 2 * Math.PI * turns, rate: 2 * k * pace * sign * cn };
   }

   return { ...shared, at,
      regime: rotates ? "rotation" : gap > 0 ? "libration" : "separatrix",
      ratio: rotates ? quarter / (Math.PI * k) : 2 * quarter / Math.PI,
      period: rotates ? 2 * quarter / (k * omega) : 4 * quarter / omega,
      amplitude: rotates ? Infinity : gap > 0 ? 2 * Math.atan2(k, kc) / degree : 180 };
}

/* The small-angle motion from the same angle and rate. */
function smallAngleMotion({ angle, rate }, length, gravity) {
   const omega = Math.sqrt(gravity / length);
   const swing = rate / omega;

   function at(time) {
      const [sine, cosine] = [Math.sin(omega * time), Math.cos(omega * time)];
      return { angle: angle * cosine + swing * sine, rate: omega * (swing * cosine - angle * sine) };
   }

   return { omega, ratio: 1, period: 2 * Math.PI / omega, amplitude: Math.hypot(angle, swing) / degree, at };
}

/* angle'' = -(g/l) sin(angle) - linear angle' + drive cos(frequency t), from the same angle and rate, for which
   there is no formula: by the Runge-Kutta method, 200 steps a small swing, the last one shortened. */
function steppedMotion({ angle, rate }, length, gravity, forces) {
   const step = 2 * Math.PI * Math.sqrt(length / gravity) / 200;
   const { linear, drive, "drive-frequency": frequency } = forces;
   const path = [[angle, rate]];

   function slope(time, x, v) {
      return [v, -gravity / length * Math.sin(x) - linear * v + drive * Math.cos(frequency * time)];
   }

   function advanced([x, v], time, h) {
      const [a1, b1] = slope(time, x, v);
      const [a2, b2] = slope(time + h / 2, x + h / 2 * a1, v + h / 2 * b1);
      const [a3, b3] = slope(time + h / 2, x + h / 2 * a2, v + h / 2 * b2);
      const [a4, b4] = slope(time + h, x + h * a3, v + h * b3);
      return [x + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), v + h / 6 * (b1 + 2 * b2 + 2 * b3 + b4)];
   }

   function at(time) {
      const whole = Math.floor(time / step);
      for (let n = path.length; n <= whole; n++) path.push(advanced(path[n - 1], (n - 1) * step, step));
      const [x, v] = advanced(path[whole], whole * step, time - whole * step);
      return { angle: x, rate: v };
   }

   return { at };
}

/* Kinetic, potential and total energy of a true pendulum over m l^2, from the height of its pivot, as
   `furiko motion` has it. */
function energies({ angle, rate }, length, gravity) {
   const [kinetic, potential] = [rate ** 2 / 2, -gravity / length * Math.cos(angle)];
   return { kinetic, potential, total: kinetic + potential };
}

/* An angle brought to -pi ... pi */
function wrapped(angle) {
   return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}
