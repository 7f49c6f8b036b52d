"""The frames of a run for the replay in its page: numbers as bytes, small enough to be carried in it.

Places are 16-bit steps of the box around everything (a few micrometres), attitudes 16-bit quaternions. Where the
frames would take more than MOST_BYTES, every second or third one is left out. Needs h5py.
"""

import base64

import field_series
import numpy as np
from report_stones import NoReplay, Stones
from report_surfaces import surfaces
from report_walls import walls
from run_files import number, of_ribs

MOST_BYTES = 9e6  # of frames; in base64, with libraries and curves, a page below 15 MB


def packed(values, kind):
    """Bytes of an array, little-endian, as text: what page.js unpacks by the same kind."""
    return {"kind": kind, "data": base64.b64encode(np.ascontiguousarray(values, dtype="<" + kind).tobytes()).decode()}


def packed_mesh(points, triangles):
    return {"vertices": packed(points, "f4"), "triangles": packed(triangles, "u2")}


class Steps:
    """Places as whole numbers of steps from the lowest corner of a box, the same step along all axes."""

    def __init__(self, low, high):
        self.low, self.step = low, float(np.max(high - low)) / 65535

    def of(self, points):
        return packed(np.clip(np.rint((points - self.low) / self.step), 0, 65535), "u2")


class Frames:
    """What is read of a run: times, and for each of them stones, geogrid, contacts."""

    def __init__(self, run):
        self.series = {name: field_series.open_series(run, name) for name in ("clumps", "geogrid", "contacts")}
        self.clumps, self.geogrid = self.series["clumps"], self.series["geogrid"]
        if self.clumps is None:
            raise NoReplay("The run has written no frames: Output/Field frames (of a heap, Output/Frame interval) in "
                           "the parameter file asks for them.")
        self.stones = Stones(run)
        self.chosen = range(len(self.clumps))
        per_frame = 14 * len(self.stones.ids)
        if self.series["contacts"]:
            per_frame += 21 * len(self.series["contacts"].lines(len(self.series["contacts"]) - 1))
        stride = int(np.ceil(per_frame * len(self.clumps) / MOST_BYTES))
        if stride > 1:  # the last one is always there
            self.chosen = range((len(self.clumps) - 1) % stride, len(self.clumps), stride)
        self.times = [self.clumps.time(frame) for frame in self.chosen]

    def same_time(self, name, time):
        """The frame of another series that belongs to this time; None where it has none, for lack of contacts."""
        series = self.series[name]
        if series is None:
            return None
        frame = series.frame_at(time)
        return frame if abs(series.time(frame) - time) < 1e-9 + 1e-6 * abs(time) else None


def replay(run, parameters, history, surface_file, no_surfaces):
    frames = Frames(run)
    poses = [frames.stones.poses(frames.clumps, frame) for frame in frames.chosen]
    shapes = surfaces(frames.stones.shapes, surface_file)
    reach = max(float(np.linalg.norm(shape.fine[0], axis=1).max()) for shape in shapes)
    there = np.concatenate([centres[attitudes.any(axis=1)] for centres, attitudes in poses])
    ribs = [frames.geogrid.points(frames.geogrid.frame_at(time)) for time in frames.times] if frames.geogrid else []
    everything = np.concatenate([there] + ribs)
    steps = Steps(everything.min(axis=0) - reach, everything.max(axis=0) + reach)
    result = {
        "times": frames.times, "left_out": len(frames.clumps) - len(frames.times),
        "low": steps.low.tolist(), "step": steps.step,
        "shapes": [{"fine": packed_mesh(*shape.fine), "coarse": packed_mesh(*shape.coarse)} for shape in shapes],
        "surfaces": describe_surfaces(shapes, no_surfaces),
        "stones": describe_stones(frames.stones, shapes, poses, steps),
        "contacts": contacts(frames, steps),
        "walls": walls(run, frames, history),
    }
    if ribs:
        result["geogrid"] = geogrid(frames, ribs, steps, parameters)
    return result


def describe_surfaces(shapes, no_surfaces):
    own, count = sum(shape.is_own for shape in shapes), len(shapes)
    most = max(len(shape.fine[1]) for shape in shapes)
    if own:
        text = f"Stones are drawn with their own closed surfaces, decimated to at most {most} triangles by quadric " \
               "edge collapse; contacts are computed with the spheres of their clumps."
        return text if own == count else text + f" {count - own} of {count} shapes are drawn as their spheres."
    return "Stones are drawn as the outer surface of their spheres, seen from the centre of mass in 162 directions" \
        + (f": {no_surfaces}" if no_surfaces else ".")


def describe_stones(stones, shapes, poses, steps):
    size = [float(np.ptp(shape.fine[0] @ principal_axes(shape.fine[0]), axis=0).max()) for shape in shapes]
    return {
        "ids": stones.ids.tolist(), "shape": stones.shape.tolist(),
        "names": [shape["name"] for shape in stones.shapes],
        "mass": [float(f"{mass:.5g}") for mass in stones.mass], "is_load": stones.is_load.astype(int).tolist(),
        "longest": [float(f"{value:.4g}") for value in size],
        "mean_size": [float(f"{(6 * shape['volume'] / np.pi) ** (1 / 3):.4g}") for shape in stones.shapes],
        "places": steps.of(np.array([centres for centres, _ in poses])),
        "attitudes": packed(np.rint(32767 * np.array([attitudes for _, attitudes in poses])), "i2"),
    }


def principal_axes(points):
    return np.linalg.eigh(np.cov((points - points.mean(axis=0)).T))[1]


def section_of_ribs(parameters):
    """Width and thickness that all ribs are drawn with: of those along the pull, or some where the run does not say [m]."""
    width, thickness = (of_ribs(parameters, "Rib " + name, "along") for name in ("width", "thickness"))
    return {"width": width if width > 0 else 3e-3, "thickness": thickness if thickness > 0 else 1e-3}


def geogrid(frames, ribs, steps, parameters):
    chosen = [frames.geogrid.frame_at(time) for time in frames.times]
    return {
        "lines": packed(frames.geogrid.lines(0), "u2"), "points": steps.of(np.array(ribs)),
        "force": packed(np.array([frames.geogrid.attribute(frame, "axial_force") for frame in chosen]), "f4"),
        **section_of_ribs(parameters),
    }


def contacts(frames, steps):
    """Of all frames one after the other; `starts` says where each begins."""
    starts, ends, force, kind, stones = [0], [], [], [], []
    for time in frames.times:
        frame = frames.same_time("contacts", time)
        if frame is not None:
            series = frames.series["contacts"]
            lines, bodies = series.lines(frame), series.attribute(frame, "body")
            what = series.attribute(frame, "kind").astype(int)
            pair = np.searchsorted(frames.stones.ids, bodies[lines].astype(int))
            pair[what != 0, 1] = 65535  # a wall or a rib
            ends.append(series.points(frame)[lines].reshape(-1, 6))
            force.append(series.attribute(frame, "force"))
            kind.append(what)
            stones.append(pair)
        starts.append(starts[-1] + (len(kind[-1]) if frame is not None else 0))
    if not kind:
        return None
    return {"starts": starts, "ends": steps.of(np.concatenate(ends).reshape(-1, 2, 3)),
            "force": packed(np.concatenate(force), "f4"), "of": packed(np.concatenate(kind), "u1"),
            "stones": packed(np.concatenate(stones), "u2")}
