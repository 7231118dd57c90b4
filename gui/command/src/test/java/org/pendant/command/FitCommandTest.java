package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmFile;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.FrictionCurve;
import org.pendant.models.arm.Joints;
import org.pendant.models.json.JsonException;

/** {@code pendant fit}, with recordings of an arm of its own and of a real one. */
@Tag("slow")
final class FitCommandTest {
  private static final Path RECORDINGS = Path.of("../../docs/recordings");

  private static final String PROGRAM =
      """
      def swing():
        set_target_payload(1.5, [0.02, 0, 0.08])
        movej([0.6, -1.0, -1.8, -0.6, 0.6, 0.9], a=3, v=1.5)
        movej([-0.6, -1.9, -0.8, -2.4, 2.4, -0.9], a=2, v=0.8)
        movej([0.2, -1.4, -1.4, -1.0, 1.0, 2.0], a=3, v=1.2)
        movej([0, -1.5, -1.5, -1.5, 1.5, 0], a=1, v=0.3)
      end
      """;

  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  @BeforeEach
  void writeProgram() throws IOException {
    Files.writeString(file("swing.script"), PROGRAM);
  }

  private ExitCode pendant(Object... words) {
    List<String> line = new ArrayList<>();
    for (Object each : words) {
      line.add(each.toString());
    }
    output.reset();
    errors.reset();
    return new Pendant(new Console(output, errors)).run(line);
  }

  private String said() {
    return output.toString(StandardCharsets.UTF_8);
  }

  private String complaints() {
    return errors.toString(StandardCharsets.UTF_8);
  }

  private Path file(String name) {
    return folder.resolve(name);
  }

  private static ArmDescription read(Path file) throws IOException, JsonException {
    try (InputStream in = Files.newInputStream(file)) {
      return ArmFile.read(file.toString(), in);
    }
  }

  /** An arm whose drives are others than those of its model. */
  private static ArmDescription worn() {
    ArmDescription model = ArmLibrary.load("ur5e");
    List<Actuator> drives = new ArrayList<>();
    for (Actuator each : model.actuators()) {
      FrictionCurve friction = each.friction();
      drives.add(
          new Actuator(
              1.2 * each.rotorInertiaKgM2(),
              0.9 * each.torqueConstantNmPerA(),
              new FrictionCurve(
                  1.5 * friction.coulombA(),
                  0.7 * friction.curvedA(),
                  friction.curveSpeedRadPerS(),
                  1.4 * friction.viscousASPerRad(),
                  friction.loadAPerNm()),
              0.0012,
              each.status()));
    }
    return model.withActuators(drives);
  }

  private Path record(Path arm, String name) {
    ExitCode code = pendant("run", "--robot", arm, "--record", file(name), file("swing.script"));
    assertEquals(ExitCode.DONE, code, complaints());
    return file(name);
  }

  @Test
  void findsTheDrivesAndThePayloadOfAnArmThatIsNotAsDescribed() throws Exception {
    ArmDescription worn = worn();
    Path own = Files.writeString(file("worn.json"), ArmFile.text(worn));
    Path recorded = record(own, "swing.rec");

    ExitCode code = pendant("fit", "--robot", "ur5e", "--out", file("found.json"), recorded);

    assertEquals(ExitCode.DONE, code, complaints());
    assertTrue(said().contains("payload: 1.5 kg at 0.02, 0, 0.08 m"), said());
    ArmDescription found = read(file("found.json"));
    for (int i = 0; i < Joints.COUNT; i++) {
      Actuator expected = worn.actuators().get(i);
      Actuator actual = found.actuators().get(i);
      String joint = "joint " + i;
      assertEquals(expected.rotorInertiaKgM2(), actual.rotorInertiaKgM2(), 0.01, joint);
      assertEquals(expected.lagS(), actual.lagS(), 0.0001, joint);
      for (double v : new double[] {0.05, 0.3, 0.8}) {
        assertEquals(
            expected.friction().currentA(v, 0),
            actual.friction().currentA(v, 0),
            0.01,
            joint + " at " + v + " rad/s");
      }
    }
    assertEquals(0.9 * 10.88, found.actuators().get(1).torqueConstantNmPerA(), 0.05);

    Path again = record(file("found.json"), "again.rec");
    assertEquals(
        ExitCode.DONE,
        pendant(
            "compare",
            "--robot",
            own,
            "--limit",
            "target_moment_0=0.01",
            "--limit",
            "target_current_0=0.01",
            "--limit",
            "lag=0.05",
            again,
            file("swing.script")),
        said() + complaints());
  }

