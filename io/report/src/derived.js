// What the page works out by itself; each as the engine does it.

// Mean with the standard error from ten blocks (io/statistics.cpp).
export function blockMean(samples, blocks = 10) {
  const n = samples.length;
  if (n === 0) return { mean: NaN, error: NaN };
  const sum = (list) => list.reduce((a, b) => a + b, 0);
  const mean = sum(samples) / n;
  const used = Math.min(blocks, n);
  if (used < 2) return { mean, error: NaN };
  const means = Array.from({ length: used }, (_, b) => {
    const part = samples.slice(Math.floor((b * n) / used), Math.floor(((b + 1) * n) / used));
    return sum(part) / part.length;
  });
  const middle = sum(means) / used;
  return { mean, error: Math.sqrt(sum(means.map((m) => (m - middle) ** 2)) / (used * (used - 1))) };
}

// rad/s: gravity just holds a point at the shell.
export function criticalSpeed(diameter, gravity) {
  return Math.sqrt((2 * gravity) / diameter);
}

// Of a schedule [[time, rate], ...], linear between points, constant outside.
export function rateAt(schedule, time) {
  const later = schedule.findIndex(([t]) => t > time);
  if (later < 0) return schedule.at(-1)[1];
  if (later === 0) return schedule[0][1];
  const [t0, r0] = schedule[later - 1],
    [t1, r1] = schedule[later];
  return r0 + ((r1 - r0) * (time - t0)) / (t1 - t0);
}

// Angle turned from 0 to `time`.
export function turned(schedule, time) {
  const times = [0, ...schedule.map(([t]) => t).filter((t) => t > 0 && t < time), time];
  let angle = 0;
  for (let k = 1; k < times.length; k += 1) {
    angle += 0.5 * (rateAt(schedule, times[k - 1]) + rateAt(schedule, times[k])) * (times[k] - times[k - 1]);
  }
  return time > 0 ? angle : 0;
}

export function meanRate(schedule, from, to) {
  return to > from ? (turned(schedule, to) - turned(schedule, from)) / (to - from) : rateAt(schedule, to);
}

export function timeOfRevolution(schedule, revolutions) {
  let low = 0,
    high = 1;
  const done = (t) => Math.abs(turned(schedule, t)) >= 2 * Math.PI * revolutions;
  while (!done(high) && high < 1e7) high *= 2;
  for (let k = 0; k < 60; k += 1) {
    const middle = 0.5 * (low + high);
    if (done(middle)) high = middle;
    else low = middle;
  }
  return high;
}

// Two figures { value, error } as a difference with its error.
export function difference(a, b) {
  return { value: b.value - a.value, error: Math.hypot(a.error, b.error) };
}
