package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

/** Node change: what is done to nodes as a whole, as the history of a program calls it. */
enum NodeChange {
  ADD("addKind", "addSeveral"),
  COPY("copyOne", "copySeveral"),
  MOVE("moveOne", "moveSeveral"),
  DELETE("deleteOne", "deleteSeveral"),
  PASTE("pasteOne", "pasteSeveral"),
  DUPLICATE("duplicateOne", "duplicateSeveral"),
  SUPPRESS("suppressOne", "suppressSeveral"),
  USE("useOne", "useSeveral");

  private final String one;
  private final String several;

  NodeChange(String one, String several) {
    this.one = one;
    this.several = several;
  }

  /** {@code Delete Wait}. */
  String ofOne(String label) {
    return text(one, label);
  }

  /** {@code Delete 3 nodes}. */
  String of(int count) {
    return text(several, count);
  }
}
