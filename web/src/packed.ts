// Unpacks the numbers of all rows, which src/front/packed_series.hpp packs.

/** Undefined everywhere; the same everywhere; or power of ten, order of differences, digits, and begin and end of each gap. */
export type Packed = null | number | readonly [exponent: number, order: number, digits: string, ...gaps: number[]];

const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
const VALUE = new Uint8Array(128);
for (let i = 0; i < DIGITS.length; ++i) VALUE[DIGITS.charCodeAt(i)] = i;

export function unpack(packed: Packed, length: number): (number | null)[] {
  if (packed === null || typeof packed === "number") return new Array<number | null>(length).fill(packed);
  const [exponent, order, digits, ...gaps] = packed;
  const numbers = wholeNumbers(digits, length);
  for (let n = 0; n < order; ++n) {
    for (let i = 1; i < length; ++i) numbers[i] = (numbers[i] ?? 0) + (numbers[i - 1] ?? 0);
  }
  const [up, down] = [10 ** Math.max(exponent, 0), 10 ** Math.max(-exponent, 0)];
  const values: (number | null)[] = Array.from(numbers, (whole) => (whole * down) / up);
  for (let i = 0; i + 1 < gaps.length; i += 2) values.fill(null, gaps[i], gaps[i + 1]);
  return values;
}

// Computed as doubles, because the numbers may exceed 32 bits.
function wholeNumbers(digits: string, length: number): Float64Array {
  const numbers = new Float64Array(length);
  for (let i = 0, at = 0; i < length; ++i) {
    let [unsigned, place] = [0, 1];
    for (;;) {
      const digit = VALUE[digits.charCodeAt(at++)] ?? 0;
      unsigned += (digit & 31) * place;
      if (digit < 32) break;
      place *= 32;
    }
    const half = Math.floor(unsigned / 2);
    numbers[i] = unsigned === 2 * half ? half : -half - 1;
  }
  return numbers;
}
