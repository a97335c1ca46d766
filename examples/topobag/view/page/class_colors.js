// SPDX-License-Identifier: MIT

// ---- Colors

// OKLCH to sRGB, each in [0, 1] (B. Ottosson, "A perceptual color space for image processing",
// 2020).
const oklch = (lightness, chroma, degrees) => {
  const a = chroma * Math.cos(degrees * Math.PI / 180);
  const b = chroma * Math.sin(degrees * Math.PI / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const linear = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return linear.map((c) => {
    const clamped = Math.min(Math.max(c, 0), 1);
    return clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * clamped ** (1 / 2.4) - 0.055;
  });
};

// One color a class, the frequent ones farthest apart: their hues follow each other by the golden
// angle, and neighbors differ in lightness, too.
const classColors = (countOf, dark) => {
  const ranked = countOf.map((_, i) => i).sort((a, b) => countOf[b] - countOf[a] || a - b);
  const colors = [];
  ranked.forEach((label, rank) => {
    const lightness = (dark ? 0.74 : 0.69) + [0, 0.07, -0.07][rank % 3];
    colors[label] = oklch(lightness, dark ? 0.12 : 0.125, 250 + 137.508 * rank);
  });
  return colors;
};

const cssOf = (color) => 'rgb(' + color.map((c) => Math.round(255 * c)).join() + ')';

// A color of the style sheet, where it is written #rrggbb.
const styleColor = (name) => {
  const text = getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
  return [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16) / 255);
};

// What the truth says of a match: never by color alone, so each has its dashes and its sign.
const verdicts = {
  correct: { color: 'good', dash: 0, sign: '✓', text: 'correct' },
  imprecise: { color: 'loose', dash: 10, sign: '~', text: 'imprecise' },
  wrong: { color: 'bad', dash: 4, sign: '✕', text: 'wrong' },
  accepted: { color: 'accent', dash: 0, sign: '•', text: 'accepted' },
};
const verdictOf = (match) => verdicts[match.verdict ?? 'accepted'];
