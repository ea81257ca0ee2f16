// SPDX-License-Identifier: MIT
// Numbers as engineers read them: a few digits, plain where that is short, else with an exponent that is a multiple
// of 3.

/** What stands where nothing was measured or nothing applies. */
export const nothing = "–";

function special(value: number): string | null {
  if (Number.isNaN(value)) return "nan";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  return value === 0 ? "0" : null;
}

/** `value` with three or more significant digits: 0.209, 12,346, 244e-6. */
export function figure(value: number | null | undefined, digits = 3): string {
  if (value === null || value === undefined) return nothing;
  const word = special(value);
  if (word !== null) return word;
  const [mantissa = "", power = ""] = value.toExponential(digits - 1).split("e");
  const exponent = Number(power);
  if (exponent >= digits && exponent < 6) return count(Math.round(value));
  if (exponent >= -2 && exponent < digits) return value.toFixed(Math.max(0, digits - 1 - exponent));
  const shift = ((exponent % 3) + 3) % 3;
  const sign = mantissa.startsWith("-") ? "-" : "";
  const all = mantissa.replace(/[-.]/g, "").padEnd(shift + 1, "0");
  const fraction = all.slice(shift + 1);
  return `${sign}${all.slice(0, shift + 1)}${fraction ? "." + fraction : ""}e${exponent - shift}`;
}

/** A whole number, its thousands separated. */
export function count(value: number | null | undefined): string {
  if (value === null || value === undefined) return nothing;
  return Number.isInteger(value) ? value.toLocaleString("en-US") : figure(value);
}

/** `value` with all the digits that tell it from its neighbours. */
export const exactly = (value: number) => special(value) ?? String(value);

/** "1 source", "3 sources". */
export const counted = (n: number, noun: string) => `${count(n)} ${noun}${n === 1 ? "" : "s"}`;
