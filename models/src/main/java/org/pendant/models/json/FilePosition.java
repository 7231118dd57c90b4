package org.pendant.models.json;

/** File position: where something stands in a file; lines and columns count from 1. */
public record FilePosition(String file, int line, int column) {

  /** The place that follows {@code text}, which begins the file. */
  static FilePosition after(String file, CharSequence text) {
    int line = 1;
    int column = 1;
    for (int i = 0; i < text.length(); i++) {
      boolean lineEnds = text.charAt(i) == '\n';
      line += lineEnds ? 1 : 0;
      column = lineEnds ? 1 : column + 1;
    }
    return new FilePosition(file, line, column);
  }

  /** The complaint about what stands here. */
  public JsonException refusal(String message) {
    return new JsonException(file + ":" + line + ":" + column + ": " + message);
  }
}
