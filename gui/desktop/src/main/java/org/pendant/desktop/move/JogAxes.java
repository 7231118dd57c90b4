package org.pendant.desktop.move;

/** Jog axes: along whose axes the tool moves. */
enum JogAxes {
  BASE("Base", "the base"),
  TOOL("Tool", "the tool"),
  FRAME("Frame", "the frame that you have set");

  private final String title;
  private final String meaning;

  JogAxes(String title, String meaning) {
    this.title = title;
    this.meaning = meaning;
  }

  /** What the button that chooses it says. */
  String title() {
    return title;
  }

  /** What it is, for a sentence. */
  String meaning() {
    return meaning;
  }
}
