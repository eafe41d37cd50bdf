/* ---- The formulas of the guided path, in MathML, and its steps. Where one is long, its parts. ---- */

const formulas = (() => {
   const word = (name) => `<mi>${name}</mi>`;
   const sign = (mark) => `<mo>${mark}</mo>`;
   const number = (digits) => `<mn>${digits}</mn>`;
   const row = (...parts) => `<mrow>${parts.join("")}</mrow>`;
   const over = (above, below) => `<mfrac>${row(above)}${row(below)}</mfrac>`;
   const root = (...parts) => `<msqrt>${parts.join("")}</msqrt>`;
   const power = (base, above) => `<msup>${base}${above}</msup>`;
   const index = (base, below) => `<msub>${base}${below}</msub>`;
   const thin = '<mspace width="0.17em"></mspace>';
   const [open, close] = ["(", ")"].map((mark) => `<mo stretchy="false">${mark}</mo>`);
   const call = (name, ...parts) => row(word(name), open, ...parts, close);

   const theta = word("θ");
   const theta0 = index(theta, number(0));
   const harmonic = index(word("T"), word("h"));
   const omega = word("ω");
   const modulus = word("k");
   const equals = sign("=");
   const ratio = row(over(word("T"), harmonic), equals, over(number(2), word("π")), call("K", modulus));

   return [
      row(harmonic, equals, number(2), word("π"), root(over(word("l"), word("g"))), equals,
         over(row(number(2), word("π")), omega)),
      row(ratio, equals, number(1), sign("+"), over(power(modulus, number(2)), number(4)), sign("+"),
         over(row(number(9), power(modulus, number(4))), number(64)), sign("+"), sign("⋯")),
      [row(call("K", modulus), equals, "<msubsup><mo>∫</mo><mn>0</mn><mrow><mi>π</mi><mo>/</mo><mn>2</mn></mrow></msubsup>",
         over(row(word("d"), word("t")), root(number(1), sign("−"), power(modulus, number(2)),
            power(word("sin"), number(2)), thin, word("t")))),
         row(equals, over(word("π"), row(number(2), call("AGM", number(1), sign(","),
            root(number(1), sign("−"), power(modulus, number(2)))))))],
      row(over(word("T"), harmonic), sign("≈"), over(number(2), word("π")), word("ln"),
         over(number(4), row(word("cos"), open, theta0, sign("/"), number(2), close))),
      row(over(number(1), number(2)), power(theta, sign("′")), power("<mrow></mrow>", number(2)), sign("−"),
         power(omega, number(2)), thin, word("cos"), thin, theta, equals, word("E")),
      row(call("θ", word("t")), equals, number(2), thin, word("arcsin"), open, modulus, thin, call("sn", omega, word("t"),
         sign(","), modulus), close),
   ];
})();

/* What each step sets; all else is as it was at the beginning. */
const lessons = [
   { start: "release", amplitude: 5 },
   { start: "release", amplitude: 39.159 },
   { start: "release", amplitude: 90 },
   { start: "release", amplitude: 179.9 },
   { start: "angle", angle: 0, rate: 6.5 },
   { start: "amplitude", amplitude: 150 },
];

const notes = {
   first: ["http://nalab.mind.meiji.ac.jp/~mk/labo/text/furiko/", "firstNote"],
   second: ["http://hooktail.sub.jp/mathInPhys/elliptical/", "secondNote"],
};
