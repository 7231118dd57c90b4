"""Colours of URScript for Pygments; the words are those of docs/language.md."""

from pygments.lexer import RegexLexer, words
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String, Text

__all__ = ["UrScriptLexer"]

BLOCKS = "def sec thread end if elif else while break continue return halt pause run join kill enter_critical exit_critical"


class UrScriptLexer(RegexLexer):
    name = "URScript"
    aliases = ["urscript"]
    filenames = ["*.script", "*.urscript"]

    tokens = {
        "root": [
            (r"\s+", Text),
            (r"#.*", Comment.Single),
            (r"\$.*", Comment.Preproc),
            (r'"[^"\n]*"', String.Double),
            (r"(def|thread|sec)(\s+)(\w+)", lambda lexer, found, context=None: declaration(found)),
            (words(BLOCKS.split(), suffix=r"\b"), Keyword),
            (words(("and", "or", "xor", "not"), suffix=r"\b"), Operator.Word),
            (words(("global", "local"), suffix=r"\b"), Keyword.Declaration),
            (words(("True", "False", "None", "true", "false"), suffix=r"\b"), Keyword.Constant),
            (r"p(?=\[)", Keyword.Type),
            (r"\d+\.?\d*([eE][+-]?\d+)?|\.\d+([eE][+-]?\d+)?", Number),
            (r"[A-Za-z_]\w*(?=\()", Name.Function),
            (r"[A-Za-z_]\w*", Name),
            (r"[-+*/%=<>!]+", Operator),
            (r"[\[\](){},.:]", Punctuation),
            (r".", Text),
        ]
    }


def declaration(found):
    yield found.start(1), Keyword, found.group(1)
    yield found.start(2), Text, found.group(2)
    yield found.start(3), Name.Function, found.group(3)
