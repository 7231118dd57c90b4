package org.pendant.project.polyscope.xml;

import static org.pendant.project.polyscope.xml.PolyscopeXmlTexts.text;

/**
 * Tag scanner: finds where tags begin and end in a text whose form a parser checks at the same
 * time: parsers do not tell, and elements that Pendant does not know are to be kept to the letter.
 */
final class TagScanner {
  private final XmlSource source;
  private final String text;
  private int at;
  private int begin;
  private String comment = "";

  TagScanner(XmlSource source) {
    this.source = source;
    text = source.text();
  }

  /** Where the tag begins that {@link #next} has found. */
  int begin() {
    return begin;
  }

  /** The offset after it. */
  int end() {
    return at;
  }

  /** Whether that tag is a whole element. */
  boolean closesItself() {
    return text.charAt(at - 2) == '/';
  }

  /** The last comment before that tag and after the one before; empty if there is none. */
  String comment() {
    return comment;
  }

  /** Continues to the next tag, past text, comments and the like. */
  void next() throws UnreadableFile {
    comment = "";
    while (true) {
      begin = text.indexOf('<', at);
      if (begin < 0) {
        throw new IllegalStateException("the parser has seen a tag that is not in the text");
      }
      if (text.startsWith("<!--", begin)) {
        skipTo("-->");
        comment = text.substring(begin + 4, at - 3);
      } else if (text.startsWith("<![CDATA[", begin)) {
        skipTo("]]>");
      } else if (text.startsWith("<?", begin)) {
        skipTo("?>");
      } else if (text.startsWith("<!", begin)) {
        throw source.wrong(begin, text("docType"));
      } else {
        skipTag();
        return;
      }
    }
  }

  private void skipTo(String ending) {
    at = text.indexOf(ending, begin + 2) + ending.length();
  }

  private void skipTag() {
    char quote = 0;
    for (at = begin + 1; at < text.length(); at++) {
      char c = text.charAt(at);
      if (quote != 0) {
        quote = c == quote ? 0 : quote;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        at++;
        return;
      }
    }
  }
}
