"""What the site has beside the pages of docs/: the examples, CONTRIBUTING.md, CHANGELOG.md and the Javadoc; and pictures in both themes.

Pages are written for whoever reads them in the repository, so links that leave docs/ are led to where these files are here.
"""

from __future__ import annotations

import posixpath
import re
import sys
import textwrap
from html import unescape
from pathlib import Path
from urllib.parse import unquote

import yaml
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File
from mkdocs.structure.nav import Link
from pygments.lexers import _mapping, get_lexer_by_name

HOME = Path(__file__).resolve().parents[2]
EXAMPLES = HOME / "examples"

# Pages that are made of files elsewhere: their names here, and where their links are seen from.
OUTSIDE = {"CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md"}

# The Javadoc as src/site/javadoc/make writes it, the packages that it is of, and the page that says what they are for.
JAVADOC = HOME / "target" / "javadoc"
PACKAGES = HOME / "src" / "site" / "javadoc" / "packages"
API = HOME / "docs" / "api.md"

LANGUAGES = {".script": "urscript", ".json": "json", ".toml": "toml", ".nc": "text", ".pendant": "text", ".pinst": "text"}

LINK = re.compile(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
ADDRESS = re.compile(r'(?:href|src)="([^"]+)"')
PLACE = re.compile(r'\bid="([^"]+)"')
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
    for file in sorted(JAVADOC.rglob("*")):
        if file.is_file():
            name = file.relative_to(JAVADOC.parent).as_posix()
            files.append(File(name, str(JAVADOC.parent), config.site_dir, config.use_directory_urls))
    return files


def on_nav(nav, config, files):
    """The Javadoc stands behind the page that says what is in it."""
    page = files.get_file_from_path(API.name).page
    javadoc = Link("Javadoc", f"{JAVADOC.name}/index.html")
    javadoc.parent = page.parent
    page.parent.children.insert(page.parent.children.index(page) + 1, javadoc)
    return nav


def on_post_build(config):
    """MkDocs looks at the links of pages; these are written elsewhere."""
    told = API.read_text(encoding="utf-8")
    wrong = [f"docs/api.md does not say what {name} is for" for name in packages() if f"`{name}`" not in told]
    wrong += broken_links(Path(config.site_dir), JAVADOC.name)
    if wrong:
        raise PluginError("\n".join(wrong))


def packages() -> list[str]:
    lines = PACKAGES.read_text(encoding="utf-8").splitlines()
    return [line for line in lines if line and line[0] not in "#["]


def broken_links(site: Path, folder: str) -> list[str]:
    """Links of the pages of a folder to files or places that the site does not have."""
    places: dict[Path, set[str]] = {}

    def has(file: Path, place: str) -> bool:
        if file not in places:
            places[file] = set(PLACE.findall(file.read_text(encoding="utf-8")))
        return unescape(unquote(place)) in {unescape(each) for each in places[file]}

    wrong = []
    for page in sorted((site / folder).rglob("*.html")):
        for link in sorted(set(ADDRESS.findall(page.read_text(encoding="utf-8")))):
            if re.match(r"[a-z]+:", link):
                continue
            path, _, place = link.partition("#")
            file = Path(posixpath.normpath(posixpath.join(page.parent.as_posix(), unquote(path)))) if path else page
            if not file.is_file() or (place and file.suffix == ".html" and not has(file, place)):
                wrong.append(f"{page.relative_to(site)} links to {link}, which is not there")
    return wrong


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
