package org.pendant.motion.toolpath.nc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Rotations;
import org.pendant.motion.PlanningException;

class NcReaderTest {
  private static NcPath read(String text) throws PlanningException {
    return NcReader.read("part.nc", text.getBytes(StandardCharsets.ISO_8859_1));
  }

  @Test
  void readsTheDialectOfTheManualsSample() throws PlanningException {
    NcPath path =
        read(
            """
            %PM1
            N10 G74 Z-5. L1
            N20 G7
            N30 G54
            N40 ; Pocket
            N50 S800 T2 M6 ; (End Mill, Diameter: 8,
            ; Flutes: 3)
            N60 M3
            N80 G54 I0
            N100 M8
            N110 G01 X-12.5 Y-0.25 Z24.9995 C90.0000 B0.0000 F1500
            N120 G00 X-12.5 Y-0.25 Z26.9995 C90.0000 B0.0000 F10000
            """);
    assertEquals(2, path.points().size());
    NcPoint first = path.points().getFirst();
    Pose expected = new Pose(-0.0125, -0.00025, 0.0249995, 0, 0, Math.PI / 2);
    assertTrue(Poses.distance(expected, first.inPart()) < 1e-12, first.toString());
    assertEquals(0.025, first.feedMPerS(), 1e-15);
    assertEquals(11, first.line());
    assertEquals(10 / 60.0, path.points().get(1).feedMPerS(), 1e-15);
    assertEquals(List.of("G74", "G7", "G54", "S", "T", "M6", "M3", "M8"), path.ignored());
  }

  @Test
  void wordsStayInForceUntilTheyChange() throws PlanningException {
    NcPath path = read("G01X1Y2Z3F60\nX4\n\nF120\nZ.5\ng0 y-7. b90");
    List<NcPoint> points = path.points();
    assertEquals(new Pose(0.004, 0.002, 0.003, 0, 0, 0), points.get(1).inPart());
    assertEquals(0.001, points.get(1).feedMPerS(), 1e-15);
    assertEquals(new Pose(0.004, 0.002, 0.0005, 0, 0, 0), points.get(2).inPart());
    assertEquals(0.002, points.get(2).feedMPerS(), 1e-15);
    Pose last = points.get(3).inPart();
    assertEquals(-0.007, last.y());
    assertEquals(Math.PI / 2, last.ry(), 1e-15);
    assertEquals(6, points.get(3).line());
  }

  @Test
  void theToolTurnsByBAboutYAndThenByCAboutZ() throws PlanningException {
    Pose pose = read("G01 X0 Y0 Z0 B90 C90").points().getFirst().inPart();
    double[] matrix = new double[9];
    Rotations.vectorToMatrix(pose.rx(), pose.ry(), pose.rz(), matrix);
    // the z-axis goes to x by B and on to y by C
    assertEquals(0, matrix[2], 1e-12);
    assertEquals(1, matrix[5], 1e-12);
    assertEquals(0, matrix[8], 1e-12);
  }

  @Test
  void linesOfWindowsAndAnEndingPercentAreRead() throws PlanningException {
    assertEquals(2, read("%A\r\nG01 X0 Y0 Z0\r\nX1\r\n%\r\nnonsense").points().size());
    assertEquals(1, read("G01 X0 Y0 Z0\nM30\nnonsense").points().size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "G05 X1 | found G05; known are G00 and G01",
        "G1.5 X1 | found G1.5; known are",
        "G02 X1 Y1 I2 | G02 asks for an arc, must be straight lines",
        "G20 | G20 asks for inches, must be millimetres",
        "G91 | G91 asks for relative coordinates, must be absolute",
        "M99 | found M99; known are M2 and M30",
        "A12 | found A12, letters must be N, G, X",
        "X1 X2 | found X twice, must be once",
        "G00 G01 X1 | found G twice, must be once",
        "X | after X found no number, must be a number",
        "X1.2.3 | after X found 1.2.3, must be a number",
        "X-+1 | after X found -+1, must be a number",
        "X1e300 | after E found 300",
        "12 | found 1, must be a letter",
        "X#1 | after X found no number",
        "X99999 | found X99999, must be within -10000 to 10000 mm",
        "B99999 | found B99999, must be within -36000 to 36000 degrees",
        "F0 | found F0, a feed rate must be above 0",
        "F-5 | found F-5, a feed rate must be above 0",
        "X1 N5 | found N5, a line number must come first",
        "I3 | found I3, must follow G54 to G59",
        "L1 | found L1, must follow G74",
        "(cut) | ( begins no comment here, must be ;",
        "%B | found %B in the middle, must be the first",
        "X1111111111111111111111111111111111111111 | the number of X is too long",
      })
  void refusesWhatItDoesNotKnowWithTheLine(String line, String reason) {
    String text = "G01 X0 Y0 Z0 F100\n" + line + "\n";
    PlanningException error = assertThrows(PlanningException.class, () -> read(text));
    assertEquals("toolpath-file", error.code());
    String message = error.getMessage();
    assertTrue(line.startsWith("X1e") || message.startsWith("part.nc:2: " + reason), message);
    assertTrue(message.startsWith("part.nc:2: "), message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "X0 Y0 Z0 | part.nc:1: a point without G00 or G01",
        "G01 X0 Y0 | part.nc:1: the first point has no Z",
        "G00 | part.nc:1: the file ends without a point",
        "; nothing | part.nc:1: the file ends without a point",
      })
  void refusesAPathWithoutABegin(String text, String reason) {
    PlanningException error = assertThrows(PlanningException.class, () -> read(text));
    assertTrue(error.getMessage().startsWith(reason), error.getMessage());
  }

  @Test
  void noBytesMakeItFailOtherwise() {
    SplittableRandom random = new SplittableRandom(5);
    String letters = "GXYZBCFMSTIL%N;() .-0123456789\n\r\t\u00e9\0";
    for (int i = 0; i < 3000; i++) {
      StringBuilder text = new StringBuilder("G01 X0 Y0 Z0 ");
      for (int k = random.nextInt(40); k > 0; k--) {
        text.append(letters.charAt(random.nextInt(letters.length())));
      }
      try {
        assertTrue(read(text.toString()).points().size() >= 1);
      } catch (PlanningException e) {
        assertTrue(e.getMessage().startsWith("part.nc:"), text.toString());
      }
    }
  }

  @Test
  void countsOfLinesAndPointsAreBounded() {
    PlanningException points =
        assertThrows(
            PlanningException.class,
            () -> read("G01 X0 Y0 Z0\n" + "X1\n".repeat(NcReader.MAX_POINTS)));
    assertTrue(points.getMessage().contains(":100001: too many points"), points.getMessage());
    PlanningException lines =
        assertThrows(PlanningException.class, () -> read(";\n".repeat(NcReader.MAX_LINES + 1)));
    assertTrue(lines.getMessage().contains(":200001: too many lines"), lines.getMessage());
  }
}
