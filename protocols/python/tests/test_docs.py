"""The examples of docs/python.md, in their order and in one folder."""

from __future__ import annotations

import re

import pytest

import pendant
from conftest import HOME

BLOCK = re.compile(r"^```(python|text|urscript)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
FILE = re.compile(r"`(\S+\.json)`:\n\n```json\n(.*?)^```$", re.DOTALL | re.MULTILINE)
NAMED = re.compile(r"# (\S+\.(?:script|py))\n")


def test_examples_do_what_they_say(pytester, plugin_arguments, capsys, monkeypatch, process):
    page = (HOME / "docs" / "python.md").read_text(encoding="utf-8")
    for name, text in FILE.findall(page):
        (pytester.path / name).write_text(text, encoding="utf-8")
    names = {"__name__": "docs"}
    examples = 0
    tests = []
    printed = None
    for language, text in BLOCK.findall(page):
        named = NAMED.match(text)
        if named:
            (pytester.path / named.group(1)).write_text(text, encoding="utf-8")
            tests += [named.group(1)] if named.group(1).startswith("test_") else []
        elif language == "python":
            capsys.readouterr()
            exec(compile(text, f"docs/python.md, example {examples + 1}", "exec"), names)
            printed = capsys.readouterr().out
            examples += 1
            # the first has started a process of its own, which is enough
            monkeypatch.setattr(pendant, "Robot", process.robot)
        elif language == "text" and printed:
            assert printed == text
            printed = None
    assert examples >= 3
    monkeypatch.undo()
    pytester.chdir()
    outcome = pytester.runpytest_inprocess(*plugin_arguments, *tests)
    assert tests and outcome.ret == pytest.ExitCode.OK
