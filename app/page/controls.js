/* ---- The controls. A change begins the motion anew; when it is finished, the address keeps it. ---- */

function find(id) {
   return document.getElementById(id);
}

/* low to high are the slider's; a field takes what `limits` allows. `log`: the slider goes by the logarithm. */
const sliders = [
   { key: "amplitude", label: "amplitudeSlider", unit: "degrees", symbol: "°", low: 0, high: 179.9, digits: 1,
      at: "start-sliders", shown: () => state.start !== "angle" },
   { key: "angle", label: "angleSlider", unit: "degrees", symbol: "°", low: -180, high: 180, digits: 1,
      at: "start-sliders", shown: () => state.start === "angle" },
   { key: "rate", label: "rateSlider", unit: "radiansPerSecond", symbol: "rad/s", low: -12, high: 12, digits: 2,
      at: "start-sliders", shown: () => state.start === "angle" },
   { key: "other", label: "otherSlider", unit: "degrees", symbol: "°", low: 0, high: 179.9, digits: 1,
      at: "compare-sliders", shown: () => state.compare === "other" },
   { key: "linear", label: "dampingSlider", unit: "perSecond", symbol: "1/s", low: 0, high: 3, digits: 2,
      at: "compare-sliders", shown: () => state.compare === "driven" },
   { key: "drive", label: "driveSlider", unit: "radiansPerSquareSecond", symbol: "rad/s²", low: 0, high: 20, digits: 1,
      at: "compare-sliders", shown: () => state.compare === "driven" },
   { key: "drive-frequency", label: "frequencySlider", unit: "radiansPerSecond", symbol: "rad/s", low: 0, high: 10, digits: 2,
      at: "compare-sliders", shown: () => state.compare === "driven" },
   { key: "length", label: "lengthSlider", unit: "metres", symbol: "m", low: 0.1, high: 100, digits: 2, log: true,
      at: "place-sliders", shown: () => true },
   { key: "gravity", label: "gravitySlider", unit: "metresPerSquareSecond", symbol: "m/s²", low: 0.1, high: 30,
      digits: 2, at: "place-sliders", shown: () => true },
];

/* Length and gravity: NASA's fact sheets' gravities at the surface or the cloud tops; a seconds pendulum takes
   2 s by T_h = 2 pi sqrt(l/g). */
const places = {
   earth: [1, 9.80665], moon: [1, 1.62], mars: [1, 3.73], jupiter: [1, 24.79],
   seconds: [9.80665 / Math.PI ** 2, 9.80665], foucault: [67, 9.80665], swing: [2.5, 9.80665],
};
const speeds = [0.1, 0.25, 0.5, 1, 2, 5, 10];
const stepLength = 0.05;

/* A change by the user: the motion begins anew, and goes on if it was going. */
function change(values) {
   Object.assign(state, values, { time: 0 });
   show();
}

/* All that follows from the state, controls and words; the pictures come with the next frame. */
function show() {
   rebuild();
   for (const slider of sliders) slider.show();
   document.querySelectorAll("input[type=radio]").forEach((radio) => {
      radio.checked = state[radio.name] === radio.value;
   });
   find("play").textContent = say(state.playing ? "pause" : "play");
   find("speed").value = String(speeds.reduce((best, speed) =>
      Math.abs(speed - state.speed) < Math.abs(best - state.speed) ? speed : best));
   find("place").value = Object.keys(places).find((key) => Math.abs(places[key][0] - state.length) < 1e-9
      && Math.abs(places[key][1] - state.gravity) < 1e-9) ?? "own";
   pair.forEach(({ name }, i) => {
      find("name-" + i).textContent = name;
   });
   showHandles();
   lastReadings = -Infinity;
}

/* A finished change: the address has it, as an entry of its own to come back to, and it is said once. */
function commit() {
   if (fragment() !== location.hash) history.pushState(null, "", fragment());
   tell();
}

/* As commit, of what is no step of its own, as the time. */
function note() {
   history.replaceState(null, "", fragment());
   tell();
}

/* For those who do not see the pictures: said when the motion stands still or has been changed. */
function tell() {
   const [a, b] = pair.map((pendulum) => written(wrapped(pendulum.at(state.time).angle) / degree, 1));
   find("status").textContent = say("summary", { time: state.time.toFixed(2), first: pair[0].name,
      second: pair[1].name, a, b });
}

function play(on) {
   state.playing = on && state.time < lastTime;
   find("play").textContent = say(state.playing ? "pause" : "play");
   stale = true;
}

function toggle() {
   play(!state.playing);
   if (!state.playing) note();
}

function step(by) {
   play(false);
   seek(state.time + by);
   note();
}

