// SI units and radians; vectors are in any frame, the same for all of a call.
export type Vector = ArrayLike<number>;
export type Vector3 = [number, number, number];
export type Status = "ok" | "out_of_range" | "not_converged" | "bad_input"
    | "run_failed" | "failure" | "out_of_seat";
type Numbers = number | readonly number[];
type Value = Numbers | string | boolean;
type Table<T> = string | T | readonly T[];

/** A file, a key or a call that is refused: one line says why. */
export class ContactError extends Error {}

export interface Quantity {
  readonly key: string;
  readonly symbol: string;
  readonly unit: string;
  readonly meaning: string;
  readonly size: 1 | 3;
}

/** How the halves of a joint lie to each other. */
export interface Placement {
  /** Rotation from the axes of the body with the seat to those of the vectors,
   * row by row. */
  from_seat?: ArrayLike<number>;
  /** Slope of a pin's axis in its hole. */
  tilt?: Vector;
  /** The reaction acts here along the pin from its middle, m; the tilt is found. */
  place?: number;
  /** Of the body along the pin's axis, m/s. */
  axial_velocity?: number;
}

export interface SlipOptions<K extends keyof Answer = keyof Answer> {
  /** Unit axis of a pin; without one that of the angular velocity. */
  axis?: Vector;
  placement?: Placement;
  /** Quantities; without them all of the joint's. */
  keys?: readonly K[];
  /** Begins from the last solution of this joint that was. */
  warm?: boolean;
}

export interface StepStart {
  reaction: Vector;
  angular_velocity: Vector;
  /** The angular velocity at the end if there were no friction. */
  free: Vector;
  axis?: Vector;
}
export interface Step {
  readonly status: Status;
  /** It has come to rest, or rests on. */
  readonly holds: boolean;
  /** Exactly 0 where it holds. */
  readonly angular_velocity: Vector3;
  /** Of friction on the body. */
  readonly moment: Vector3;
}

/** What a slip answers: of contacts at rims and of pins that end, too. */
export interface Answer extends Solution, Rims, Lie {}
type Columns<K extends keyof Answer> =
    { [key in Exclude<K, "status">]: Float64Array } & { status: Status[] };

export declare class Joint {
  /** From the text of a joint file, or an object with its tables and keys;
   * settings as {"geometry.radius_mm": 25}. */
  constructor(joint: string | JointFile, settings?: Record<string, Value>);
  readonly kind: "ball" | "pin";
  readonly body_has_inner: boolean;
  readonly radius: number;
  readonly radial_clearance: number;
  /** NaN of a ball. */
  readonly length: number;
  readonly effective_modulus: number;
  readonly has_seat: boolean;
  /** Friction under a reaction, N, while the halves turn, rad/s. */
  solve<K extends keyof Answer = keyof Answer>(
      reaction: Vector, angular_velocity: Vector, options?: SlipOptions<K>):
      Pick<Answer, K | "status">;
  /** Many: three numbers a row, or three for all rows. Words are numbers. */
  solveRows<K extends keyof Answer = keyof Answer>(
      reactions: Float64Array, angular_velocities: Float64Array,
      options?: SlipOptions<K>): Columns<K>;
  /** Whether friction holds a moment on the body, N m. */
  atRest(reaction: Vector, moment: Vector, options?: { axis?: Vector }): Rest;
  /** One implicit step, M = W (Dw - free), W row by row. */
  step(start: StepStart, inertia: ArrayLike<number>): Step;
  /** The contact under a normal force, N. */
  patch<K extends keyof Patch = "half_angle" | "load_parameter"
      | "peak_pressure" | "mean_pressure" | "contact_area">(
      normal_force: number, keys?: readonly K[]): Pick<Patch, K>;
  /** Pa, at an angle from the contact's centre; 0 outside. */
  pressure(normal_force: number, theta: number): number;
  /** p v and heat over the contact. */
  rating(reaction: Vector, angular_velocity: Vector,
      options?: { axis?: Vector }): Rating;
  /** Limits that the joint exceeds, and those of a slip. */
  notes(reaction?: Vector, angular_velocity?: Vector,
      options?: { axis?: Vector }): string[];
  /** Gives its memory back now, not some time. */
  free(): void;
}

export interface MechanismStart {
  reaction: Vector;
  axis?: Vector;
  from_seat?: ArrayLike<number>;
}
/** Steps of a simulator's joints in its own rates, as libcontact/c/mechanism.h
 * says. */
export declare class Mechanism {
  constructor(joints: readonly { joint: Joint; first: number }[], size: number);
  weigh(inertia: ArrayLike<number>, rows: ArrayLike<number>,
      stiffness: ArrayLike<number>, time_step: number): void;
  begin(starts: readonly MechanismStart[], rates: ArrayLike<number>,
      likely: ArrayLike<number>): void;
  /** Replaces `force`; what it has changed by, over itself. */
  turn(rates_at_end: ArrayLike<number>, force: Float64Array): number;
  hold(rates: ArrayLike<number>, rates_at_end: ArrayLike<number>): Float64Array;
  get(i: number): Step;
  free(): void;
}

export interface Library {
  Joint: typeof Joint;
  Mechanism: typeof Mechanism;
  quantities: Record<"joint" | "solution" | "rest" | "patch" | "rating",
      readonly Quantity[]>;
  version: string;
}
/** From contact.wasm beside this file, or from bytes or another address. */
export function load(source?: string | URL | Uint8Array | WebAssembly.Module):
    Promise<Library>;

