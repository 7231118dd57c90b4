package org.pendant.testing.report;

import java.io.IOException;
import java.io.Writer;

/** HTML text: writes a page piece by piece; what comes from others is escaped. */
final class HtmlText {
  private final Writer out;

  HtmlText(Writer out) {
    this.out = out;
  }

  /** Our own markup, as it is. */
  HtmlText raw(String markup) throws IOException {
    out.write(markup);
    return this;
  }

  /** Any text that is {@linkplain ReportText visible}, as content or in the quotes of a value. */
  HtmlText text(String text) throws IOException {
    for (int i = 0; i < text.length(); i++) {
      char each = text.charAt(i);
      switch (each) {
        case '&' -> out.write("&amp;");
        case '<' -> out.write("&lt;");
        case '>' -> out.write("&gt;");
        case '"' -> out.write("&quot;");
        case '\'' -> out.write("&#39;");
        default -> out.write(each);
      }
    }
    return this;
  }

  /** An element of a class with nothing but a text in it. */
  HtmlText element(String tag, String className, String text) throws IOException {
    return raw("<" + tag + " class=\"" + className + "\">").text(text).raw("</" + tag + ">");
  }
}