  @Test
  void anArmOnAWallIsFittedAsItIsMounted() throws Exception {
    Path wall =
        Files.writeString(
            file("wall.pinst"),
            "pendant installation 1\nmounting tilt-rad=1.5707963 rotation-rad=0.4\n");
    Path floor = Files.writeString(file("floor.pinst"), "pendant installation 1\n");
    Path recorded = file("swing.rec");
    assertEquals(
        ExitCode.DONE,
        pendant("run", "--installation", wall, "--record", recorded, file("swing.script")),
        complaints());

    assertEquals(ExitCode.DONE, pendant("fit", recorded), complaints());
    String asRecorded = said();
    assertTrue(asRecorded.contains("payload: 1.5 kg at 0.02, 0, 0.08 m"), asRecorded);
    assertEquals(ExitCode.DONE, pendant("fit", "--installation", wall, recorded), complaints());
    assertEquals(asRecorded, said());
    assertEquals(ExitCode.DONE, pendant("fit", "--installation", floor, recorded), complaints());
    assertFalse(said().contains("payload: 1.5 kg"), said());
  }

  @Test
  void theArmOfARecordingIsTheOneToBeginWith() throws Exception {
    Path own = Files.writeString(file("worn.json"), ArmFile.text(worn()));
    Path recorded = record(own, "swing.rec");

    assertEquals(ExitCode.DONE, pendant("fit", recorded), complaints());
    String said = said();
    assertEquals(ExitCode.DONE, pendant("fit", "--robot", own, recorded), complaints());
    assertEquals(said, said());
    Path model = record(Path.of("ur5e"), "model.rec");
    assertEquals(ExitCode.WRONG_USAGE, pendant("fit", recorded, model));
    assertTrue(complaints().contains("is of another arm than a recording before it"), complaints());
  }

  @Test
  void aRealArmIsExplainedBetterThanByItsDescription() throws Exception {
    ExitCode code =
        pendant(
            "fit",
            "--robot",
            "ur3e",
            "--payload",
            "1.07",
            "--cog",
            "0,0,0.058",
            "--out",
            file("found.json"),
            RECORDINGS.resolve("ur3e-rad-3.csv"),
            RECORDINGS.resolve("ur3e-rad-5.csv"));

    assertEquals(ExitCode.DONE, code, complaints());
    assertTrue(said().contains("payload, as given: 1.07 kg at 0, 0, 0.058 m"), said());
    assertEquals("ur3e", read(file("found.json")).id());
    assertTrue(
        Files.readString(file("found.json")).contains("drives: fitted to"), "it says from what");
  }

  @Test
  void whatCannotBeFittedIsRefusedAndNothingIsWritten() throws Exception {
    Path table = Files.writeString(file("bare.csv"), "timestamp,actual_q_0\n0,1\n0.1,1\n");
    assertEquals(ExitCode.WRONG_USAGE, pendant("fit", "--out", file("out.json"), table));
    assertFalse(Files.exists(file("out.json")));

    assertEquals(ExitCode.WRONG_USAGE, pendant("fit"));
    assertTrue(complaints().contains("expected one recording or more"), complaints());

    Path recorded = record(Files.writeString(file("own.json"), ArmFile.text(worn())), "a.rec");
    assertEquals(ExitCode.WRONG_USAGE, pendant("fit", "--out", recorded, "--force", recorded));
    assertTrue(complaints().contains("never overwrites"), complaints());
    assertEquals(ExitCode.WRONG_USAGE, pendant("fit", "--out", file("own.json"), recorded));
    assertTrue(complaints().contains("exists already, --force replaces it"), complaints());
  }
}
