package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

/** Jog size: how far the arm moves when the user presses a button. */
enum JogSize {
  /** As long as the button is held. */
  HELD(text("holdSize"), 0),
  FINE("0.1", 0.1),
  MEDIUM("1", 1),
  COARSE("10", 10);

  private final String title;
  private final double size;

  JogSize(String title, double size) {
    this.title = title;
    this.size = size;
  }

  /** What the button that chooses it says. */
  String title() {
    return title;
  }

  /** What it means, as a sentence without its end. */
  String meaning() {
    return this == HELD ? text("moveAsLongAsAButton") : text("moveByMmOrTurnBy", title, title);
  }

  /** What the action that chooses it says. */
  String action() {
    return this == HELD ? text("actionHeld") : text("actionStep", title, title);
  }

  double lengthM() {
    return size / 1000;
  }

  double angleRad() {
    return Math.toRadians(size);
  }
}
