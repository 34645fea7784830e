// Numbers, units and names for readers.
/** The number as text; values up to `noise` are shown as 0. */
export function number(value: number | null, noise = 0, digits = 6): string {
  if (value === null) return "–";
  if (Math.abs(value) <= noise) return "0";
  const size = Math.abs(value);
  const text = size !== 0 && (size >= 1e7 || size < 1e-4) ? value.toExponential(Math.min(digits, 4) - 1) : String(Number(value.toPrecision(digits)));
  return text.replace("-", "−").replace("e+", "e").replace(/e(.*)/, (_, power: string) => `·10${superscript(power)}`);
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
  return number(value, noise, digits) + (shown === "" || shown.startsWith("°") ? shown : " " + shown);
}

/** "limit position" for "limit_position". */
export function words(name: string): string {
  return name.replace(/_/g, " ");
}
