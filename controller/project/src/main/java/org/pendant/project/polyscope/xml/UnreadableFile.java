package org.pendant.project.polyscope.xml;

import static org.pendant.project.polyscope.xml.PolyscopeXmlTexts.text;

/** File format error: a file is not what it should be. */
public final class UnreadableFile extends Exception {
  private static final long serialVersionUID = 1;

  private final int line;
  private final int column;

  /**
   * Tells what is wrong.
   *
   * @param line where, from 1; 0 for the file as a whole
   * @param column where it begins, in characters from 1; 0 for the file as a whole
   * @param message what was found and what would be right
   */
  public UnreadableFile(int line, int column, String message) {
    super(message, null, false, false);
    this.line = line;
    this.column = column;
  }

  /** About the file as a whole. */
  UnreadableFile(String message) {
    this(0, 0, message);
  }

  /** Where it is, from 1; 0 for the file as a whole. */
  public int line() {
    return line;
  }

  /** Where it begins, in characters from 1; 0 for the file as a whole. */
  public int column() {
    return column;
  }

  /** What and where, as compilers say it: {@code pick.urp:3:7: error: ...}. */
  public String report(String fileName) {
    return text("errorReport", place(fileName), getMessage());
  }

  /** What and where, within a sentence: {@code pick.urp:3:7: ...}. */
  public String told(String fileName) {
    return place(fileName) + ": " + getMessage();
  }

  private String place(String fileName) {
    return line == 0 ? fileName : fileName + ":" + line + ":" + column;
  }
}
