"""Solves one generic Stewart-Gough platform by all 128 paths and writes what `kinematics.assembly_modes` starts from.

python bench/general_platform.py            # writes src/kinetruss/kinematics/data/general_platform.json
python bench/general_platform.py --seed 2   # another generic platform
"""

import argparse
import json

import numpy as np

from kinetruss.kinematics.homotopy import _Homotopy, _Powers, followed
from kinetruss.kinematics.known_platform import KNOWN, Platform


def made(seed):
    """Joints and squared lengths at random, complex; and every pose with q[0] = 1 (the excess of the quadrics has q = 0)."""
    rng = np.random.default_rng(seed)

    def drawn(*shape):
        return rng.normal(size=shape) + 1j * rng.normal(size=shape)

    platform = Platform(p=drawn(6, 3), b=drawn(6, 3), squares=drawn(6))
    powers = _Powers(np.zeros(7, bool), rng)
    found = followed(_Homotopy(platform, powers, np.exp(2j * np.pi * rng.uniform()), rng), powers.solutions())
    z = np.concatenate([np.ones((len(found.u), 1)), found.u], axis=1)
    N = np.abs(np.sum(z[:, :4] ** 2, axis=1))
    z = z[N > 1e-8]
    if len(z) != 40:
        raise SystemExit(f"{len(z)} solutions, {found.lost} paths lost: take another seed")
    return {"p": platform.p, "b": platform.b, "l2": platform.squares, "z": z}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=1)
    seed = parser.parse_args().seed
    numbers = {key: {"real": y.real.tolist(), "imaginary": y.imag.tolist()} for key, y in made(seed).items()}
    text = f"made by bench/general_platform.py --seed {seed}: data at random, all solutions off q = 0 of 128 paths"
    KNOWN.parent.mkdir(exist_ok=True)
    KNOWN.write_text(json.dumps({"provenance": text} | numbers) + "\n")
    print(f"wrote {KNOWN}")
