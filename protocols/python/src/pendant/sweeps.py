"""Sweeps: the variants of a plan, run by the thousand, and what came of each."""

from __future__ import annotations

import csv
import os
import pathlib
import subprocess
from typing import (
    Any,
    Callable,
    Dict,
    Iterable,
    Iterator,
    List,
    Mapping,
    Optional,
    Sequence,
    Union,
)

from .errors import PendantError
from .launcher import Launcher, program

File = Union[str, "os.PathLike[str]"]

#: What a cell may be: a number, a word, or nothing.
Cell = Union[int, float, str, None]

#: Columns of words, which may look like numbers.
_WORDS = frozenset(("outcome", "reason", "lines", "outputs", "digest"))

_RESULTS = "results.csv"
_HOLDS = 0
_BROKEN = 1


class SweepError(PendantError):
    """A plan is wrong, or a sweep cannot be run; the message has the file, line and column."""


class Run(Mapping[str, Cell]):
    """One run of a sweep: a row of the table, with the values of its parameters first."""

    def __init__(self, sweep: Sweep, cells: Mapping[str, Cell]) -> None:
        self._sweep = sweep
        self._cells = dict(cells)

    def __getitem__(self, column: str) -> Cell:
        return self._cells[column]

    def __iter__(self) -> Iterator[str]:
        return iter(self._cells)

    def __len__(self) -> int:
        return len(self._cells)

    def __repr__(self) -> str:
        return f"<run {self.number}: {self.outcome}>"

    @property
    def number(self) -> int:
        """Its number in the sweep, from 0."""
        return int(self._cells["run"] or 0)

    @property
    def outcome(self) -> str:
        """How it ended: ``finished``, ``stopped``, ``failed``, ..."""
        return str(self._cells["outcome"])

    @property
    def ended(self) -> bool:
        """Whether the program came to an end of its own."""
        return self.outcome in ("finished", "halted")

    def record(self) -> pathlib.Path:
        """The recording of the run, which is made by running it once more."""
        return self._sweep.record(self.number)[0]

    def open(self) -> subprocess.Popen[bytes]:
        """Shows the run in the window; returns the process of that."""
        return self._sweep.open_run(self.number)


