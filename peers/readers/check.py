"""Other programs read the files that `cargo xtask readers` wrote, and write files for it to read.

usage: check.py read FOLDER         FOLDER/manifest.json lists the files; prints a JSON list of what each program said of each
       check.py write FOLDER        writes files and FOLDER/manifest.json
       check.py time FILE RUNS      prints the fastest times of trimesh as JSON

Facts are compared, not bytes: the number of triangles, that the surface is closed once equal vertices are merged, the volume.
"""

import atexit
import contextlib
import functools
import gzip
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

import manifold3d
import numpy as np
import trimesh

# Volumes agree up to this part: files may hold 32-bit floats.
PART = 1e-6
# ADMesh adds up in single precision, and prints six decimals.
COARSE_PART = 1e-4
COARSE_DIGIT = 1e-6

# The names that programs know a format by.
ENDINGS = {"stl-ascii": "stl", "ply-ascii": "ply", "ply-big-endian": "ply"}


# What programs are known not to read, with the facets it holds for. It is tried all the same: what begins to pass is a
# failure until it is taken off this list.
KNOWN = [
    (
        ["trimesh", "Manifold"],
        ["off"],
        lambda least, most: least < most and most > 4,
        "trimesh reads OFF with facets of 3 and 4 corners, or all of the same number; the files with triangles stand for these",
    ),
    (
        ["trimesh", "Manifold"],
        ["ply", "ply-big-endian"],
        lambda least, most: least < most,
        "trimesh reads binary PLY if all facets have the same number of corners; the files with triangles stand for these",
    ),
    (
        ["assimp"],
        ["off"],
        lambda least, most: most > 9,
        "assimp leaves out facets of OFF with more than 9 corners; the files with triangles stand for these",
    ),
    (
        ["MeshLab"],
        ["off"],
        lambda least, most: most > 4,
        "MeshLab cuts facets of OFF with more than 4 corners at wrong vertices; the files with triangles stand for these",
    ),
    (
        ["MeshLab"],
        ["ply-big-endian"],
        lambda least, most: True,
        "MeshLab does not turn round the bytes of doubles",
    ),
]


class Skip(Exception):
    """The program cannot be asked, with the reason."""


class Fail(Exception):
    """The program says something else."""


def as_mesh(loaded):
    """One mesh: scenes (3MF, glTF, several objects) are put together, with their transformations."""
    if isinstance(loaded, trimesh.Scene):
        return loaded.to_mesh()
    if not isinstance(loaded, trimesh.Trimesh):
        raise Fail(f"it is a {type(loaded).__name__}, not a mesh")
    return loaded


def check_facts(mesh, entry):
    """Counts, closedness and volume of a trimesh that was loaded as it stands."""
    if len(mesh.faces) != entry["triangles"]:
        raise Fail(f"{len(mesh.faces)} triangles, not {entry['triangles']}")
    mesh.merge_vertices(merge_tex=True, merge_norm=True)
    if len(mesh.vertices) != entry["vertices"]:
        raise Fail(f"{len(mesh.vertices)} vertices, not {entry['vertices']}")
    if not mesh.is_watertight:
        raise Fail("it is not watertight")
    if not mesh.is_winding_consistent:
        raise Fail("its facets are not oriented alike")
    check_volume(mesh.volume, entry)


def check_volume(volume, entry, part=PART, digit=0):
    if abs(volume - entry["volume"]) > part * abs(entry["volume"]) + digit:
        raise Fail(f"the volume is {volume!r}, not {entry['volume']!r}")


def load(path, entry):
    with open(path, "rb") as file:
        return trimesh.load(file, file_type=ENDINGS.get(entry["format"], entry["format"]), process=False)


def by_trimesh(path, entry):
    loaded = load(path, entry)
    if entry["format"] == "3mf" and entry["unit"] and loaded.units != entry["unit"]:
        raise Fail(f"the unit is {loaded.units}, not {entry['unit']}")
    check_facts(as_mesh(loaded), entry)


