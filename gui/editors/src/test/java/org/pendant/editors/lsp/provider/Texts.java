package org.pendant.editors.lsp.provider;

import org.eclipse.lsp4j.Position;
import org.pendant.editors.lsp.text.Catalogues;
import org.pendant.editors.lsp.text.Document;
import org.pendant.editors.lsp.text.PositionEncoding;
import org.pendant.editors.wire.ClientLanguages;

/**
 * A text with a caret in it, written as {@code |} in the examples of these tests.
 *
 * @param document the text without the mark
 * @param caret where the mark stood
 */
record Texts(Document document, Position caret) {
  static final String URI = "file:///programs/cell.script";

  static final ClientFeatures ABLE =
      new ClientFeatures(
          true, true, false, true, false, false, false, false, false, ClientLanguages.ENGLISH);

  private static final Catalogues CATALOGUES = new Catalogues();

  static Texts of(String marked) {
    int caret = marked.indexOf('|');
    if (caret < 0 || marked.indexOf('|', caret + 1) >= 0) {
      throw new IllegalArgumentException("expected one caret in " + marked);
    }
    Document document = document(marked.substring(0, caret) + marked.substring(caret + 1));
    String before = marked.substring(0, caret);
    int line = (int) before.chars().filter(each -> each == '\n').count();
    return new Texts(document, new Position(line, caret - before.lastIndexOf('\n') - 1));
  }

  static Document document(String text) {
    return document(URI, text);
  }

  static Document document(String uri, String text) {
    String name = uri.substring(uri.lastIndexOf('/') + 1);
    return Document.of(uri, 1, text, CATALOGUES.of(name), PositionEncoding.UTF16);
  }
}