class Sweep(Iterable[Run]):
    """
    The folder with the results of a sweep.

    ``for run in sweep`` reads the rows one after another, so that a table may be larger than the
    memory; ``sweep[17]`` is a single one, and ``sweep.columns("x", "duration")`` has columns.
    """

    def __init__(
        self,
        folder: File,
        holds: bool = True,
        broken: Sequence[str] = (),
        launcher: Optional[Launcher] = None,
    ) -> None:
        self.folder = pathlib.Path(folder)
        #: Whether all that ``asserts`` asked for holds.
        self.holds = holds
        #: What does not, a sentence for each.
        self.broken = tuple(broken)
        self._launcher = launcher
        if not (self.folder / _RESULTS).is_file():
            raise SweepError(f"{self.folder} is no folder of a sweep, it has no {_RESULTS}")

    def __iter__(self) -> Iterator[Run]:
        with open(self.folder / _RESULTS, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                yield Run(self, {name: _cell(name, text) for name, text in row.items()})

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __getitem__(self, number: int) -> Run:
        for run in self:
            if run.number == number:
                return run
        raise IndexError(f"{self.folder} has no run {number}")

    def __repr__(self) -> str:
        return f"<sweep {self.folder}>"

    def outcomes(self) -> Dict[str, int]:
        """How many runs ended in which way."""
        counts: Dict[str, int] = {}
        for run in self:
            counts[run.outcome] = counts.get(run.outcome, 0) + 1
        return counts

    def columns(self, *names: str, numpy: Optional[bool] = None) -> Dict[str, Any]:
        """
        Columns of all runs: arrays of NumPy where it is installed and the column has numbers,
        lists otherwise. Without names it has all of them.
        """
        table: Dict[str, List[Cell]] = {name: [] for name in names}
        for run in self:
            for name in names or run:
                table.setdefault(name, []).append(run[name])
        if numpy is False:
            return dict(table)
        try:
            import numpy as np
        except ImportError:
            if numpy:
                raise
            return dict(table)
        return {
            name: np.array([float("nan") if each is None else each for each in cells])
            if not any(isinstance(each, str) for each in cells)
            else cells
            for name, cells in table.items()
        }

    def record(self, *numbers: int) -> List[pathlib.Path]:
        """The recordings of some runs, which ``pendant open`` shows."""
        words = [str(number) for number in numbers]
        told = self._call("record", *words)
        head = "pendant open "
        return [pathlib.Path(line[len(head) :]) for line in told if line.startswith(head)]

    def open_run(self, number: int) -> subprocess.Popen[bytes]:
        """Shows a run in the window; returns the process of that."""
        return subprocess.Popen(
            [*program(self._launcher), "sweep", "open", str(self.folder), str(number)]
        )

    def report(self) -> pathlib.Path:
        """Writes the page of plots."""
        self._call("report")
        return self.folder / "report.html"

    def _call(self, action: str, *words: str) -> List[str]:
        done = subprocess.run(
            [*program(self._launcher), "sweep", action, str(self.folder), *words],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            encoding="utf-8",
            check=False,
        )
        if done.returncode != 0:
            raise SweepError(done.stderr.strip())
        return done.stdout.splitlines()


def _cell(column: str, text: str) -> Cell:
    if not text:
        return None if column not in _WORDS else ""
    if column in _WORDS:
        return text
    for number in (int, float):
        try:
            return number(text)
        except ValueError:
            continue
    return text


def sweep(
    plan: File,
    out: Optional[File] = None,
    *,
    workers: Optional[int] = None,
    resume: bool = False,
    force: bool = False,
    asserts: Sequence[str] = (),
    keep: Optional[str] = None,
    options: Optional[Mapping[str, str]] = None,
    progress: Optional[Callable[[str], None]] = None,
    launcher: Optional[Launcher] = None,
) -> Sweep:
    """
    Runs the variants of a plan on the cores of this machine and returns what came of them.

    ``out`` is the folder of the results, by default beside the plan; ``resume`` goes on with those
    that are there, ``force`` begins anew. ``asserts`` are conditions on every run, such as
    ``"duration < 12"``: where one does not hold, ``holds`` of the result is false. ``keep`` has
    recordings made at once, such as ``"worst=5,failed=20"``. ``options`` are others of the
    command, such as ``{"engine": "spark", "master": "local[4]"}``. ``progress`` hears a sentence every
    few seconds.
    """
    words = [*program(launcher), "sweep", os.fspath(plan)]
    folder = pathlib.Path(out) if out is not None else _beside(plan)
    words += ["--out", str(folder)]
    if workers is not None:
        words += ["--workers", str(workers)]
    words += ["--resume"] if resume else []
    words += ["--force"] if force else []
    for condition in asserts:
        words += ["--assert", condition]
    if keep is not None:
        words += ["--keep", keep]
    for option, value in (options or {}).items():
        words += ["--" + option, value]
    said: List[str] = []
    with subprocess.Popen(
        words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8"
    ) as process:
        assert process.stderr is not None
        for line in process.stderr:
            said.append(line.rstrip())
            if progress is not None:
                progress(said[-1])
    begin = "pendant sweep: "
    told = [line[len(begin) :] for line in said if line.startswith(begin)]
    if process.returncode not in (_HOLDS, _BROKEN):
        raise SweepError("\n".join(said))
    return Sweep(folder, process.returncode == _HOLDS, told, launcher)


def _beside(plan: File) -> pathlib.Path:
    path = pathlib.Path(plan)
    name = path.name[: -len(".toml")] if path.name.endswith(".toml") else path.name
    return path.with_name(name + ".sweep")
