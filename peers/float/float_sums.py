"""The floating-point peers: Manifold's minkowski_sum and SciPy's hull of all pairwise sums.

usage: float_sums.py manifold|scipy A B [LEAST [SECONDS]]

Prints one JSON object on one line, read by `cargo xtask peers`. Times are CPU seconds of the process, which is bound to one
processor first, so that a library with a thread pool is measured on one thread like everything else. `user_seconds` leaves out
what the system spent on it, which is mostly memory that is touched for the first time.
"""

import json
import os
import resource
import statistics
import sys
import time
from fractions import Fraction
from importlib.metadata import version

os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})

import numpy as np  # noqa: E402  (the thread pools are made at import)


def read_off(name):
    """The nearest doubles of the coordinates, and the triangles (facets are cut into fans)."""
    with open(name, encoding="ascii") as file:
        words = iter([word for line in file for word in line.split("#")[0].split()])
    if next(words) != "OFF":
        raise ValueError(f"no OFF header in {name}")
    vertices, facets, _ = (int(next(words)) for _ in range(3))
    points = np.array([[float(Fraction(next(words))) for _ in range(3)] for _ in range(vertices)])
    triangles = []
    for _ in range(facets):
        cycle = [int(next(words)) for _ in range(int(next(words)))]
        triangles += [[cycle[0], cycle[k], cycle[k + 1]] for k in range(1, len(cycle) - 1)]
    return points, np.array(triangles, dtype=np.uint64)


def manifold(a, b):
    import manifold3d

    def run():
        clock = [time.process_time()]
        operands = [manifold3d.Manifold(manifold3d.Mesh64(p, t)) for p, t in (a, b)]
        for operand in operands:
            operand.num_tri()  # evaluation is lazy
        clock.append(time.process_time())
        result = operands[0].minkowski_sum(operands[1])
        result.num_tri()
        clock.append(time.process_time())
        mesh = result.to_mesh64()
        clock.append(time.process_time())
        return clock, len(mesh.vert_properties), len(mesh.tri_verts)

    return run, ["build", "sum", "mesh"], f"manifold3d {version('manifold3d')}"


def scipy(a, b):
    from scipy.spatial import ConvexHull

    def run():
        clock = [time.process_time()]
        sums = (a[0][:, None] + b[0][None]).reshape(-1, 3)
        clock.append(time.process_time())
        hull = ConvexHull(sums)
        clock.append(time.process_time())
        return clock, len(hull.vertices), len(hull.simplices)

    return run, ["pairwise_sums", "hull"], f"scipy {version('scipy')}"


def main():
    method, name_a, name_b = sys.argv[1:4]
    least = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    budget = float(sys.argv[5]) if len(sys.argv) > 5 else 1.0
    run, names, what = {"manifold": manifold, "scipy": scipy}[method](read_off(name_a), read_off(name_b))
    phases, totals, user = [], [], []
    while len(totals) < least or (sum(totals) < budget and len(totals) < 2000):
        before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
        clock, vertices, triangles = run()
        user.append(resource.getrusage(resource.RUSAGE_SELF).ru_utime - before)
        phases.append([end - start for start, end in zip(clock, clock[1:])])
        totals.append(clock[-1] - clock[0])
    medians = {name: statistics.median(p[i] for p in phases) for i, name in enumerate(names)}
    report = {
        "method": method,
        "version": f"{what}, numpy {version('numpy')}",
        "repetitions": len(totals),
        "seconds": statistics.median(totals),
        "phases": medians,
        "user_seconds": statistics.median(user),
        "vertices": vertices,
        "triangles": triangles,
    }
    print(json.dumps(report))


if __name__ == "__main__":
    main()
