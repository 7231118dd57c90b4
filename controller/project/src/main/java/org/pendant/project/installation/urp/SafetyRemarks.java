package org.pendant.project.installation.urp;

import static org.pendant.project.installation.urp.InstallationUrpTexts.text;

import java.util.List;

/**
 * Safety remarks: what is told of safety settings: with their lines, and so much that people can
 * read it.
 */
final class SafetyRemarks {
  /** Files that were not made to annoy have far less. */
  static final int MOST = 50;

  private final List<String> remarks;
  private int count;

  SafetyRemarks(List<String> remarks) {
    this.remarks = remarks;
  }

  /**
   * Adds one.
   *
   * @param line that it is about; 0 for none
   */
  void add(int line, String what) {
    count++;
    if (count <= MOST) {
      remarks.add(line > 0 ? text("atLine", line, what) : what);
    }
  }

  /** Says how much was not told. */
  void close() {
    if (count > MOST) {
      remarks.add(text("moreRemarks", count - MOST));
    }
  }
}