def by_manifold(path, entry):
    """Manifold has no readers: it gets what trimesh read, without merged vertices, and merges them itself."""
    loaded = as_mesh(load(path, entry))
    mesh = manifold3d.Mesh(
        vert_properties=np.ascontiguousarray(loaded.vertices, dtype=np.float32),
        tri_verts=np.ascontiguousarray(loaded.faces, dtype=np.uint32),
    )
    mesh.merge()
    solid = manifold3d.Manifold(mesh)
    if solid.status() != manifold3d.Error.NoError:
        raise Fail(f"status {solid.status().name}")
    check_volume(solid.volume(), entry)


def by_assimp(path, entry):
    """Reads the file and writes it as binary STL, which trimesh measures."""
    if not shutil.which("assimp"):
        raise Skip("it is not installed (apt-get install assimp-utils)")
    if entry["format"] == "wrl" and not knows_vrml():
        raise Skip("this build has no reader for VRML")
    with tempfile.TemporaryDirectory() as folder:
        copy = os.path.join(folder, "copy.stl")
        output = run(["assimp", "export", path, copy, "-fstlb"])
        if not os.path.exists(copy):
            raise Fail(output)
        check_facts(trimesh.load(copy, process=False), entry)


def knows_vrml():
    return subprocess.run(["assimp", "knowext", "wrl"], capture_output=True, check=False).returncode == 0


def by_admesh(path, entry):
    """Prints what it had to mend."""
    if not shutil.which("admesh"):
        raise Skip("it is not installed (apt-get install admesh)")
    output = run(["admesh", path])

    def number(name):
        found = re.search(rf"{name}\s*:\s*(\S+)", output)
        if not found:
            raise Fail(output)
        return float(found.group(1))

    if number("Number of facets") != entry["triangles"]:
        raise Fail(f"{number('Number of facets')} facets, not {entry['triangles']}")
    for name in ["Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets reversed", "Backwards edges", "Normals fixed"]:
        if number(name) != 0:
            raise Fail(f"{name}: {number(name):g}")
    check_volume(number("Volume"), entry, COARSE_PART, COARSE_DIGIT)


def by_meshlab(path, entry):
    """The package of it for Python."""
    try:
        import pymeshlab
    except ImportError as error:
        raise Skip(f"pymeshlab is not installed ({error})") from None
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(path)
    if meshes.mesh_number() > 1:
        meshes.generate_by_merging_visible_meshes(mergevertices=False)
    mesh = meshes.current_mesh()
    check_facts(trimesh.Trimesh(mesh.vertex_matrix(), mesh.face_matrix(), process=False), entry)


def run(command):
    """What a program printed; the last line of it, if it failed."""
    result = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=60, check=False)
    output = result.stdout + result.stderr
    if result.returncode:
        lines = output.strip().splitlines()
        raise Fail(f"{command[0]} ended with {result.returncode}: {lines[-1] if lines else 'no message'}")
    return output


def by_coin(path, entry):
    """Reads VRML with all of its language, so that files with exact coordinates are tried too."""
    if not shutil.which("g++"):
        raise Skip("g++ is not installed (apt-get install g++)")
    driver = coin_driver()
    if not driver:
        raise Skip("it is not installed (apt-get install libcoin-dev)")
    triangles, volume = run([driver, path]).splitlines()[-1].split()
    if int(triangles) != entry["triangles"]:
        raise Fail(f"{triangles} triangles, not {entry['triangles']}")
    check_volume(float(volume), entry)


@functools.cache
def coin_driver():
    """The program of coin.cpp, built once; nothing where the library is missing."""
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "coin.cpp")
    program = os.path.join(tempfile.mkdtemp(prefix="coin-"), "coin")
    atexit.register(shutil.rmtree, os.path.dirname(program), ignore_errors=True)
    command = ["g++", "-std=c++17", "-O1", source, "-o", program, "-lCoin"]
    built = subprocess.run(command, capture_output=True, check=False)
    return program if built.returncode == 0 else None


MESHES = {"off", "obj", "stl", "stl-ascii", "ply", "ply-big-endian", "ply-ascii", "3mf"}

