"""What the site has beside the pages of docs/: the examples, CONTRIBUTING.md and CHANGELOG.md; and pictures in both themes.

Pages are written for whoever reads them in the repository, so links that leave docs/ are led to where these files are here.
"""

from __future__ import annotations

import posixpath
import re
import sys
import textwrap
from pathlib import Path

import yaml
from mkdocs.structure.files import File
from pygments.lexers import _mapping, get_lexer_by_name

HOME = Path(__file__).resolve().parents[2]
EXAMPLES = HOME / "examples"

# Pages that are made of files elsewhere: their names here, and where their links are seen from.
OUTSIDE = {"CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md"}

LANGUAGES = {".script": "urscript", ".json": "json", ".toml": "toml", ".nc": "text", ".pendant": "text", ".pinst": "text"}

LINK = re.compile(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
FENCE = re.compile(r"^( *)```.*?^\1```$", re.DOTALL | re.MULTILINE)
PICTURE = re.compile(r'<img ([^>]*)src="([^"]+)-light([^"]*)\.png"([^>]*)>')
SHORT_CODE = re.compile(r"<code>([^<]{1,26})</code>")
TABLE = re.compile(r"<table>.*?</table>", re.DOTALL)


def on_startup(command, dirty):
    """Pygments has no URScript."""
    sys.path.insert(0, str(Path(__file__).parent))
    _mapping.LEXERS["UrScriptLexer"] = ("urscript_lexer", "URScript", ("urscript",), ("*.script",), ())
    # Without it programs would have no colours, and nobody would be told.
    get_lexer_by_name("urscript")


def on_files(files, config):
    for source, name in OUTSIDE.items():
        files.append(File.generated(config, name, content=(HOME / source).read_text(encoding="utf-8")))
    files.append(File.generated(config, "examples.md", content=examples()))
    return files


def shown() -> list[Path]:
    """The files of the page of examples, in its order."""
    folders = [EXAMPLES, EXAMPLES / "tests", EXAMPLES / "sweeps"]
    return [file for folder in folders for file in sorted(folder.iterdir()) if file.suffix in LANGUAGES]


def examples() -> str:
    page = ["# Examples", "", "The files of the folder `examples`. The window has them too: *Help*, *Examples*.", ""]
    for file in shown():
        text = file.read_text(encoding="utf-8").rstrip()
        page += [f"## {file.relative_to(EXAMPLES).as_posix()}", "", f"```{LANGUAGES[file.suffix]}", text, "```", ""]
    return "\n".join(page)


def on_page_markdown(markdown, page, config, files):
    source = page.file.src_uri
    names = {name: outside for outside, name in OUTSIDE.items()}
    folder = posixpath.dirname(names[source] if source in names else "docs/" + source)
    here = posixpath.dirname(source)

    def led(link: re.Match) -> str:
        text, address = link.groups()
        if re.match(r"[a-z]+:|#", address):
            return link.group(0)
        path, _, place = address.partition("#")
        file = posixpath.normpath(posixpath.join(folder, path))
        target = address_of(file, place, files)
        if target is None:
            # A file of the project that is no page: what it is called has to do.
            if not (HOME / file).exists():
                raise FileNotFoundError(f"{source} links to {address}, which is not there")
            return text
        name, _, place = target.partition("#")
        relative = posixpath.relpath(name, here or ".")
        return f"[{text}]({relative}{'#' + place if place else ''})"

    parts, end = [], 0
    for fence in FENCE.finditer(markdown):
        if fence.group(0).lstrip().startswith("```yaml"):
            # Nothing else in the project reads YAML for other programs.
            yaml.safe_load(textwrap.dedent(fence.group(0).partition("\n")[2].rpartition("\n")[0]))
        parts += [LINK.sub(led, markdown[end : fence.start()]), fence.group(0)]
        end = fence.end()
    return "".join([*parts, LINK.sub(led, markdown[end:])])


def address_of(file: str, place: str, files) -> str | None:
    """Where a file of the project is on the site, seen from its top; None for nowhere."""
    at = "#" + place if place else ""
    if file in OUTSIDE:
        return OUTSIDE[file] + at
    if file == "docs":
        return "README.md"
    if file == "examples":
        return "examples.md"
    if HOME / file in shown():
        return "examples.md#" + re.sub(r"[^\w-]", "", file.removeprefix("examples/").lower())
    name = file.removeprefix("docs/")
    return name + at if name != file and files.get_file_from_path(name) else None


def on_page_content(html, page, config, files):
    html = PICTURE.sub(both_themes, html)
    # Browsers break words at any hyphen: --port-offset is one word.
    html = SHORT_CODE.sub(r'<code class="whole">\1</code>', html)
    return TABLE.sub(lambda table: f'<div class="wide">{table.group(0)}</div>', html)


def both_themes(picture: re.Match) -> str:
    before, start, end, after = picture.groups()
    return "".join(
        f'<img {before}src="{start}-{theme}{end}.png#only-{theme}"{after}>' for theme in ("light", "dark")
    )
