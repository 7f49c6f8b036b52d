"""Shaded pictures of stones and clumps as arrays of colours, without a graphics card.

A parallel projection with a depth buffer: triangles are filled pixel by pixel, spheres are exact in
every pixel. Lengths are in metres; x runs to the right of the picture, y up, z towards the viewer,
after `view`, a rotation matrix, has been applied. Pictures are arrays (height, width, 3) of reds,
greens and blues from 0 to 1, WHITE where nothing is.

    mesh = read_stl("stone_001.stl")
    picture = draw_mesh(mesh, view=view_from(30, 25), width=300, height=300, scale=6000)
    name, spheres = read_clump("stone_001.clump.json")
    picture = draw_spheres(spheres, view=view_from(30, 25), width=300, height=300, scale=6000)
"""

import json

import numpy as np

WHITE = 1.0
GRANITE = (0.66, 0.64, 0.62)
CLUMP = (0.74, 0.57, 0.42)
# Key light from the upper left behind the viewer's shoulder, a weak fill light from the right.
KEY = np.array([-0.55, 0.62, 0.56])
FILL = np.array([0.8, 0.1, 0.6])
SAMPLES = 2  # pictures are drawn this many times finer and then averaged, which smooths outlines


def read_stl(path):
    """Corners of the triangles of a binary STL file: an array (triangles, 3 corners, 3)."""
    with open(path, "rb") as file:
        header = file.read(84)
        count = int(np.frombuffer(header[80:84], "<u4")[0]) if len(header) == 84 else -1
        record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        data = file.read()
    if count < 1 or len(data) < count * record.itemsize:
        raise ValueError(f"{path}: this is not a binary STL file.")
    return np.frombuffer(data, record, count)["corners"].astype(float)


def read_clump(path):
    """Name and spheres (x, y, z, radius) of a *.clump.json file."""
    with open(path, encoding="utf-8") as file:
        content = json.load(file)
    if "spheres_x_y_z_r_m" not in content:
        raise ValueError(f"{path}: this is not a clump file.")
    return content.get("name", ""), np.array(content["spheres_x_y_z_r_m"], float)


def view_from(azimuth, elevation):
    """Rotation that shows the body from this direction, in degrees; its z axis points up."""
    a, e = np.radians(azimuth), np.radians(elevation)
    turn = np.array([[np.cos(a), np.sin(a), 0], [-np.sin(a), np.cos(a), 0], [0, 0, 1]])
    tilt = np.array([[1, 0, 0], [0, np.sin(e), np.cos(e)], [0, -np.cos(e), np.sin(e)]])
    return tilt @ turn


def mesh_moments(triangles):
    """Centre of volume and principal axes (rows, longest extent first) of a closed mesh."""
    def cut(points):  # into tetrahedra with one corner at the origin
        return points.swapaxes(0, 1), np.linalg.det(points) / 6
    corners, volumes = cut(triangles)
    centre = (corners.sum(0) * volumes[:, None]).sum(0) / (4 * volumes.sum())
    corners, volumes = cut(triangles - centre)
    # Second moments of a tetrahedron: volume/20 times those of its corners and of their sum.
    second = sum(np.einsum("i,ij,ik->jk", volumes, x, x) for x in [*corners, corners.sum(0)]) / 20
    axes = np.linalg.eigh(second)[1][:, ::-1].T
    for row in axes[:2]:  # as the frame of a clump has them: see principal_frame()
        row *= np.sign(row[np.argmax(np.abs(row))])
    axes[2] = np.cross(axes[0], axes[1])
    return centre, axes


def shade(normals, colour):
    """Colours of surface points with these unit normals."""
    key, fill = KEY / np.linalg.norm(KEY), FILL / np.linalg.norm(FILL)
    light = 0.30 + 0.82 * np.clip(normals @ key, 0, None) + 0.20 * np.clip(normals @ fill, 0, None)
    # What turns away from the viewer darkens a little, which lifts bodies off the paper.
    light *= 0.72 + 0.28 * np.clip(normals[..., 2], 0, 1)
    return np.clip(light[..., None] * np.asarray(colour) * 1.18, 0, 1)


def averaged(image):
    height, width = image.shape[0] // SAMPLES, image.shape[1] // SAMPLES
    return image.reshape(height, SAMPLES, width, SAMPLES, 3).mean((1, 3))


