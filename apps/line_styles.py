"""Colours and dashes of curves, the same in every figure and in the report."""

# Okabe and Ito's colours, which colour-blind readers can tell apart.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
# Beside a colour, for those who see or print none.
STYLES = ["-", "--", "-.", ":", (0, (6, 1.5, 1, 1.5, 1, 1.5)), (0, (3, 1)), (0, (8, 3))]
# The same colour and style in every figure; what is put in is black.
ENERGIES = {
    "kinetic_stones": (COLOURS[5], "-"), "kinetic_geogrid": (COLOURS[5], ":"),
    "gravitational": (COLOURS[0], "-"),
    "elastic_contacts": (COLOURS[2], "--"), "elastic_geogrid": (COLOURS[2], "-."),
    "friction": (COLOURS[1], "-"),
    "crushing": (COLOURS[1], ":"),
    "contact_damping": (COLOURS[4], "--"), "local_damping": (COLOURS[3], "-."), "geogrid_damping": (COLOURS[4], ":"),
    "geogrid_plastic": (COLOURS[3], ":"),
    "clamp_work": (COLOURS[6], "--"), "wall_work": (COLOURS[6], "-."), "inserted": (COLOURS[6], ":"),
}

# Dashes by style, in pixels, for charts in a page.
DASHES = {"-": [], "--": [6, 3], "-.": [7, 3, 2, 3], ":": [2, 3]}