/* One row: a label, a field for the exact value, a slider. */
function addSlider(slider) {
   const { key, digits, low, high, log } = slider;
   const line = document.createElement("div");
   const scale = log ? [Math.log10, (x) => Number((10 ** x).toPrecision(3))] : [(x) => x, (x) => x];
   line.className = "slider";
   line.innerHTML = `<label for="${key}"></label><input type="number" step="any" id="${key}-field"><span
      aria-hidden="true">${slider.symbol}</span><input type="range" id="${key}" min="${scale[0](low)}"
      max="${scale[0](high)}" step="${log ? 0.005 : 10 ** -digits}">`;
   find(slider.at).append(line);
   const [field, range] = line.querySelectorAll("input");

   function take(wanted) {
      if (Number.isFinite(wanted)) change({ [key]: clamp(wanted, limits[key]) });
   }

   range.addEventListener("input", () => take(scale[1](range.valueAsNumber)));
   field.addEventListener("input", () => take(field.valueAsNumber));
   range.addEventListener("change", commit);
   field.addEventListener("change", () => {
      commit();
      field.value = shortly(state[key], digits).replace("−", "-");
   });
   slider.show = () => {
      const text = shortly(state[key], digits);
      line.hidden = !slider.shown();
      range.value = scale[0](state[key]);
      range.setAttribute("aria-valuetext", text + " " + say(slider.unit));
      if (document.activeElement !== field) field.value = text.replace("−", "-");
      line.querySelector("label").textContent = say(slider.label);
      field.setAttribute("aria-label", say("exactValue", { label: say(slider.label), unit: say(slider.unit) }));
   };
}

/* Every word of the page, in the state's language */
function translate() {
   document.documentElement.lang = state.language;
   document.title = say("title");
   document.querySelectorAll("[data-text]").forEach((element) => {
      element.innerHTML = say(element.dataset.text);
   });
   document.querySelectorAll("[data-label]").forEach((element) => {
      element.setAttribute("aria-label", say(element.dataset.label));
   });
   find("language").innerHTML = languages.map((code, i) =>
      `<option value="${code}" lang="${code}">${strings.languageName[i]}</option>`).join("");
   find("language").value = state.language;
   find("speed").innerHTML = speeds.map((speed) => `<option value="${speed}">× ${speed}</option>`).join("");
   find("place").innerHTML = Object.keys(places).map((key) => `<option value="${key}">${say(key)}</option>`).join("")
      + `<option value="own">${say("ownPlace")}</option>`;
   find("readings").innerHTML = readings.map(([label]) =>
      `<tr><th scope="row">${say(label)}</th><td></td><td></td></tr>`).join("");
   showLesson();
}

function showLesson() {
   const name = "lesson" + state.lesson;
   const links = Object.fromEntries(Object.entries(notes).map(([key, [address, text]]) =>
      [key, `<a href="${address}" hreflang="ja">${say(text)}</a>`]));
   find("lesson-count").textContent = `${state.lesson + 1} / ${lessons.length}`;
   find("lesson-title").textContent = say(name);
   find("lesson-text").innerHTML = say(name + "Text", links);
   find("lesson-formula").innerHTML = "<div>" + [formulas[state.lesson]].flat().map((part) =>
      `<math displaystyle="true">${part}</math>`).join("") + `</div><p>${say(name + "Symbols")}</p>`;
   find("lesson-back").disabled = state.lesson === 0;
   find("lesson-next").disabled = state.lesson === lessons.length - 1;
}

function goTo(lesson) {
   const { language, speed } = state;
   change({ ...initial, language, speed, ...lessons[lesson], lesson });
   showLesson();
   commit();
}

/* From the address, at the beginning and when the user goes back in it */
function open(text) {
   readFragment(text);
   if (state.time > 0) state.playing = false;
   translate();
   show();
}

function addControls() {
   sliders.forEach(addSlider);
   document.querySelectorAll("input[type=radio]").forEach((radio) => {
      radio.addEventListener("change", () => {
         change({ [radio.name]: radio.value });
         commit();
      });
   });
   find("play").addEventListener("click", toggle);
   find("back").addEventListener("click", () => step(-stepLength));
   find("step").addEventListener("click", () => step(stepLength));
   find("restart").addEventListener("click", () => {
      seek(0);
      note();
   });
   find("speed").addEventListener("change", () => {
      state.speed = Number(find("speed").value);
      commit();
   });
   find("place").addEventListener("change", () => {
      const [length, gravity] = places[find("place").value] ?? [state.length, state.gravity];
      change({ length, gravity });
      commit();
   });
   find("language").addEventListener("change", () => {
      state.language = find("language").value;
      translate();
      show();
      commit();
   });
   find("lesson-back").addEventListener("click", () => goTo(state.lesson - 1));
   find("lesson-try").addEventListener("click", () => goTo(state.lesson));
   find("lesson-next").addEventListener("click", () => goTo(state.lesson + 1));
   window.addEventListener("popstate", () => open(location.hash));
   document.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      const own = event.target.matches("button, summary, select, a, input:not([type=range])");
      const still = !event.target.matches("input, select, .handle");
      if (event.key === " " && !own) toggle();
      else if (event.key === "ArrowLeft" && still) step(-stepLength);
      else if (event.key === "ArrowRight" && still) step(stepLength);
      else return;
      event.preventDefault();
   });
}
