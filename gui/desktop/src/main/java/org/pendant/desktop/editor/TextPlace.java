package org.pendant.desktop.editor;

import java.util.List;

/**
 * Text place: where people were in a text: what they come back to when they open it again.
 *
 * @param line of the caret, from 1
 * @param column of the caret in characters, from 1
 * @param folded the first lines of the blocks that are folded, from 1
 */
public record TextPlace(int line, int column, List<Integer> folded) {
  /** The start of a text with nothing folded. */
  public static final TextPlace START = new TextPlace(1, 1, List.of());

  /** The lines are copied. */
  public TextPlace {
    folded = List.copyOf(folded);
  }
}
