/* ---- The state: what the address's fragment says, and the motions that follow from it ---- */

const initial = { start: "release", amplitude: 90, angle: 0, rate: 6.5, compare: "small", other: 30,
   linear: 0.2, drive: 0, "drive-frequency": 2, length: 1, gravity: 9.80665, speed: 1, time: 0, lesson: 0, language: "en" };
const state = { ...initial, playing: false };
const lastTime = 3600;

/* What numbers may be; amplitudes are those of any start. */
const limits = { amplitude: [-180, 180], angle: [-180, 180], rate: [-100, 100], other: [0, 179.9999999],
   linear: [0, 10], drive: [0, 50], "drive-frequency": [0, 20], length: [0.1, 100], gravity: [0.1, 30], speed: [0.1, 10],
   time: [0, lastTime], lesson: [0, lessons.length - 1] };

/* The motions on show; whether the pictures are behind the time, and whether all of them are behind the state */
let pair = [];
let stale = true;
let changed = true;

function clamp(value, [low, high]) {
   return Math.min(high, Math.max(low, value));
}

/* The options of `furiko animate` are these words, too: release=30&compare=driven&linear=0.1 */
function fragment() {
   const words = new URLSearchParams();
   if (state.start === "angle") {
      words.set("angle", state.angle);
      words.set("rate", state.rate);
   } else words.set(state.start, state.amplitude);
   if (state.compare === "other") words.set("compare", state.other);
   else if (state.compare === "driven") words.set("compare", "driven");
   for (const key of ["linear", "drive", "drive-frequency", "length", "gravity", "speed", "lesson"]) {
      const matters = state.compare === "driven" || !["linear", "drive", "drive-frequency"].includes(key);
      if (matters && state[key] !== initial[key]) words.set(key, state[key]);
   }
   if (!state.playing && state.time > 0) words.set("time", Number(state.time.toFixed(6)));
   words.set("language", state.language);
   return "#" + words;
}

/* Take the state from a fragment; what it does not say is as at the beginning, what makes no sense is left. */
function readFragment(text) {
   const words = new URLSearchParams(text.replace(/^#/, ""));
   const { language } = state;
   Object.assign(state, initial, { language });
   for (const [key, value] of words) {
      const number = value.trim() === "" ? NaN : Number(value);
      const valid = Number.isFinite(number);
      if (key === "language" && languages.includes(value)) state.language = value;
      else if (key === "release" || key === "amplitude") {
         if (valid) Object.assign(state, { start: key, amplitude: clamp(number, limits.amplitude) });
      } else if (key === "compare") {
         if (valid) Object.assign(state, { compare: "other", other: clamp(Math.abs(number), limits.other) });
         else if (value === "driven") state.compare = "driven";
      } else if (key in limits && valid) {
         state[key] = clamp(key === "lesson" ? Math.round(number) : number, limits[key]);
         if (key === "angle" || key === "rate") state.start = "angle";
      }
   }
   if (words.has("angle") && !words.has("rate")) state.rate = 0;
}

/* The start as the mathematics take it; an amplitude through the bottom ends below the top. */
function startOf(amplitude) {
   if (state.start === "release") return { release: amplitude };
   return { amplitude: clamp(amplitude, [-179.9999999, 179.9999999]) };
}

function rebuild() {
   const { length, gravity } = state;
   const start = state.start === "angle" ? { angle: state.angle, rate: state.rate } : startOf(state.amplitude);
   const exact = exactMotion(start, length, gravity);
   const begin = exact.at(0);
   let beside;
   if (state.compare === "small") beside = smallAngleMotion(begin, length, gravity);
   else if (state.compare === "driven") beside = steppedMotion(begin, length, gravity, state);
   else beside = exactMotion(state.start === "angle" ? { release: state.other } : startOf(state.other), length, gravity);
   pair = [{ ...exact, name: nameOf(exact) }, { ...beside, name: state.compare === "small" ? say("smallName")
      : state.compare === "driven" ? say("drivenName") : nameOf(beside) }];
   changed = true;
}

function nameOf({ regime, amplitude }) {
   if (regime === "rotation") return say("rotationName");
   if (regime === "separatrix") return say("separatrixName");
   return say("exactName", { angle: shortly(amplitude, 1) });
}

function seek(time) {
   state.time = clamp(time, limits.time);
   if (state.time === lastTime) state.playing = false;
   stale = true;
}

/* A number with so many decimals and a true minus sign, never before a zero. */
function written(value, decimals) {
   if (!Number.isFinite(value)) return Number.isNaN(value) ? "–" : "∞";
   const text = value.toFixed(decimals);
   return Number(text) < 0 ? "−" + text.slice(1) : text.replace("-", "");
}

/* With more decimals where the few would say another number, as 39.159 or 179.99999 */
function shortly(value, decimals) {
   const more = Number(value.toFixed(7));
   return Math.abs(more - Number(value.toFixed(decimals))) < 1e-6 ? written(value, decimals) : written(more, 
      Math.max(decimals, (String(more).split(".")[1] ?? "").length));
}
