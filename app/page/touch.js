/* ---- What can be taken hold of: the bob, the dot on the period's curve, the point of the phase portrait. Each is
   an element of its own, so that a finger on it moves it, and anywhere else the page. ---- */

let held = null;

/* The state of a start by its angle in degrees and its rate, rounded as the sliders say it */
function startAt(angle, rate) {
   const rounded = clamp(Number(angle.toFixed(1)), limits.angle);
   if (rate === null) return { start: "release", amplitude: rounded };
   return { start: "angle", angle: rounded, rate: clamp(Number(rate.toFixed(2)), limits.rate) };
}

/* An amplitude keeps the kind of start, other than that of any state. */
function amplitudeOf(degrees) {
   return { start: state.start === "angle" ? "release" : state.start,
      amplitude: clamp(Number(degrees.toFixed(1)), [0, 179.9]) };
}

const grips = {
   bob: {
      at: () => spots.bob,
      /* The hand's angle, counted on from the one before */
      move({ x, y }, before) {
         const angle = Math.atan2(x - spots.pivot.x, y - spots.pivot.y);
         const turned = before === null ? angle : before + wrapped(angle - before);
         change(startAt(wrapped(turned) / degree, null));
         return turned;
      },
      /* Thrown, if the hand was moving when it let go */
      drop(samples) {
         if (samples.length < 2) return;
         const [first, last] = [samples[0], samples[samples.length - 1]];
         const rate = (last.value - first.value) / Math.max(0.016, (last.time - first.time) / 1000);
         if (Math.abs(rate) > 0.3) change(startAt(wrapped(last.value) / degree, rate));
      },
      key: (by) => change(startAt(clamp(wrapped(pair[0].at(0).angle) / degree + by.x, limits.angle), null)),
      value: () => [wrapped(pair[0].at(0).angle) / degree, -180, 180],
   },
   dot: {
      at: () => spots.dot,
      move({ x }) {
         change(amplitudeOf(spots.amplitudeAt(x)));
         return 0;
      },
      key: (by) => change(amplitudeOf((Number.isFinite(pair[0].amplitude) ? pair[0].amplitude : 179) + by.x + by.y)),
      value: () => [Math.min(180, pair[0].amplitude), 0, 180],
   },
   point: {
      at: () => spots.point,
      move({ x, y }) {
         const [angle, rate] = spots.stateAt(x, y);
         change(startAt(angle, rate));
         return 0;
      },
      key(by) {
         const { angle, rate } = pair[0].at(0);
         change(startAt(wrapped(angle) / degree + by.x, rate + by.y / 10));
      },
      value: () => [wrapped(pair[0].at(0).angle) / degree, -180, 180],
   },
};

const arrows = { ArrowLeft: { x: -1, y: 0 }, ArrowRight: { x: 1, y: 0 }, ArrowUp: { x: 0, y: 1 }, ArrowDown: { x: 0, y: -1 } };

function addGrip(id) {
   const handle = find(id);
   const grip = grips[id];

   function place(event) {
      const box = handle.parentNode.getBoundingClientRect();
      return { x: event.clientX - box.left - held.off.x, y: event.clientY - box.top - held.off.y };
   }

   handle.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || held) return;
      const box = handle.parentNode.getBoundingClientRect();
      const { x, y } = grip.at();
      held = { id, off: { x: event.clientX - box.left - x, y: event.clientY - box.top - y }, samples: [],
         value: null };
      handle.setPointerCapture(event.pointerId);
   });
   handle.addEventListener("pointermove", (event) => {
      if (held?.id !== id) return;
      held.value = grip.move(place(event), held.value);
      held.samples.push({ time: event.timeStamp, value: held.value });
   });
   const drop = (event) => {
      if (held?.id !== id) return;
      const { samples } = held;
      held = null;
      if (samples.length === 0) return;
      grip.drop?.(samples.filter((sample) => event.timeStamp - sample.time < 120));
      play(!stillness.matches);
      commit();
   };
   handle.addEventListener("pointerup", drop);
   handle.addEventListener("pointercancel", drop);
   handle.addEventListener("keydown", (event) => {
      const by = arrows[event.key];
      if (!by || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      const size = event.shiftKey ? 0.1 : 1;
      grip.key(id === "bob" ? { x: (by.x + by.y) * size } : { x: by.x * size, y: by.y * size });
      commit();
   });
}

/* Values for those who cannot see them: at the start, so that they are no stream */
function showHandles() {
   for (const [id, grip] of Object.entries(grips)) {
      const [value, low, high] = grip.value();
      const text = id === "point" ? say("pointValue", { angle: written(value, 1), rate: written(pair[0].at(0).rate, 2) })
         : written(value, 1) + " " + say("degrees");
      Object.entries({ valuemin: low, valuemax: high, valuenow: Number(value.toFixed(1)), valuetext: text })
         .forEach(([name, what]) => find(id).setAttribute("aria-" + name, what));
   }
}

/* The handles go where the pictures are drawn. */
function placeHandles() {
   for (const [id, grip] of Object.entries(grips)) {
      const { x, y } = grip.at();
      find(id).style.transform = `translate(${x}px, ${y}px)`;
   }
}
