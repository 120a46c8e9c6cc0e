// Friction in balls and hinges of a model of mujoco-js, MuJoCo's bindings for
// JavaScript: the adapter of apps/hosts/mujoco, with its limits, Euler's step
// and reactions of the step before. A joint that friction holds has a rate of
// exactly 0, and its angles do not change by a bit.
//   const friction = new HingeFriction(mujoco, model, await load());
//   friction.add('hip', joint);
//   while (data.time < 60) friction.step(data);  // in place of mj_step()
const BALL = 1;   // mjtJoint
const HINGE = 3;
const LINEAR = 1; // mjCNSTRSTATE_QUADRATIC
const TURN_LIMIT = 50;

export class HingeFriction {
  #mujoco;
  #model;
  #contact;
  #hinges = [];
  #mechanism;
  #hasReactions = false;
  #smooth;

  constructor(mujoco, model, contact) {
    this.#mujoco = mujoco;
    this.#model = model;
    this.#contact = contact;
    if (model.opt.integrator !== mujoco.mjtIntegrator.mjINT_EULER.value ||
        model.dof_damping.some((x) => x !== 0)) {
      throw new Error('the integrator must be Euler, and joints have no damping');
    }
    // Buffers that the bindings fill.
    this.full = new mujoco.DoubleBuffer(model.nv * model.nv);
    this.rates = new mujoco.DoubleBuffer(model.nv);
  }

  add(name, joint) {
    const m = this.#model;
    const {mj_name2id, mjtObj} = this.#mujoco;
    const id = mj_name2id(m, mjtObj.mjOBJ_JOINT.value, name);
    const kind = {[BALL]: 'ball', [HINGE]: 'pin'}[m.jnt_type[id]];
    if (id < 0 || kind !== joint.kind) {
      throw new Error(`joint "${name}" must be a joint of the model, a ball or hinge`);
    }
    if (joint.has_seat && joint.body_has_inner) {
      throw new Error(`joint "${name}" must have its seat in the body`);
    }
    this.#hinges.push({id, joint, body: m.jnt_bodyid[id], first: m.jnt_dofadr[id],
                       size: kind === 'ball' ? 3 : 1, angle: m.jnt_qposadr[id]});
    this.#mechanism = undefined;  // made anew with all hinges
  }

  // In the place of mj_step().
  step(d) {
    const [mj, m] = [this.#mujoco, this.#model];
    const mechanism = this.#mechanism ??=
        new this.#contact.Mechanism(this.#hinges, m.nv);
    const likely = this.#ratesAtEnd(d);
    mj.mj_forward(m, d);
    this.#smooth = Float64Array.from(d.qfrc_smooth);
    let force = new Float64Array(m.nv);
    this.#weigh(d);
    if (!this.#hasReactions) {  // as if rates stayed as they are
      force = mechanism.hold(d.qvel, this.#ratesAtEnd(d));
      this.#accelerate(d, force);
      mj.mj_rnePostConstraint(m, d);
      this.#hasReactions = true;
    }
    mechanism.begin(this.#hinges.map((h) => this.#start(h, d)), d.qvel, likely);
    for (this.turns = 1; ; ++this.turns) {
      const change = mechanism.turn(this.#ratesAtEnd(d), force);
      this.#accelerate(d, force);
      if (d.nefc === 0 || change <= 1e-8 || this.turns === TURN_LIMIT) break;
      this.#weigh(d);
    }
    mj.mj_rnePostConstraint(m, d);
    this.#finish(d);
  }

  #ratesAtEnd(d) {
    return Float64Array.from(d.qvel, (v, i) =>
        v + this.#model.opt.timestep * d.qacc[i]);
  }
  // Of balls in the axes of their body, of hinges in those of the world.
  #start({id, body, size}, d) {
    const reaction = d.cfrc_int.slice(6 * body + 3, 6 * body + 6);
    if (size === 1) return {reaction, axis: d.xaxis.slice(3 * id, 3 * id + 3)};
    const axes = d.xmat.slice(9 * body, 9 * body + 9);
    return {reaction: [0, 1, 2].map((c) => axes[c] * reaction[0] +
        axes[3 + c] * reaction[1] + axes[6 + c] * reaction[2])};
  }
  #weigh(d) {
    const [mj, m] = [this.#mujoco, this.#model];
    mj.mj_fullM(m, this.full, d.qM);
    const rows = [];
    const stiffness = [];
    for (let k = 0; k < d.nefc; ++k) {
      if (d.efc_state[k] !== LINEAR) continue;
      const one = new Array(d.nefc).fill(0);
      one[k] = 1;
      mj.mj_mulJacTVec(m, d, this.rates, one);
      rows.push(...this.rates.GetView());
      stiffness.push(d.efc_D[k]);
    }
    this.#mechanism.weigh(this.full.GetView(), rows, stiffness, m.opt.timestep);
  }
  #accelerate(d, force) {
    const [mj, m] = [this.#mujoco, this.#model];
    const all = this.#smooth.map((x, i) => x + force[i]);
    d.qfrc_smooth.set(all);
    if (d.nefc > 0) {
      mj.mj_solveM(m, d, this.rates, all);
      d.qacc_smooth.set(this.rates.GetView());
      mj.mj_fwdConstraint(m, d);
      all.forEach((x, i) => { all[i] = x + d.qfrc_constraint[i]; });
    }
    mj.mj_solveM(m, d, this.rates, all);
    d.qacc.set(this.rates.GetView());
  }
  // Joints that friction holds stay where they are.
  #finish(d) {
    const kept = Float64Array.from(d.qpos);
    this.#mujoco.mj_Euler(this.#model, d);
    this.#hinges.forEach(({first, size, angle}, i) => {
      if (!this.#mechanism.get(i).holds) return;
      const angles = size === 3 ? 4 : 1;
      d.qvel.fill(0, first, first + size);
      d.qpos.set(kept.slice(angle, angle + angles), angle);
    });
  }
}
