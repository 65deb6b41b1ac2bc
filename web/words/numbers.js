// SPDX-License-Identifier: MIT
/**
 * @file How the page prints numbers: with a true minus sign, with the digits that the error justifies, and with powers
 * of ten if these are shorter.
 */

const MINUS = '−';
const THIN_SPACE = '\u202f';
const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** @param {number} exponent */
function superscript(exponent) {
  const digits = String(Math.abs(exponent)).replace(/\d/g, (digit) => SUPERSCRIPTS[Number(digit)]);
  return exponent < 0 ? `⁻${digits}` : digits;
}

/** Inserts thin spaces between groups of three digits if there are at least five. @param {string} digits */
function grouped(digits) {
  return digits.length < 5 ? digits : digits.replace(/\B(?=(\d{3})+$)/g, THIN_SPACE);
}

/**
 * `value` with `decimals` digits after the point.
 * @param {number} value
 * @param {number} decimals
 */
function fixed(value, decimals) {
  const [units, fraction] = Math.abs(value).toFixed(decimals).split('.');
  const text = fraction ? `${grouped(units)}.${fraction}` : grouped(units);
  return value < 0 && /[1-9]/.test(text) ? MINUS + text : text;
}

/** A part in percent, rounded up to two digits: 0.93 %, 5 %. @param {number} part */
export function percent(part) {
  const digits = 1 - Math.floor(Math.log10(100 * part));
  const up = Math.ceil(Number((100 * part * 10 ** digits).toPrecision(12))) / 10 ** digits;
  return `${Number(up.toPrecision(2))}\u202f%`;
}

/**
 * `value` with `digits` significant digits: 112.767, 4 227.3 as 4227.30, 1.3 × 10⁻⁷.
 * @param {number} value
 * @param {number} [digits]
 */
export function significant(value, digits = 6) {
  if (Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value < 0 ? `${MINUS}∞` : '∞';
  if (value === 0) return '0';
  const rounded = Number(value.toPrecision(digits));
  const exponent = Math.floor(Math.log10(Math.abs(rounded)) + 1e-12);
  if (exponent < -4 || exponent > 8) {
    const [mantissa] = Math.abs(rounded)
      .toExponential(digits - 1)
      .split('e');
    return `${value < 0 ? MINUS : ''}${mantissa}${THIN_SPACE}×${THIN_SPACE}10${superscript(exponent)}`;
  }
  return fixed(rounded, Math.max(0, digits - 1 - exponent));
}

/** The same without trailing zeros: 0.5, −2, 1.25. @param {number} value @param {number} [digits] */
export function compact(value, digits = 3) {
  const text = significant(value, digits);
  if (!text.includes('.')) return text;
  const [mantissa, power] = text.split(`${THIN_SPACE}×`);
  const trimmed = mantissa.replace(/\.?0+$/, '');
  return power === undefined ? trimmed : `${trimmed}${THIN_SPACE}×${power}`;
}

/** A short form for the ticks of an axis: 0.5, 2000, 10⁵, 1.5 × 10⁷. @param {number} value */
export function tickText(value) {
  const size = Math.abs(value);
  if (size === 0 || (size >= 0.001 && size < 1e5)) return compact(value, 4);
  const exponent = Math.floor(Math.log10(size) + 1e-9);
  const mantissa = compact(value / 10 ** exponent);
  const power = `10${superscript(exponent)}`;
  return mantissa === '1' ? power : `${mantissa}${THIN_SPACE}×${THIN_SPACE}${power}`;
}

/**
 * A value and its error bar, both rounded to the digits that the error justifies. The error gets `digitsOfError`
 * digits; by default one, or two if it begins with 1 or 2.
 * @param {number} value
 * @param {number} error >= 0
 * @param {number} [digitsOfError]
 * @returns {{value: string, error: string}}
 */
export function withError(value, error, digitsOfError) {
  if (!Number.isFinite(value) || !Number.isFinite(error)) return { value: significant(value), error: '' };
  if (!(error > 0)) return { value: significant(value, 8), error: '' };
  const [leading, exponent] = error
    .toExponential((digitsOfError ?? 1) - 1)
    .split('e')
    .map(Number);
  const digits = digitsOfError ?? (leading < 3 ? 2 : 1);
  const decimals = digits - 1 - exponent;
  const digitsOfValue = value === 0 ? 0 : Math.floor(Math.log10(Math.abs(value))) + 1 + decimals;
  if (decimals < 0 || decimals > 9 || digitsOfValue > 12) {
    return { value: significant(value, Math.min(10, Math.max(2, digitsOfValue))), error: compact(error, digits) };
  }
  return { value: fixed(value, decimals), error: fixed(error, decimals) };
}

/**
 * An upper bound with `digits` significant digits, rounded upwards so that it remains a bound.
 * @param {number} value >= 0
 * @param {number} [digits]
 */
export function upperBound(value, digits = 4) {
  return significant(roundedTo(value, digits, 1), digits);
}

/** A lower bound, rounded downwards. @param {number} value >= 0 @param {number} [digits] */
export function lowerBound(value, digits = 4) {
  return significant(roundedTo(value, digits, -1), digits);
}

/** @param {number} value >= 0 @param {number} digits significant ones @param {1 | -1} direction upwards or downwards */
function roundedTo(value, digits, direction) {
  if (!(value > 0) || !Number.isFinite(value)) return value;
  const rounded = Number(value.toPrecision(digits));
  const unit = 10 ** (Math.floor(Math.log10(value)) + 1 - digits);
  return (rounded - value) * direction < 0 ? rounded + direction * unit : rounded;
}

/** An integer: 12 288. @param {number} value */
export function integer(value) {
  return fixed(Math.round(value), 0);
}

/** 640 bytes, 85 kB, 3.2 MB. @param {number} bytes */
export function fileSize(bytes) {
  if (bytes < 1000) return counted(bytes, 'byte');
  return bytes < 999_500 ? `${compact(bytes / 1e3)}${THIN_SPACE}kB` : `${compact(bytes / 1e6)}${THIN_SPACE}MB`;
}

/** 0.4 s, 12 s, 3 min 20 s. @param {number} seconds */
export function duration(seconds) {
  if (seconds < 10) return `${fixed(seconds, 1)} s`;
  const rounded = Math.round(seconds);
  if (rounded < 60) return `${rounded} s`;
  return `${Math.floor(rounded / 60)} min ${rounded % 60} s`;
}

/** "1 face", "2 faces". @param {number} count @param {string} singular @param {string} [plural] */
export function counted(count, singular, plural = `${singular}s`) {
  return `${integer(count)} ${count === 1 ? singular : plural}`;
}
