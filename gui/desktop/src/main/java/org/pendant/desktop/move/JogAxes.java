package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

/** Jog axes: along whose axes the tool moves. */
enum JogAxes {
  BASE(text("baseAxes"), text("theBase")),
  TOOL(text("toolAxes"), text("theTool")),
  FRAME(text("frameAxes"), text("theFrameOfYours"));

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
