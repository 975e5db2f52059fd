"""Reads the results.h5 of a run into numpy. Needs h5py (Debian: python3-h5py).

    from voussoir_results import Results
    run = Results("results/wall/results.h5")
    run.times                       (frames) s
    run.joints("opening")           (frames, joints) m
    run.pairs                       [(name, name), ...] of the joints
    run.displacement("wall_c10_b01")    (frames, 2 or 3) m, of the centroid relative to the ground
    run.outcome                     "completed", ...; None of a run that was killed

All numbers are in SI units; docs/results_format.md says what every dataset means. Of a run that goes on, or was killed, the whole
frames are read.
"""

import json

import h5py


class Results:
    def __init__(self, path):
        """@raises OSError when there is no such file, ValueError when it is no results file"""
        self.file = h5py.File(path, "r")
        kind = self.file.attrs.get("format", b"")
        kind = kind.decode() if isinstance(kind, bytes) else str(kind)
        if not kind.startswith("voussoir results"):
            raise ValueError(f"{path} is no results file of voussoir")
        self.frames = int(self.file["frames/count"][0])
        self.times = self.file["frames/time"][: self.frames]
        self.block_names = self._texts("model/block_names")
        self._place = {name: index for index, name in enumerate(self.block_names)}

    def _texts(self, name):
        return [text.decode() if isinstance(text, bytes) else str(text) for text in self.file[name][()]]

    def _attribute(self, name, attribute):
        """A list of texts beside a dataset: an attribute, or a dataset where it is too large for one."""
        if attribute in self.file[name].attrs:
            return [text.decode() if isinstance(text, bytes) else str(text) for text in self.file[name].attrs[attribute]]
        return self._texts(f"{name}.{attribute}")

    @property
    def histories(self):
        """The rows of histories.csv as {heading: (steps)}; empty if the case has no histories."""
        if "histories" not in self.file:
            return {}
        values = self.file["histories/values"][()]
        return dict(zip(self._attribute("histories/values", "columns"), values.T))

    def frame_data(self, name):
        """A dataset under /frames with one row a frame, such as "velocities": (frames, ...)."""
        return self.file["frames/" + name][: self.frames]

    @property
    def pairs(self):
        """The names of the two blocks of each joint."""
        if "joints" not in self.file:
            return []
        return [(self.block_names[a], self.block_names[b]) for a, b in self.file["joints/pair"][()]]

    def joints(self, quantity):
        """(frames, joints): "opening", "mean_opening", "slip", "largest_slip" in m, "normal_force", "shear_force" in N, ..."""
        return self.frame_data("joints/" + quantity)

    def displacement(self, block):
        """(frames, 2 or 3) m: of the centroid of a block, by its name, relative to the ground, since before the run."""
        place = self._place[block]
        start = self.file["model/centroid"][place]
        now = self.file["frames/coordinates"][: self.frames, place, : len(start)]
        return now - start - self.frame_data("ground_displacement")

    @property
    def summary(self):
        """What summary.json holds; None of a run that was killed."""
        if "summary" not in self.file:
            return None
        text = self.file["summary"][()]
        text = text if isinstance(text, (bytes, str)) else text.tobytes()
        return json.loads(text.rstrip(b"\0") if isinstance(text, bytes) else text)

    @property
    def outcome(self):
        return None if self.summary is None else self.summary["outcome"]
