// SPDX-License-Identifier: MIT
/**
 * @file The colour space OKLab, in which distances match perceived differences, and its conversion to sRGB (B. Ottosson
 * 2020).
 */

/** @typedef {[number, number, number]} Triple L, a, b or red, green, blue */

/**
 * OKLab from lightness 0 … 1, chroma, and hue in degrees.
 * @param {number} lightness
 * @param {number} chroma
 * @param {number} hue
 * @returns {Triple}
 */
export function fromLch(lightness, chroma, hue) {
  const angle = (hue * Math.PI) / 180;
  return [lightness, chroma * Math.cos(angle), chroma * Math.sin(angle)];
}

/**
 * Linear sRGB; components outside 0 … 1 are colours that a screen cannot show.
 * @param {Triple} lab
 * @returns {Triple}
 */
export function toLinearRgb([L, a, b]) {
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}

/**
 * The inverse of `toLinearRgb`.
 * @param {Triple} rgb
 * @returns {Triple}
 */
export function fromLinearRgb([r, g, b]) {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

/** The sRGB transfer function, 0 … 1 to 0 … 1. @param {number} linear */
export function encode(linear) {
  const clamped = Math.min(1, Math.max(0, linear));
  return clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * clamped ** (1 / 2.4) - 0.055;
}

/** The inverse of `encode`. @param {number} encoded */
export function decode(encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
}

/** Euclidean distance. @param {Triple} p @param {Triple} q */
export function distance(p, q) {
  return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}
