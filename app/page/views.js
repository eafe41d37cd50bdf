/* ---- The pictures and the readings: each view draws what is, and nothing else ---- */

const colours = {};
const spots = {};
const stillness = window.matchMedia("(prefers-reduced-motion: reduce)");
let lastReadings = 0;
let face = "sans-serif";

function readColours() {
   const style = getComputedStyle(document.documentElement);
   for (const name of ["panel", "ink", "muted", "line", "first", "second"]) {
      colours[name] = style.getPropertyValue("--" + name).trim();
   }
   colours.pair = [colours.first, colours.second];
   face = getComputedStyle(document.body).fontFamily;
   changed = true;
}

/* A clean sheet of CSS pixels */
function sheet(id) {
   const canvas = find(id).querySelector("canvas");
   const [width, height] = [canvas.clientWidth, canvas.clientHeight];
   const scale = window.devicePixelRatio;
   if (canvas.width !== Math.round(width * scale)) canvas.width = Math.round(width * scale);
   if (canvas.height !== Math.round(height * scale)) canvas.height = Math.round(height * scale);
   const pen = canvas.getContext("2d");
   pen.setTransform(scale, 0, 0, scale, 0, 0);
   pen.clearRect(0, 0, width, height);
   pen.font = `12px ${face}`;
   pen.lineJoin = "bevel";
   pen.textBaseline = "alphabetic";
   return { pen, width, height };
}

function stroke(pen, colour, width, alpha = 1) {
   pen.globalAlpha = alpha;
   pen.strokeStyle = colour;
   pen.lineWidth = width;
   pen.stroke();
   pen.globalAlpha = 1;
}

function line(pen, ...points) {
   pen.beginPath();
   for (const [x, y] of points) pen.lineTo(x, y);
}

/* A disc for the exact pendulum, a square for the one beside it */
function mark(pen, i, x, y, size) {
   pen.beginPath();
   if (i === 0) pen.arc(x, y, size, 0, 2 * Math.PI);
   else pen.rect(x - 0.9 * size, y - 0.9 * size, 1.8 * size, 1.8 * size);
   pen.fillStyle = colours.pair[i];
   pen.fill();
   stroke(pen, colours.panel, 1.5);
}

function text(pen, words, x, y, align = "center", colour = colours.muted) {
   pen.textAlign = align;
   pen.fillStyle = colour;
   pen.fillText(words, x, y);
}

/* 1, 2 or 5 times a power of ten: the smallest not below a value */
function roundUp(value) {
   const power = 10 ** Math.floor(Math.log10(value));
   return power * [1, 2, 5, 10].find((digit) => digit * power >= 0.999999 * value);
}

/* A box of a sheet with round ticks; gives back where a point of it lies. */
function axes(pen, box, [left, right], [bottom, top], xStep, yStep) {
   const xOf = (x) => box.x + box.width * (x - left) / (right - left);
   const yOf = (y) => box.y + box.height * (top - y) / (top - bottom);
   const label = (value, unit) => written(value, Math.max(0, -Math.floor(Math.log10(unit) + 1e-9)));
   const ticks = (low, high, unit) => {
      const first = Math.ceil(low / unit - 1e-9);
      return Array.from({ length: Math.floor(high / unit + 1e-9) - first + 1 }, (_, i) => (first + i) * unit);
   };
   pen.beginPath();
   for (const x of ticks(left, right, xStep)) {
      pen.moveTo(xOf(x), box.y);
      pen.lineTo(xOf(x), box.y + box.height);
      text(pen, label(x, xStep), xOf(x), box.y + box.height + 15);
   }
   for (const y of ticks(bottom, top, yStep)) {
      pen.moveTo(box.x, yOf(y));
      pen.lineTo(box.x + box.width, yOf(y));
      text(pen, label(y, yStep), box.x - 6, yOf(y) + 4, "right");
   }
   stroke(pen, colours.line, 1);
   return { xOf, yOf, box };
}

function within(pen, box, draw) {
   pen.save();
   pen.beginPath();
   pen.rect(box.x - 1, box.y - 1, box.width + 2, box.height + 2);
   pen.clip();
   draw();
   pen.restore();
}

/* A pendulum's path from one time to another, through points at multiples of an interval, so that it stands still
   while its window moves; torn where it goes over the top. That of the second is dashed. */
