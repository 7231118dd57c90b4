package org.pendant.project.polyscope.xml;

import java.util.Arrays;

/** XML source: the text of a file, and which line an offset is in. */
final class XmlSource {
  private final String text;
  private final int[] lineStarts;

  XmlSource(String text) {
    this.text = text;
    int[] starts = new int[1 + (int) text.chars().filter(c -> c == '\n').count()];
    int lines = 1;
    for (int at = text.indexOf('\n'); at >= 0; at = text.indexOf('\n', at + 1)) {
      starts[lines++] = at + 1;
    }
    lineStarts = starts;
  }

  String text() {
    return text;
  }

  /** The line of an offset, from 1. */
  int line(int offset) {
    int found = Arrays.binarySearch(lineStarts, offset);
    return found >= 0 ? found + 1 : -found - 1;
  }

  /** How far right in its line an offset is, in characters from 1. */
  int column(int offset) {
    return offset - lineStarts[line(offset) - 1] + 1;
  }

  UnreadableFile wrong(int offset, String message) {
    return new UnreadableFile(line(offset), column(offset), message);
  }
}
