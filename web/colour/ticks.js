// SPDX-License-Identifier: MIT
/**
 * @file Which numbers stand below the colours of a legend, so that none overlaps another.
 */

/**
 * Where the labels of ticks stand: the first begins at its end of the scale, the last ends at the other, and all others are
 * centred below their ticks. The ends are kept, and of the others, from the middle outwards, those with room.
 * @param {number[]} positions of the ticks, rising, from 0 to 1
 * @param {number[]} widths of their labels
 * @param {number} width of the scale, in the same unit
 * @param {number} gap the least distance of two labels
 * @returns {boolean[]} which labels are kept
 */
export function labelsWithRoom(positions, widths, width, gap) {
  const last = positions.length - 1;
  const boxes = positions.map((position, i) => {
    const left = i === 0 ? 0 : i === last ? width - widths[i] : position * width - widths[i] / 2;
    return { left, right: left + widths[i] };
  });
  const order = boxes.map((_, i) => i).slice(1, -1);
  order.sort((a, b) => Math.abs(positions[a] - 0.5) - Math.abs(positions[b] - 0.5) || a - b);
  const kept = positions.map(() => false);
  for (const i of [0, last, ...order]) {
    if (!boxes[i]) continue;
    kept[i] ||= boxes.every(
      (box, k) => k === i || !kept[k] || boxes[i].right + gap <= box.left || box.right + gap <= boxes[i].left,
    );
  }
  return kept;
}