# The programs with the formats that they have readers for. Manifold has none and gets what trimesh read.
READERS = {
    "trimesh": (by_trimesh, MESHES | {"glb"}),
    "Manifold": (by_manifold, MESHES | {"glb"}),
    "assimp": (by_assimp, MESHES | {"glb", "wrl"}),
    "MeshLab": (by_meshlab, MESHES | {"wrl"}),
    "ADMesh": (by_admesh, {"stl", "stl-ascii"}),
    "Coin": (by_coin, {"wrl"}),
}


def known(reader, entry):
    """Why this program is known not to read this file, if so."""
    for readers, formats, holds, why in KNOWN:
        if reader in readers and entry["format"] in formats and holds(*entry["corners"]):
            return why
    return None


def ask(reader, check, path, entry):
    """The result and the reason of it."""
    limit = known(reader, entry)
    try:
        if entry["alone"] and check is not by_coin:
            raise Skip(entry["alone"])
        check(path, entry)
    except Skip as why:
        return "skipped", str(why)
    except Exception as why:  # programs fail in any way
        return ("skipped", limit) if limit else ("failed", f"{type(why).__name__}: {why}")
    return ("failed", f"it passes now, but is listed: {limit}") if limit else ("passed", "")


def read(folder):
    with open(os.path.join(folder, "manifest.json"), encoding="utf-8") as file:
        manifest = json.load(file)
    report = []
    with tempfile.TemporaryDirectory() as unpacked:
        for entry in manifest:
            path = os.path.join(folder, entry["file"])
            if entry["gzip"]:
                # Unpacked by Python: that gzip around a file is as others make it.
                name = os.path.join(unpacked, entry["file"].removesuffix(".gz"))
                with gzip.open(path) as source, open(name, "wb") as target:
                    shutil.copyfileobj(source, target)
                path = name
            for reader, (check, formats) in READERS.items():
                if entry["format"] in formats:
                    result, why = ask(reader, check, path, entry)
                    report.append({"file": entry["file"], "row": entry["row"], "reader": reader, "result": result, "why": why})
    return report


def write(folder):
    """A sphere of many triangles and a box with flat edges, as trimesh writes them; volumes as it sees them."""
    sphere = trimesh.creation.icosphere(subdivisions=3)
    box = trimesh.creation.box(extents=[1, 2, 3.5])
    kinds = [
        ("stl", "stl", "stl", {}),
        ("stl-ascii", "stl", "stl_ascii", {}),
        ("obj", "obj", "obj", {}),
        ("off", "off", "off", {}),
        ("ply", "ply", "ply", {"encoding": "binary"}),
        ("ply-ascii", "ply", "ply", {"encoding": "ascii"}),
        ("3mf", "3mf", "3mf", {}),
    ]
    manifest = []
    for name, mesh, facts in [
        ("sphere", sphere, {"vertices": len(sphere.vertices), "facets": len(sphere.faces)}),
        ("box", box, {"vertices": 8, "facets": 6}),
    ]:
        for kind, ending, file_type, options in kinds:
            file = f"{name}.{kind}.{ending}"
            content = trimesh.exchange.export.export_mesh(mesh, None, file_type=file_type, **options)
            with open(os.path.join(folder, file), "wb") as out:
                out.write(content.encode() if isinstance(content, str) else content)
            entry = {"file": file, "format": kind, "writer": "trimesh", "triangles": len(mesh.faces)}
            manifest.append(entry | facts | {"volume": float(mesh.volume)})
    with open(os.path.join(folder, "manifest.json"), "w", encoding="utf-8") as out:
        json.dump(manifest, out, indent=2)
    return len(manifest)


def fastest(path, runs):
    def best(**options):
        times = []
        for _ in range(runs):
            begin = time.perf_counter()
            mesh = trimesh.load(path, **options)
            times.append(time.perf_counter() - begin)
        return min(times), mesh

    seconds, mesh = best()
    raw, _ = best(process=False)
    return {"seconds": seconds, "raw_seconds": raw, "triangles": len(mesh.faces), "vertices": len(mesh.vertices)}


def main():
    verb, path = sys.argv[1:3]
    # Programs that print must not stand in the way of the answer.
    with contextlib.redirect_stdout(sys.stderr):
        answer = {"read": read, "write": write, "time": lambda file: fastest(file, int(sys.argv[3]))}[verb](path)
    print(json.dumps(answer))


if __name__ == "__main__":
    main()
