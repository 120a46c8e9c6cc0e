"""Helpers shared by the pictures of the gallery."""

import sys
from pathlib import Path

import matplotlib.pyplot as plt

data = Path(__file__).resolve().parents[3] / "data"

plt.rcParams.update({
    "figure.constrained_layout.use": True,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "font.size": 9,
    "legend.frameon": False,
})


def finish() -> None:
    """Writes the picture to the file that was asked for, or shows it."""
    if len(sys.argv) > 1:
        plt.savefig(sys.argv[1], dpi=90)
    else:
        plt.show()
