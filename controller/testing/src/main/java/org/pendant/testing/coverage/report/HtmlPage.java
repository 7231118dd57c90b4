package org.pendant.testing.coverage.report;

import org.pendant.testing.coverage.Share;

/** HTML page: what all pages of a report have in common. */
final class HtmlPage {
  /** The style of all pages: a file of its own, since some servers let no page have one in it. */
  static final String STYLE =
      """
      :root { color-scheme: light dark; --text: #1d2125; --dim: #5c6670; --paper: #ffffff; --line: #d9dee3;
        --hit: #e3f4e6; --part: #fdf1d0; --miss: #fbe1df; --bar: #2e8540; --link: #0b62b8; }
      @media (prefers-color-scheme: dark) {
        :root { --text: #e3e6e9; --dim: #9aa4ad; --paper: #16191c; --line: #363c42;
          --hit: #16331d; --part: #42350f; --miss: #4a1f1c; --bar: #4fb866; --link: #7cb8f5; }
      }
      body { margin: 2rem auto; max-width: 80rem; padding: 0 1rem; background: var(--paper); color: var(--text);
        font: 15px/1.5 system-ui, sans-serif; }
      a { color: var(--link); }
      table { border-collapse: collapse; }
      .files { width: 100%; }
      .files th, .files td { padding: .35rem .7rem; border-bottom: 1px solid var(--line); text-align: left; }
      .files tbody th, .files tfoot th { font-weight: normal; }
      .missing { color: var(--dim); }
      .share { white-space: nowrap; }
      .share small { color: var(--dim); }
      meter { width: 4rem; vertical-align: middle; }
      .source { width: 100%; font: 13px/1.5 ui-monospace, monospace; }
      .source td { padding: 0 .6rem; vertical-align: top; white-space: pre-wrap; }
      .source .number, .source .tests { width: 1%; text-align: right; color: var(--dim); white-space: nowrap; }
      .source .note { font-style: italic; color: var(--dim); }
      .hit { background: var(--hit); } .part { background: var(--part); } .miss { background: var(--miss); }
      .legend span { padding: .1rem .5rem; margin-right: .5rem; }
      """;

  private HtmlPage() {}

  static String of(String title, String body) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        + "<meta name=\"viewport\" content=\"width=device-width\">\n<title>"
        + escaped(title)
        + "</title>\n<link rel=\"stylesheet\" href=\"coverage.css\">\n</head>\n<body>\n"
        + body
        + "</body>\n</html>\n";
  }

  /** A share in numbers, with a bar. */
  static String share(Share share) {
    if (share.total() == 0) {
      return "<span class=\"share\">-</span>";
    }
    return "<span class=\"share\"><meter value=\""
        + share.reached()
        + "\" max=\""
        + share.total()
        + "\"></meter> "
        + share.percent()
        + " <small>"
        + share.reached()
        + "/"
        + share.total()
        + "</small></span>";
  }

  /** Text as it has to stand in HTML, in attributes as well. */
  static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
