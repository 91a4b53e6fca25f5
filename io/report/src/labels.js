// Places for texts beside points, none over another or over a point where there is room.

const GAP = 7; // px, from a point to its text
const RISE = 5; // px, from a text's base line to its point
const LINE = 13; // px, a line of text
const MOST_LINES = 12;

const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

// The nearest first: beside the point, above or below, right or left of it; then line by line further.
function* candidates(point, width) {
  for (let line = 0; line <= MOST_LINES; ++line) {
    for (const base of [point.y - RISE - line * LINE, point.y + RISE + (line + 0.7) * LINE]) {
      for (const left of [point.x + GAP, point.x - GAP - width]) {
        yield { left, right: left + width, top: base - 0.8 * LINE, bottom: base + 0.2 * LINE, base, off: line > 0 };
      }
    }
  }
}

// points: [{ x, y, width }] in px, widths of their texts; frame: { left, right, top, bottom }. Gives each its
// { left, right, base, off }: off where it stands so far from its point that a line should join them.
// Points that have no neighbours keep their text to the upper right.
export function placeLabels(points, frame) {
  const taken = points.map(({ x, y }) => ({ left: x - 4, right: x + 4, top: y - 4, bottom: y + 4 }));
  const inside = (box) =>
    box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom;
  return points.map((point) => {
    let nearest = null; // where there is no room
    for (const box of candidates(point, point.width)) {
      nearest ??= box;
      if (!inside(box) || taken.some((other) => meet(box, other))) continue;
      taken.push(box);
      return box;
    }
    return nearest;
  });
}
