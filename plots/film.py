"""film.py FOLDER FILM.gif: the pictures of film.js one after the other, by
python3-pil, for pages that show no video."""

import sys
from pathlib import Path

from PIL import Image

files = sorted(Path(sys.argv[1]).glob("*.png"))
frames = [Image.open(file).convert("RGB") for file in files]
# The page gives a picture less height while it says more below it.
size = min(frame.size for frame in frames)
frames = [frame.resize(size, Image.Resampling.LANCZOS) for frame in frames]
several = Image.new("RGB", (frames[0].width, 3 * frames[0].height))
for i in range(3):
    several.paste(frames[i * (len(frames) - 1) // 2], (0, i * frames[0].height))
palette = several.quantize(160)
small = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
# The last one stays for a second.
times = [70] * (len(small) - 1) + [1000]
small[0].save(
    sys.argv[2], save_all=True, append_images=small[1:], duration=times, loop=0,
    optimize=True,
)  # fmt: skip
