package org.pendant.project.program;

import java.util.List;

/** Pattern: the places of a {@link TemplateStep.Palletizing}. Corners are names of waypoints. */
public sealed interface Pattern {

  /** Places at equal distances from a first to a last one. */
  record Line(String first, String last, int count) implements Pattern {}

  /**
   * Rows of places between four corners, in the order first, end of the first row, beginning of the
   * last row, last.
   */
  record Square(List<String> corners, int columns, int rows) implements Pattern {
    public Square {
      corners = List.copyOf(corners);
    }
  }

  /** Squares above each other, between the four corners of the lowest and of the highest one. */
  record Box(List<String> corners, int columns, int rows, int layers) implements Pattern {
    public Box {
      corners = List.copyOf(corners);
    }
  }

  /** Any places. */
  record Places(List<String> places) implements Pattern {
    public Places {
      places = List.copyOf(places);
    }
  }
}
