package org.pendant.editors.lsp.text;

/** Position encoding: in which units a client counts the characters of a line. */
public enum PositionEncoding {
  UTF8("utf-8"),
  UTF16("utf-16");

  private final String word;

  PositionEncoding(String word) {
    this.word = word;
  }

  /** The name that the protocol has for it. */
  public String word() {
    return word;
  }

  /** How many units a character takes whose UTF-8 form has {@code bytes} bytes. */
  int units(int bytes) {
    return this == UTF8 ? bytes : bytes == 4 ? 2 : 1;
  }
}
