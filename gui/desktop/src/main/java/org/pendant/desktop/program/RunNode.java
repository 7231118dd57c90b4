package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import org.pendant.desktop.session.ProgramDocument;

/**
 * Run node: the node that a program is at.
 *
 * @param key of the node
 * @param number as it stands beside the node in the tree
 * @param label as in the tree
 */
public record RunNode(ProgramDocument document, long key, int number, String label) {
  /** As people read it in a sentence, such as {@code node 15 Feeder}. */
  public String words() {
    return text("node", number, label);
  }

  /** The same where there is little room, such as {@code node 15}. */
  public String briefly() {
    return text("nodeNumber", number);
  }
}
