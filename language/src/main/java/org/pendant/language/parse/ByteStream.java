package org.pendant.language.parse;

import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.misc.Interval;
import org.pendant.language.source.Source;

/**
 * Byte stream: a source as the lexer sees it. Bytes that are not ASCII all look like {@link
 * #NOT_ASCII}: the grammar treats them alike, and ANTLR's lexer is fast on ASCII only. Token
 * offsets stay true.
 */
final class ByteStream implements CharStream {
  static final char NOT_ASCII = '\u007F';

  private static final String BYTE_ORDER_MARK = "\u00EF\u00BB\u00BF";

  private final String text;
  private final String name;
  private int position;

  ByteStream(Source source) {
    this.text = source.text();
    this.name = source.name();
    this.position = text.startsWith(BYTE_ORDER_MARK) ? BYTE_ORDER_MARK.length() : 0;
  }

  @Override
  public String getText(Interval interval) {
    return text.substring(interval.a, Math.min(interval.b + 1, text.length()));
  }

  @Override
  public void consume() {
    position++;
  }

  @Override
  public int LA(int distance) {
    int at = distance > 0 ? position + distance - 1 : position + distance;
    if (at < 0 || at >= text.length()) {
      return EOF;
    }
    char found = text.charAt(at);
    return found < NOT_ASCII ? found : NOT_ASCII;
  }

  @Override
  public int mark() {
    return -1;
  }

  @Override
  public void release(int marker) {
    // The whole text is in memory: nothing to free.
  }

  @Override
  public int index() {
    return position;
  }

  @Override
  public void seek(int index) {
    position = index;
  }

  @Override
  public int size() {
    return text.length();
  }

  @Override
  public String getSourceName() {
    return name;
  }
}
