"""Scenarios that together hold every key, and what the readers' messages cannot say."""

DRIVE = {"waypoints": [{"x_m": 1, "y_m": 0}]}
SQUARE = [[-2, -2], [2, -2], [2, 2], [-2, 2]]

# Scenarios that together hold every key. Below a list, the first entry counts for all.
PROBES = [
    {"world": {"kind": kind}, "drive": DRIVE} for kind in ("simple", "cornered", "cluttered", "hallway")
] + [
    {"world": {"kind": "polygons", "walls": [{"corners_m": SQUARE}],
               "obstacles": [{"box": {"x_m": 1.5, "y_m": 1.5, "heading_deg": 0, "width_m": 0.2, "length_m": 0.2}}],
               "slip_patches": [{"x_m": 0}]}, "drive": DRIVE, "variants": [{"name": "og"}]},
    {"world": {"kind": "polygons", "walls": [{"corners_m": SQUARE}],
               "obstacles": [{"corners_m": [[1, 1], [1.5, 1], [1.2, 1.6]]}]}, "drive": DRIVE},
    {"world": {"kind": "map", "map": "maps/flat.yaml", "start": {"x_m": 1.2, "y_m": 4.3}}, "drive": DRIVE},
    {"drive": {"kind": "script", "script": [{"duration_s": 1}]}},
    {"drive": DRIVE, "sensors": {"compass": {"bias_deg": 1}, "camera": {"blackouts_s": [[1, 2]]}}},
] + [
    {"drive": {"waypoints": [dict(x_m=1, y_m=0, heading=heading, **more)]}}
    for heading, more in (("along", {}), ("keep", {}), ("face", {"heading_deg": 3}), ("turn", {"turn_rate_deg_s": 3}))
] + [
    {"drive": DRIVE, "slam": {"store": {"kind": "coefficients", "basis": "haar", "compressor": compressor,
                                        "recovery": recovery}}}
    for compressor, recovery in (("top_m", "fast_l2"), ("gaussian", "pinv"), ("gaussian", "nesta"),
                                 ("gaussian", "csekf"), ("gaussian", "csekf_p_printed"),
                                 ("gaussian", "csekf_p_gradient"), ("gaussian", "csekf_p_power"))
] + [
    {"drive": DRIVE, "slam": {"store": {"kind": "coefficients", "basis": "identity", "compressor": "selection",
                                        "recovery": "tv"}}}
]

# One of every fault.
PROBES += [
    {"drive": DRIVE, "faults": [dict(kind=kind, **more)]}
    for kind, more in (("dropout", {"sensor": "lidar"}), ("frozen", {"sensor": "compass"}), ("late", {"sensor": "camera"}),
                       ("outlier_beams", {}), ("glass", {"from_m": [1, -1], "to_m": [1, 1]}), ("magnet", {}),
                       ("slip_patch", {}), ("camera_blackout", {}), ("push", {"at_s": 1, "impulse_n_s": [1, 0]}),
                       ("kidnapping", {"at_s": 1, "x_m": 0, "y_m": 0}))
]

# The key that says which others there are, and its value where it is absent.
CHOOSERS = {"world": ("kind", "simple"), "drive": ("kind", "waypoints"), "drive.waypoints": ("heading", None),
            "slam.store": ("recovery", "fast_l2"), "faults": ("kind", None)}

# What a message of the readers cannot say: keys that must be there, by kind where it matters, and shapes of lists.
REQUIRED = {"": ["drive"], "drive.waypoints": ["x_m", "y_m"], "drive.script": ["duration_s"],
            "world.walls": ["corners_m"], "faults": ["kind"]}
REQUIRED_OF = {("world", "polygons"): ["walls"], ("world", "map"): ["map"], ("drive", "waypoints"): ["waypoints"],
               ("drive", "script"): ["script"], ("drive.waypoints", "face"): ["heading_deg"],
               ("drive.waypoints", "turn"): ["turn_rate_deg_s"],
               ("faults", "dropout"): ["sensor"], ("faults", "frozen"): ["sensor"], ("faults", "late"): ["sensor"],
               ("faults", "glass"): ["from_m", "to_m"], ("faults", "push"): ["at_s"],
               ("faults", "kidnapping"): ["at_s", "x_m", "y_m"]}
NAME = {"pattern": r"^[A-Za-z0-9_-][A-Za-z0-9_.-]*$", "maxLength": 100}
SHAPES = {"name": NAME, "variants.name": NAME, "slam.cell_sizes_m": {"minItems": 1, "uniqueItems": True},
          "drive.waypoints": {"minItems": 1}, "drive.script": {"minItems": 1}, "world.walls": {"minItems": 1},
          "world.walls.corners_m": {"minItems": 3}, "world.obstacles.corners_m": {"minItems": 3}}