function drawCurve(pen, i, [from, to], interval, alpha, place) {
   const first = Math.ceil(from / interval);
   const count = Math.floor(to / interval) - first + 1;
   let lastTurn = NaN;
   pen.beginPath();
   for (let n = -1; n <= count; n++) {
      const time = n < 0 ? from : n < count ? (first + n) * interval : to;
      const { angle, rate } = pair[i].at(time);
      const turn = Math.round(angle / (2 * Math.PI));
      const [x, y] = place(wrapped(angle), rate, time);
      if (turn !== lastTurn || i === 1 && (first + n) % 6 > 3) pen.moveTo(x, y);
      else pen.lineTo(x, y);
      lastTurn = turn;
   }
   stroke(pen, colours.pair[i], i === 0 ? 2.5 : 2, alpha);
}

/* Behind now it is strong, ahead of now faint. */
function drawPastAndFuture(pen, i, [from, to], interval, place) {
   drawCurve(pen, i, [state.time, to], interval, 0.35, place);
   if (state.time > from) drawCurve(pen, i, [from, state.time], interval, 1, place);
}

function drawStage(motions) {
   const { pen, width, height } = sheet("stage");
   const size = clamp(Math.min(width, height) / 22, [8, 16]);
   const pivot = { x: width / 2, y: height / 2 + 12 };
   const radius = Math.max(1, Math.min(width / 2, height / 2 - 14) - size - 6);
   const end = (angle) => ({ x: pivot.x + radius * Math.sin(angle), y: pivot.y + radius * Math.cos(angle) });
   const reach = Math.min(Math.PI, pair[0].amplitude * degree);
   pen.beginPath();
   pen.arc(pivot.x, pivot.y, radius, Math.PI / 2 - reach, Math.PI / 2 + reach);
   pen.moveTo(pivot.x, pivot.y);
   pen.lineTo(pivot.x, pivot.y + radius);
   stroke(pen, colours.line, 1.5);
   for (const i of [1, 0]) {
      const bob = end(motions[i].angle);
      pen.setLineDash(i === 0 ? [] : [5, 4]);
      line(pen, [pivot.x, pivot.y], [bob.x, bob.y]);
      stroke(pen, i === 0 ? colours.ink : colours.second, i === 0 ? 2.5 : 1.5);
      pen.setLineDash([]);
      mark(pen, i, bob.x, bob.y, i === 0 ? size : 0.8 * size);
      mark(pen, i, 8, 11 + 18 * i, 5);
      text(pen, pair[i].name, 20, 15 + 18 * i, "left", colours.ink);
   }
   pen.fillStyle = colours.ink;
   pen.fillRect(pivot.x - 4, pivot.y - 4, 8, 8);
   drawScale(pen, width, height - 4, radius / state.length);
   Object.assign(spots, { pivot, bob: end(motions[0].angle), beside: end(motions[1].angle) });
}

/* How long a metre, or a round part of it, is in the picture */
function drawScale(pen, right, bottom, metre) {
   const length = roundUp(24 / metre);
   const [from, to] = [right - 8 - length * metre, right - 8];
   line(pen, [from, bottom - 5], [from, bottom], [to, bottom], [to, bottom - 5]);
   stroke(pen, colours.muted, 1.5);
   text(pen, length < 1 ? (100 * length).toFixed(0) + " cm" : length + " m", to, bottom - 9, "right");
}

function drawEnergy(motions) {
   const { pen, width, height } = sheet("energy");
   const unit = state.gravity / state.length;
   const box = { x: 0, y: 6, width, height: height - 28 };
   const top = Math.max(1, 2 * pair[0].k ** 2) * 1.05;
   const yOf = (value) => box.y + box.height * (top - clamp(value / unit, [-1.05, top])) / (top + 1.05);
   const bars = motions.map((motion) => energies(motion, state.length, state.gravity));
   ["kinetic", "potential", "total"].forEach((name, n) => {
      const middle = (n + 0.5) * width / 3;
      bars.forEach((energy, i) => {
         pen.fillStyle = colours.pair[i];
         pen.fillRect(middle + (i - 1) * 13 + 1, Math.min(yOf(0), yOf(energy[name])), 11,
            Math.max(1, Math.abs(yOf(energy[name]) - yOf(0))));
      });
      text(pen, say(name), middle, height - 5);
   });
   line(pen, [0, yOf(0)], [width, yOf(0)]);
   stroke(pen, colours.muted, 1);
}

/* The widest swing on show, as a round number of degrees; beyond 180 angles are wrapped. */
function widest() {
   const far = state.compare === "driven" && state.drive > 0 ? 180 : 0;
   const most = Math.max(far, ...pair.map(({ amplitude }) => Math.min(180, amplitude ?? 0)));
   return [1, 2, 4, 10, 20, 40, 60, 90, 120, 180].find((limit) => limit >= most - 1e-9);
}

