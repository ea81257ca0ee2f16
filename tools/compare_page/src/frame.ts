// SPDX-License-Identifier: MIT
// The frame of the 3D view: surfaces of any size and place are moved to the origin and scaled to a diagonal of 1.

export class Frame {
  private readonly centre_: [number, number, number];
  readonly diagonal: number;

  /**
   * The frame of a surface: 3 coordinates a vertex. Throws an Error where they do not span anything in 32-bit
   * numbers.
   */
  constructor(positions: Float32Array) {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    positions.forEach((value, i) => {
      low[i % 3] = Math.min(low[i % 3]!, value);
      high[i % 3] = Math.max(high[i % 3]!, value);
    });
    const middle = (axis: number) => (low[axis]! + high[axis]!) / 2;
    this.centre_ = [middle(0), middle(1), middle(2)];
    this.diagonal = Math.hypot(...high.map((value, axis) => value - low[axis]!));
    if (!(this.diagonal > 0 && Number.isFinite(this.diagonal)))
      throw new Error("the coordinates of the surface are too large or too small for 32-bit numbers");
  }

  /** Positions in the frame. */
  place(positions: ArrayLike<number>): Float32Array {
    return Float32Array.from(positions, (value, i) => (value - this.centre_[i % 3]!) / this.diagonal);
  }
}
