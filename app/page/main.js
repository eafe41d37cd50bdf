/* ---- To take away: the view as a picture, the trace as numbers, the address of the state ---- */

function save(name, blob) {
   const link = document.createElement("a");
   link.href = URL.createObjectURL(blob);
   link.download = name;
   link.click();
   setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/* The pictures, with their captions, where they stand on the page */
function picture() {
   const frame = document.querySelector("main").getBoundingClientRect();
   const scale = window.devicePixelRatio;
   const figures = Array.from(document.querySelectorAll("figure"));
   const low = Math.max(...figures.map((figure) => figure.getBoundingClientRect().bottom));
   const first = Math.min(...figures.map((figure) => figure.getBoundingClientRect().top));
   const left = Math.min(...figures.map((figure) => figure.getBoundingClientRect().left));
   const sheet = document.createElement("canvas");
   sheet.width = Math.ceil(scale * (frame.right - left));
   sheet.height = Math.ceil(scale * (low - first));
   const pen = sheet.getContext("2d");
   pen.scale(scale, scale);
   pen.fillStyle = colours.panel;
   pen.fillRect(0, 0, sheet.width, sheet.height);
   for (const figure of figures) {
      const canvas = figure.querySelector("canvas");
      const [box, caption] = [canvas, figure.querySelector("figcaption")].map((part) => part.getBoundingClientRect());
      pen.drawImage(canvas, box.left - left, box.top - first, box.width, box.height);
      pen.font = `13px ${face}`;
      text(pen, figure.querySelector("figcaption").textContent.trim(), caption.left - left, caption.top - first + 14, "left");
   }
   return sheet;
}

/* The window of the trace, in the units of `furiko motion` */
function csv() {
   const span = roundUp(16 * Math.PI / pair[0].omega);
   const from = Math.max(0, state.time - 0.6 * span);
   const lines = Array.from({ length: 481 }, (_, n) => {
      const time = from + n * span / 480;
      return [time, ...pair.flatMap((pendulum) => {
         const { angle, rate } = pendulum.at(time);
         return [angle, rate];
      })].join(",");
   });
   return [`# furiko ${begin.version} ${fragment()}`,
      `# first: ${pair[0].name}; second: ${pair[1].name}`,
      "time_s,first_rad,first_rad_s,second_rad,second_rad_s", ...lines, ""].join(String.fromCharCode(10));
}

function addExports() {
   find("picture").addEventListener("click", () => picture().toBlob((blob) => save("pendulum.png", blob)));
   find("data").addEventListener("click", () => save("pendulum.csv", new Blob([csv()], { type: "text/csv" })));
   find("share").addEventListener("click", () => {
      note();
      navigator.clipboard?.writeText(location.href).then(() => {
         find("share").textContent = say("shared");
         setTimeout(() => { find("share").textContent = say("share"); }, 1500);
      }, () => {});
   });
}


/* ---- The clock ---- */

const begin = JSON.parse(find("begin").textContent);
let lastFrame = performance.now();

function tick(now) {
   /* A page that was out of sight goes on where it was. */
   if (state.playing && !held) seek(state.time + state.speed * Math.min(0.1, (now - lastFrame) / 1000));
   lastFrame = now;
   if (stale || changed) draw();
   window.requestAnimationFrame(tick);
}

/* On paper: light colours, and pictures drawn for the sizes they have there */
function repaint(theme) {
   document.documentElement.dataset.theme = theme;
   readColours();
   draw();
}

const wanted = (navigator.languages ?? []).map((name) => name.slice(0, 2)).find((name) => languages.includes(name));
const watcher = new ResizeObserver(() => {
   changed = true;
});
state.language = wanted ?? languages[0];
addControls();
addExports();
Object.keys(grips).forEach(addGrip);
readColours();
open(location.hash.length > 1 ? location.hash : begin.state);
setText(find("version"), begin.version);
document.querySelectorAll("canvas").forEach((canvas) => watcher.observe(canvas));
window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", readColours);
window.matchMedia("(forced-colors: active)").addEventListener("change", readColours);
window.addEventListener("beforeprint", () => repaint("light"));
window.addEventListener("afterprint", () => repaint(""));
play(!stillness.matches && state.time === 0);
tell();
window.requestAnimationFrame(tick);


/* ---- For tests and the curious: starts as { release }, { amplitude } or { angle, rate } in degrees and rad/s;
   angles in radians, rates in rad/s, periods in seconds ---- */

window.furiko = {
   version: begin.version,
   motion: (start, length, gravity, time) => {
      const { at, period, ratio, amplitude } = exactMotion(start, length, gravity);
      return { ...at(time), period, ratio, amplitude };
   },
   /* What is on show now: every setting, both motions, where bob, dot and point are drawn. */
   state: () => ({ ...state, spots: { ...spots }, names: pair.map(({ name }) => name),
      motions: pair.map((pendulum) => pendulum.at(state.time)) }),
   fragment, csv, picture: () => picture().toDataURL(), play, seek, strings,
};
