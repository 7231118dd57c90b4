"""Finds the ``pendant`` command."""

from __future__ import annotations

import os
import shutil
from typing import List, Optional, Sequence, Union

from .errors import LauncherNotFound

Launcher = Union[str, "os.PathLike[str]", Sequence[str]]


def program(launcher: Optional[Launcher] = None) -> List[str]:
    """
    The words that start the command: ``launcher``, or the environment variable ``PENDANT``, or
    ``pendant`` on the ``PATH``.

    ``launcher`` is a path, or a list of words.
    """
    if launcher is None:
        launcher = os.environ.get("PENDANT") or shutil.which("pendant")
    if launcher is None:
        raise LauncherNotFound(
            "the pendant command was not found: name it by the argument launcher, by the "
            "environment variable PENDANT, or have it on the PATH"
        )
    if isinstance(launcher, (str, os.PathLike)):
        path = os.fspath(launcher)
        found = shutil.which(path)
        if found is None:
            raise LauncherNotFound(f"{path} is no program that can be started")
        return [found]
    return list(launcher)


def command(launcher: Optional[Launcher] = None) -> List[str]:
    """The command line of the process that answers requests, found as by :func:`program`."""
    return [*program(launcher), "rpc"]
