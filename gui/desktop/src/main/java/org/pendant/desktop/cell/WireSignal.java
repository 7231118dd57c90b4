package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

/**
 * Wire signal: what of the controller a wire of the cell ends at.
 *
 * @param name as files say it, such as {@code digital_in[0]} or {@code encoder[0]}
 * @param kind what it is
 */
record WireSignal(String name, Kind kind) {
  /** What there is on the side of the controller. */
  enum Kind {
    /** Devices set it. */
    INPUT(text("anInput")),
    /** Programs set it. */
    OUTPUT(text("anOutput")),
    /** Programs set it, and read it. */
    FLAG(text("aFlag")),
    /** Belts turn it. */
    ENCODER(text("anEncoder"));

    private final String words;

    Kind(String words) {
      this.words = words;
    }

    /** Such as {@code an input}. */
    String words() {
      return words;
    }
  }
}
