// Numbers, units and names for readers.
/** The number as text; values up to `noise` are shown as 0. With a power of ten it has `powerDigits` digits. */
export function number(value: number | null, noise = 0, digits = 6, powerDigits = Math.min(digits, 4)): string {
  if (value === null) return "–";
  if (Math.abs(value) <= noise) return "0";
  const size = Math.abs(value);
  const hasPower = size !== 0 && (size >= 1e7 || size < 1e-4);
  const text = hasPower ? value.toExponential(powerDigits - 1).replace(/\.?0*e/, "e") : String(Number(value.toPrecision(digits)));
  return text.replace("-", "−").replace("e+", "e").replace(/e(.*)/, (_, power: string) => `·10${superscript(power)}`);
}

/** Labels of ticks at this spacing, with as many digits as it takes to distinguish them. */
export function tickLabels(ticks: readonly number[], step: number): string[] {
  const largest = Math.max(...ticks.map(Math.abs), step);
  const digits = Math.min(Math.max(5, Math.ceil(Math.log10(largest / step)) + 2), 15);
  return ticks.map((tick) => number(tick, 1e-6 * step, digits, digits));
}

function superscript(power: string): string {
  return power.replace(/./g, (digit) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(digit.replace("−", "-"))] ?? digit);
}

export function unit(text: string): string {
  if (text === "1") return "";
  return text.replace(/deg/g, "°").replace(/\*/g, "·").replace(/\^(-?\d+)/g, (_, power: string) => superscript(power));
}

/** "12.5 mm", "30°". */
export function quantity(value: number | null, unitText: string, noise = 0, digits = 6): string {
  const shown = unit(unitText);
  if (value === null) return number(value);
  return number(value, noise, digits) + (shown === "" || shown.startsWith("°") ? shown : " " + shown);
}

/** "limit position" for "limit_position". */
export function words(name: string): string {
  return name.replace(/_/g, " ");
}