def corner_normals(triangles, crease=28.0):
    """Unit normals at the corners: the mean over facets around that lie within `crease` degrees."""
    cross = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    facet = cross / np.maximum(np.linalg.norm(cross, axis=1, keepdims=True), 1e-300)
    node = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)[1].reshape(-1)
    owner = np.repeat(np.arange(len(triangles)), 3)
    order = np.argsort(node, kind="stable")
    starts = np.flatnonzero(np.diff(node[order], prepend=-1))
    sizes = np.diff(np.append(starts, len(order)))
    result = np.zeros((len(triangles) * 3, 3))
    for size in np.unique(sizes):  # nodes with equally many facets at once
        rows = order[starts[sizes == size][:, None] + np.arange(size)]
        normals, weights = facet[owner[rows]], cross[owner[rows]]
        near = np.einsum("nik,njk->nij", normals, normals) > np.cos(np.radians(crease))
        result[rows] = np.einsum("nij,njk->nik", near, weights)
    return (result / np.maximum(np.linalg.norm(result, axis=1, keepdims=True), 1e-300)).reshape(-1, 3, 3)


def draw_mesh(triangles, view, width, height, scale, centre=(0, 0, 0), colour=GRANITE):
    """A mesh with `centre` [m] in the middle of the picture, `scale` in pixels a metre."""
    width, height, scale = SAMPLES * width, SAMPLES * height, SAMPLES * scale
    points = (triangles - np.asarray(centre)) @ view.T
    normals = corner_normals(triangles) @ view.T
    screen = np.empty((len(points), 3, 2))
    screen[..., 0] = points[..., 0] * scale + width / 2
    screen[..., 1] = height / 2 - points[..., 1] * scale
    depth = np.full((height, width), -np.inf)
    image = np.full((height, width, 3), WHITE)
    for corners, z, normal in zip(screen, points[..., 2], normals):
        (xa, ya), (xb, yb), (xc, yc) = corners
        area = (xb - xa) * (yc - ya) - (xc - xa) * (yb - ya)
        if area >= 0:  # seen from behind (y runs down on the screen)
            continue
        left, right = int(max(min(xa, xb, xc), 0)), int(min(max(xa, xb, xc) + 1, width))
        top, bottom = int(max(min(ya, yb, yc), 0)), int(min(max(ya, yb, yc) + 1, height))
        if left >= right or top >= bottom:
            continue
        x, y = np.arange(left, right)[None, :] + 0.5, np.arange(top, bottom)[:, None] + 0.5
        wb = ((x - xa) * (yc - ya) - (xc - xa) * (y - ya)) / area
        wc = ((xb - xa) * (y - ya) - (x - xa) * (yb - ya)) / area
        wa = 1 - wb - wc
        here = wa * z[0] + wb * z[1] + wc * z[2]
        window = depth[top:bottom, left:right]
        seen = (wa >= -1e-9) & (wb >= -1e-9) & (wc >= -1e-9) & (here > window)
        if seen.any():
            window[seen] = here[seen]
            mixed = np.stack([wa[seen], wb[seen], wc[seen]], -1) @ normal
            mixed /= np.maximum(np.linalg.norm(mixed, axis=1, keepdims=True), 1e-300)
            image[top:bottom, left:right][seen] = shade(mixed, colour)
    return averaged(image)


def draw_spheres(spheres, view, width, height, scale, centre=(0, 0, 0), colour=CLUMP):
    """Spheres (x, y, z, radius) in one picture; where two meet, a fine dark line shows it."""
    width, height, scale = SAMPLES * width, SAMPLES * height, SAMPLES * scale
    centres = (spheres[:, :3] - np.asarray(centre)) @ view.T
    depth = np.full((height, width), -np.inf)
    owner = np.full((height, width), -1)
    normals = np.zeros((height, width, 3))
    for k, ((cx, cy, cz), radius) in enumerate(zip(centres, spheres[:, 3])):
        px, py, pr = cx * scale + width / 2, height / 2 - cy * scale, radius * scale
        left, right = int(max(px - pr, 0)), int(min(px + pr + 2, width))
        top, bottom = int(max(py - pr, 0)), int(min(py + pr + 2, height))
        if left >= right or top >= bottom:
            continue
        x = (np.arange(left, right)[None, :] + 0.5 - px) / pr
        y = (py - np.arange(top, bottom)[:, None] - 0.5) / pr
        inside = 1 - x * x - y * y
        z = np.sqrt(np.clip(inside, 0, None))
        window = depth[top:bottom, left:right]
        seen = (inside > 0) & (cz + radius * z > window)
        window[seen] = (cz + radius * z)[seen]
        owner[top:bottom, left:right][seen] = k
        normals[top:bottom, left:right][seen] = np.stack(np.broadcast_arrays(x, y, z), -1)[seen]
    image = shade(normals, colour)
    image[owner < 0] = WHITE
    seam = np.zeros(owner.shape, bool)
    for axis in (0, 1):
        a, b = (np.roll(owner, s, axis) for s in (0, 1))
        seam |= (a != b) & (a >= 0) & (b >= 0)
    image[seam] *= 0.72
    return averaged(image)
