package org.pendant.desktop.lines;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.editor.LineNote;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.recording.lines.LineStatistics;
import org.pendant.recording.lines.Margin;
import org.pendant.recording.lines.RunProfile;
import org.pendant.recording.lines.Worst;

/** How it reads what a line took. */
final class LineFiguresTest {
  private static final LineStatistics MOVE =
      new LineStatistics(
          3,
          12,
          2050,
          180,
          0.96,
          0.5,
          List.of(
              new Worst(Margin.JOINT_SPEED, 0.36, "base", 7),
              new Worst(Margin.TORQUE, 0.25, "shoulder", 8),
              new Worst(Margin.JOINT_LIMIT, Math.toRadians(41), "elbow", 9),
              new Worst(Margin.PLANE, 0.0042, "Table", 9)));

  private static LineNote note(LineStatistics line) {
    return new LineFigures(PoseForm.STANDARD).note(line, 0.38);
  }

  @Test
  void theMostImportantPartsOfAMoveComeFirst() {
    assertEquals(
        List.of(
            "4.10 s",
            "12\u00d7",
            "960 mm",
            "speed 36 % base",
            "torque 25 % shoulder",
            "4.2 mm to Table",
            "41\u00b0 to the limit of elbow",
            "longest 0.360 s"),
        note(MOVE).parts());
  }

  @Test
  void theHeatSaysTheShareOfTheCycle() {
    assertEquals("38 % of the cycle: 4.10 s in 12 executions", note(MOVE).heat());
  }

  @Test
  void aLineThatMovesNothingHasItsTimeOnly() {
    LineStatistics wait =
        new LineStatistics(
            4, 1, 150, 150, 0, 0, List.of(new Worst(Margin.TORQUE, 0.2, "shoulder", 3)));
    assertEquals(List.of("0.300 s"), note(wait).parts());
  }

  @Test
  void beyondAPlaneIsSaidSo() {
    LineStatistics beyond =
        new LineStatistics(
            4, 1, 150, 150, 0.1, 0, List.of(new Worst(Margin.PLANE, -0.025, "Table", 3)));
    assertEquals("25 mm beyond Table", note(beyond).parts().get(2));
  }

  @Test
  void lengthsAndAnglesAreInTheUnitsOfTheWindow() {
    LineFigures figures =
        new LineFigures(
            new PoseForm(DisplayUnit.METRE, DisplayUnit.RADIAN, PoseForm.STANDARD.rotation()));
    assertEquals("0.9600 m", figures.way(0.96));
    assertEquals("0.72 rad", figures.angle(Math.toRadians(41)));
  }

  @Test
  void aWorstMomentNamesThePlaceInTheProgram() {
    RunProfile.Moment nearest =
        new RunProfile.Moment(new Worst(Margin.PLANE, 0.0042, "Table", 9), 70);
    assertEquals(
        "nearest to a safety plane, 4.2 mm to Table (node 15 Feeder)",
        new LineFigures(PoseForm.STANDARD)
            .moment(nearest, line -> line == 70 ? "node 15 Feeder" : "line " + line));
  }
}