function drawTrace(motions) {
   const { pen, width, height } = sheet("trace");
   const span = roundUp(16 * Math.PI / pair[0].omega);
   const from = Math.max(0, state.time - 0.6 * span);
   const limit = widest();
   const { xOf, yOf, box } = axes(pen, { x: 40, y: 8, width: width - 52, height: height - 30 }, [from, from + span],
      [-1.08 * limit, 1.08 * limit], span / (width < 500 ? 5 : 10), limit / 2);
   within(pen, box, () => {
      for (const i of [1, 0]) drawPastAndFuture(pen, i, [from, from + span], span / 640,
         (angle, rate, time) => [xOf(time), yOf(angle / degree)]);
   });
   for (const i of [1, 0]) mark(pen, i, xOf(state.time), yOf(wrapped(motions[i].angle) / degree), 6);
}

/* The period's curve, once for all: amplitude in degrees and T/T_h */
const periodCurve = Array.from({ length: 270 }, (_, n) => n < 170 ? n : 170 + (n - 170) / 10).map((amplitude) =>
   [amplitude, 1 / mean(halfAngle(amplitude).cosine)]);

function drawPeriod() {
   const { pen, width, height } = sheet("period");
   const box = { x: 30, y: 8, width: width - 44, height: height - 30 };
   const top = 5.5;
   const plots = [
      { ...axes(pen, box, [0, 180], [0.6, top], width < 340 ? 60 : 30, 1), most: 180, high: top },
      { ...axes(pen, { x: box.x + 44, y: box.y + 8, width: 0.5 * box.width - 30, height: 0.5 * box.height }, [0, 90],
         [0.95, 1.2], 30, 0.1), most: 90, high: 1.2 },
   ];
   for (const { xOf, yOf, box: inner, most, high } of plots) {
      within(pen, inner, () => {
         line(pen, [xOf(0), yOf(1)], [xOf(most), yOf(1)]);
         pen.setLineDash([5, 4]);
         stroke(pen, colours.second, 2);
         pen.setLineDash([]);
         line(pen, ...periodCurve.map(([x, y]) => [xOf(x), yOf(y)]));
         stroke(pen, colours.first, 2.5);
      });
      pair.forEach(({ amplitude, ratio }, i) => {
         const drawn = amplitude <= most && ratio <= high && (i === 0 || state.compare === "other");
         if (drawn) mark(pen, i, xOf(amplitude), yOf(ratio), 6);
      });
   }
   const [main, inset] = plots;
   const three = [inset.xOf(39.159), inset.yOf(1.03)];
   line(pen, [three[0], inset.yOf(0.95)], three, [inset.xOf(0), three[1]]);
   stroke(pen, colours.muted, 1);
   text(pen, say("threePercent"), inset.xOf(0) + 4, three[1] - 4, "left", colours.ink);
   text(pen, "39.2°", three[0] + 4, inset.yOf(0.95) - 4, "left", colours.ink);
   text(pen, say("smallLine"), main.xOf(2), main.yOf(1) + 14, "left", colours.ink);
   const { amplitude, ratio } = pair[0];
   const swings = Number.isFinite(amplitude);
   spots.dot = { x: main.xOf(Math.min(180, amplitude)), y: main.yOf(swings ? Math.min(ratio, top) : top) };
   if (!swings || ratio > top) {
      pen.beginPath();
      pen.arc(spots.dot.x, spots.dot.y, 6, 0, 2 * Math.PI);
      stroke(pen, colours.first, 2);
   }
   spots.amplitudeAt = (x) => clamp(180 * (x - main.box.x) / main.box.width, [0, 179.9]);
}

function drawPhase(motions) {
   const { pen, width, height } = sheet("phase");
   const { omega, k, period, regime } = pair[0];
   const most = regime === "rotation" ? 360 : 180;
   const fastest = omega * Math.max(2.3, 2.2 * k);
   const { xOf, yOf, box } = axes(pen, { x: 40, y: 8, width: width - 52, height: height - 30 }, [-most, most],
      [-fastest, fastest], most / (width < 340 ? 2 : 4), roundUp(fastest / 4));
   within(pen, box, () => {
      drawFlow(pen, xOf, yOf, most, fastest, omega);
      for (const side of [1, -1]) {
         line(pen, ...Array.from({ length: 241 }, (_, n) => most * (n / 120 - 1)).map((angle) =>
            [xOf(angle), yOf(side * 2 * omega * Math.abs(Math.cos(angle * degree / 2)))]));
         stroke(pen, colours.muted, 2);
      }
      const once = Math.min(period, 20 * Math.PI / omega);
      for (const i of [1, 0]) drawPastAndFuture(pen, i, [Math.max(0, state.time - once), state.time + once], once / 320,
         (angle, rate) => [xOf(angle / degree), yOf(rate)]);
   });
   drawFixedPoints(pen, xOf, yOf, most);
   for (const i of [1, 0]) mark(pen, i, xOf(wrapped(motions[i].angle) / degree), clamp(yOf(motions[i].rate),
      [box.y, box.y + box.height]), 6);
   spots.point = { x: xOf(wrapped(motions[0].angle) / degree), y: yOf(motions[0].rate) };
   spots.stateAt = (x, y) => [most * (2 * (x - box.x) / box.width - 1), fastest * (1 - 2 * (y - box.y) / box.height)];
}

