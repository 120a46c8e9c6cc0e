"""Two stages turn apart, with and without friction, and when they let go."""

import libcontact
import matplotlib.pyplot as plt
from picture import data, finish

stages = libcontact.Case.from_file(data / "cases/two_stage_turn.toml")

figure, (angle, reaction) = plt.subplots(
    2, 1, sharex=True, figsize=(6.5, 5), height_ratios=[2, 1])
for friction, colour in ("full", "C0"), ("traditional", "C3"), ("ideal", "0.5"):
    outcome = stages.replace({"run.friction": friction}).run()
    history = outcome.history
    angle.plot(history["time_s"], history["stage.angle_deg"], colour,
               label=friction)
    reaction.plot(history["time_s"], history["stage.reaction_N"] / 1e6, colour)
    for event in outcome.events:
        for axis in angle, reaction:
            axis.axvline(event.time, color=colour, lw=0.8, ls=":")
angle.set(ylabel="angle of the stage, deg",
          title="Two stages turn apart (dotted: the hinge lets go)")
angle.legend(title="friction")
reaction.set(xlabel="time, s", ylabel="reaction, MN", ylim=(0, None))
finish()
