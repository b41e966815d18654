"""The floating-point peer of arrangements: GEOS nodes segments, called by shapely.

usage: node_segments.py CURVES [LEAST [SECONDS]]

CURVES has one segment a line, `segment x1 y1 x2 y2`. Prints one JSON object on one line, read by `cargo xtask peers`. Times are
CPU seconds of the process, which is bound to one processor first. Noding makes vertices and edges; there are no faces.
"""

import json
import os
import resource
import statistics
import sys
import time

os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})

import numpy as np  # noqa: E402  (the thread pools are made at import)
import shapely  # noqa: E402


def read_segments(name):
    """The coordinates as an array of shape (n, 2, 2), and the hash of all numbers in order."""
    numbers, folded = [], 0xCBF29CE484222325
    with open(name, encoding="ascii") as file:
        for line in file:
            kind, *words = line.split()
            if kind != "segment" or len(words) != 4:
                raise ValueError(f"not a segment: {line.strip()}")
            numbers += [int(word) for word in words]
    for number in numbers:
        folded = ((folded ^ (number % 2**64)) * 0x100000001B3) % 2**64
    return np.array(numbers, dtype=float).reshape(-1, 2, 2), folded


def peak_bytes():
    """The largest resident set of this process so far."""
    with open("/proc/self/status", encoding="ascii") as file:
        return next(1024 * int(line.split()[1]) for line in file if line.startswith("VmHWM:"))


def main():
    segments, folded = read_segments(sys.argv[1])
    least = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    budget = float(sys.argv[3]) if len(sys.argv) > 3 else 1.0
    lines = shapely.multilinestrings(shapely.linestrings(segments))
    seconds, user, peak = [], [], 0
    while len(seconds) < least or (sum(seconds) < budget and len(seconds) < 2000):
        before, begin = resource.getrusage(resource.RUSAGE_SELF).ru_utime, time.process_time()
        noded = shapely.node(lines)
        seconds.append(time.process_time() - begin)
        user.append(resource.getrusage(resource.RUSAGE_SELF).ru_utime - before)
        peak = peak or peak_bytes()
    edges = shapely.get_parts(noded)
    ends = shapely.get_coordinates(edges)
    print(
        json.dumps(
            {
                "method": "geos",
                "version": f"GEOS {shapely.geos_version_string}, shapely {shapely.__version__}, numpy {np.__version__}",
                "input_hash": f"{folded:016x}",
                "repetitions": len(seconds),
                "seconds": statistics.median(seconds),
                "user_seconds": statistics.median(user),
                "peak_bytes": peak,
                "vertices": len(np.unique(ends, axis=0)),
                "edges": int(np.sum(shapely.get_num_coordinates(edges) - 1)),
            }
        )
    )


if __name__ == "__main__":
    main()