/* Short arrows along the motion of the exact pendulum */
function drawFlow(pen, xOf, yOf, most, fastest, omega) {
   pen.beginPath();
   for (let n = -6; n < 6; n++) for (let j = -3; j <= 3; j++) {
      const [angle, rate] = [most * (n + 0.5) / 6, fastest * j / 3.5];
      const across = (xOf(1) - xOf(0)) * rate / degree;
      const down = (yOf(1) - yOf(0)) * -(omega ** 2) * Math.sin(angle * degree);
      const [dx, dy] = [across, down].map((part) => 5 * part / Math.hypot(across, down));
      const [x, y] = [xOf(angle), yOf(rate)];
      pen.moveTo(x - dx, y - dy);
      pen.lineTo(x + dx, y + dy);
      for (const turn of [0.5, -0.5]) {
         pen.moveTo(x + dx, y + dy);
         pen.lineTo(x + dx - 0.8 * (dx - turn * dy), y + dy - 0.8 * (dy + turn * dx));
      }
   }
   stroke(pen, colours.muted, 1, 0.6);
}

/* At rest: a disc where it hangs, which is stable, a ring where it stands, which is not */
function drawFixedPoints(pen, xOf, yOf, most) {
   for (let angle = -most; angle <= most; angle += 180) {
      pen.beginPath();
      pen.arc(xOf(angle), yOf(0), 4, 0, 2 * Math.PI);
      pen.fillStyle = angle % 360 === 0 ? colours.ink : colours.panel;
      pen.fill();
      stroke(pen, colours.ink, 1.5);
   }
}

/* Label, decimals, value of a pendulum and its motion now */
const readings = [
   ["amplitudeReading", 1, ({ amplitude }) => amplitude],
   ["ratioReading", 12, ({ ratio }) => ratio],
   ["periodReading", 6, ({ period }) => period],
   ["swingsReading", 2, ({ period }) => state.time / period],
   ["angleReading", 2, (pendulum, { angle }) => angle / degree],
   ["rateReading", 3, (pendulum, { rate }) => rate],
   ["energyReading", 6, (pendulum, motion) => energies(motion, state.length, state.gravity).total],
];

function setText(element, words) {
   if (element.textContent !== words) element.textContent = words;
}

function showReadings(motions) {
   lastReadings = performance.now();
   setText(find("time"), "t = " + state.time.toFixed(2) + " s");
   readings.forEach(([, decimals, value], i) => {
      pair.forEach((pendulum, j) => setText(find("readings").rows[i].cells[j + 1],
         written(value(pendulum, motions[j]) ?? NaN, decimals)));
   });
   const { amplitude, ratio, regime } = pair[0];
   setText(find("period-reading"), regime === "rotation" ? say("noAmplitude") : say("longer", {
      angle: shortly(amplitude, 1), ratio: written(ratio, 4), percent: written(100 * (ratio - 1), 1) }));
   setText(find("drift"), drift(motions));
}

/* How far the pendulums have come apart, in words */
function drift([{ angle }, beside]) {
   const { regime, period } = pair[0];
   if (state.compare === "driven") return say("stepped", { error: written((beside.angle - angle) / degree, 4) });
   if (regime === "rotation") return say("turns", { n: written(Math.abs(angle - pair[0].at(0).angle) / (2 * Math.PI), 1) });
   if (regime === "separatrix") return say("forever");
   const swings = state.time / period;
   const lag = state.time / pair[1].period - swings;
   return say(lag < 0 ? "ahead" : "behind", { n: written(swings, 1), lag: written(Math.abs(lag), 2) });
}

function draw() {
   const motions = pair.map((pendulum) => pendulum.at(state.time));
   drawStage(motions);
   drawEnergy(motions);
   drawTrace(motions);
   if (changed) drawPeriod();
   drawPhase(motions);
   placeHandles();
   /* Nobody reads digits that change at every frame. */
   if (!state.playing || performance.now() - lastReadings > 100) showReadings(motions);
   [stale, changed] = [false, false];
}
