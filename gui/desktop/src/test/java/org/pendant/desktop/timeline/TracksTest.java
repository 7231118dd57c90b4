package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.recording.RecordingMark;
import org.pendant.recording.RecordingMark.Kind;

final class TracksTest {
  private static final MomentPlaces NODES =
      (timeS, line) -> String.format(Locale.ROOT, "node %d at %.1f s", line, timeS);

  private static RecordingMark mark(Kind kind, double timeS, String text) {
    return new RecordingMark(kind, Math.round(500 * timeS), timeS, text, 0);
  }

  @Test
  void aProgramHasABarFromItsStartToItsEnd() {
    List<Tracks.Run> runs =
        Tracks.runs(
            List.of(
                mark(Kind.PROGRAM_STARTED, 1, "a"),
                mark(Kind.PROGRAM_ENDED, 2, "a"),
                mark(Kind.PROGRAM_STARTED, 3, "b"),
                mark(Kind.PROGRAM_FAILED, 4, "why"),
                mark(Kind.PROGRAM_STARTED, 5, "c")),
            0,
            6,
            Optional.empty());
    assertEquals(
        List.of(
            new Tracks.Run(1, 2, "a", false),
            new Tracks.Run(3, 4, "b", true),
            new Tracks.Run(5, 6, "c", false)),
        runs);
  }

  @Test
  void theProgramGoesOnWhenASecondaryOneFails() {
    assertEquals(
        List.of(new Tracks.Run(1, 5, "a", false)),
        Tracks.runs(
            List.of(
                mark(Kind.PROGRAM_STARTED, 1, "a"),
                mark(Kind.PROGRAM_FAILED, 2, "why"),
                mark(Kind.PROGRAM_ENDED, 5, "a")),
            0,
            6,
            Optional.empty()));
  }

  @Test
  void aProgramThatRanBeforeBeginsWithTheRecording() {
    assertEquals(
        List.of(new Tracks.Run(10, 12, "old", false)),
        Tracks.runs(List.of(mark(Kind.PROGRAM_ENDED, 12, "old")), 10, 20, Optional.of("old")));
  }

  @Test
  void aStopAtACollisionTellsWhoHasHitWhat() {
    String hit =
        "C157A2 protective stop at 1.344 s: the forearm has hit \"post\": 0.0016 m, limit 0 m";
    assertEquals(
        List.of(new Tracks.Hit(1.344, "the forearm has hit \"post\"")),
        Tracks.hits(
            List.of(
                mark(Kind.PROTECTIVE_STOP, 1, "C157A0 protective stop: force"),
                mark(Kind.PROTECTIVE_STOP, 1.344, hit),
                mark(Kind.MESSAGE, 2, hit))));
  }

  @Test
  void howNearTheArmWasIsToldWhereSomethingIsAroundIt() {
    RecordedRun run = new RecordedRun().start("def p():\n  sleep(0.1)\nend\n").frames(50);
    Tracks tracks = Tracks.of(run.ring.recording(), new TimeRange(0, 0.1), 50, false, true);
    assertTrue(tracks.nearestM().orElseThrow().lowest(20) > 0.01);
    assertTrue(
        tracks.about(0.05, 0, NODES, PoseForm.STANDARD).matches(".*p runs, nearest \\d+ mm"),
        tracks.about(0.05, 0, NODES, PoseForm.STANDARD));
  }

  @Test
  void distancesAreInTheUnitsOfPeople() {
    RecordedRun run = new RecordedRun().frames(50);
    Tracks tracks = Tracks.of(run.ring.recording(), new TimeRange(0, 0.1), 50, false, true);
    PoseForm inches = new PoseForm(DisplayUnit.INCH, DisplayUnit.DEGREE, RotationForm.VECTOR);
    PoseForm metres = new PoseForm(DisplayUnit.METRE, DisplayUnit.DEGREE, RotationForm.VECTOR);
    assertEquals("0.050 s, nearest 97 mm", tracks.about(0.05, 0, NODES, PoseForm.STANDARD));
    assertEquals("0.050 s, nearest 0.097 m", tracks.about(0.05, 0, NODES, metres));
    assertEquals("0.050 s, nearest 3.82 in", tracks.about(0.05, 0, NODES, inches));
  }

  @Test
  void anObjectThatIsFartherAwayThanLinksAreFromEachOtherIsToldBesideThem() {
    SceneObject ball =
        new SceneObject.Sphere("ball", new Vector3(0.5, 0.2, 0.1), 0.05, Material.DEFAULT);
    Scene scene = new Scene(List.of(ball), Optional.empty(), List.of());
    RecordedRun run = new RecordedRun(ControllerOptions.headless().withScene(scene)).frames(50);
    Tracks tracks = Tracks.of(run.ring.recording(), new TimeRange(0, 0.1), 50, false, true);
    double objectM = tracks.objectM().orElseThrow().lowest(20);
    assertTrue(objectM > tracks.nearestM().orElseThrow().lowest(20));
    assertEquals(
        LookBack.text(0.05)
            + String.format(
                Locale.ROOT, ", nearest %.0f mm, links 97 mm from each other", 1000 * objectM),
        tracks.about(0.05, 0, NODES, PoseForm.STANDARD));
  }

  @Test
  void thePointerOnAWarningSaysWhatTheLogWarnedOfAndWhere() {
    RecordedRun run =
        new RecordedRun().start("sleep(0.1)\nmotion_version_set(99)\nsleep(0.1)\n").frames(75);
    Tracks tracks = Tracks.of(run.ring.recording(), new TimeRange(0, 0.15), 50, false, false);
    Tracks.Warning warning = tracks.warnings().getFirst();
    assertEquals(
        LookBack.text(warning.timeS())
            + ": warning: motion_version_set: ur5e has no motion version 99, it stays at 1 (node 2"
            + " at 0.1 s)",
        tracks.about(warning.timeS() + 0.001, 0.002, NODES, PoseForm.STANDARD));
    assertFalse(
        tracks.about(0.05, 0.002, NODES, PoseForm.STANDARD).contains("warning"),
        tracks.about(0.05, 0.002, NODES, PoseForm.STANDARD));
  }

  @Test
  void findsEdgesPausesAndSpeed() {
    RecordedRun run =
        new RecordedRun()
            .start(
                """
                def p():
                  sleep(0.1)
                  set_standard_digital_out(0, True)
                  movej([0, -1.2, -1.5, -1.5, 1.5, 0], a=3, v=2)
                end
                """)
            .frames(100)
            .pause()
            .frames(200);
    Tracks tracks = Tracks.of(run.ring.recording(), new TimeRange(0, 0.6), 300, false, false);

    assertEquals(1, tracks.outputs().size(), tracks.outputs()::toString);
    assertEquals(0.1, tracks.outputs().getFirst().fromS(), 0.01);
    assertTrue(tracks.inputs().isEmpty());
    assertEquals(1, tracks.pauses().size(), tracks.pauses()::toString);
    assertTrue(tracks.pauses().getFirst().fromS() >= 0.2);
    assertEquals("p", tracks.runs().getFirst().name());
    assertFalse(tracks.speedMPerS().isEmpty());
    assertTrue(tracks.nearestM().isEmpty());
    assertTrue(
        tracks.about(0.05, 0, NODES, PoseForm.STANDARD).endsWith("p runs"),
        tracks.about(0.05, 0, NODES, PoseForm.STANDARD));
  }

  @Test
  void aMoveAtTheStartOfAProgramShowsItsStartRamp() {
    RecordedRun run =
        new RecordedRun()
            .frames(50)
            .start("movej([0, -1.4, -1.5, -1.5, 1.5, 0], t=0.3)\n")
            .frames(250)
            .start("sleep(0.2)\nmovej([0, -1.2, -1.5, -1.5, 1.5, 0], t=0.3)\n")
            .frames(300);
    Tracks tracks = Tracks.of(run.ring.recording(), new TimeRange(0, 1.2), 600, true, false);

    assertEquals(1, tracks.startRamps().size(), tracks.startRamps()::toString);
    assertEquals(0.102, tracks.startRamps().getFirst().fromS(), 1e-9);
    assertEquals(0.262, tracks.startRamps().getFirst().toS(), 1e-9);
    assertTrue(
        tracks.about(0.2, 0, NODES, PoseForm.STANDARD).contains("start ramp"),
        tracks.about(0.2, 0, NODES, PoseForm.STANDARD));
    assertFalse(
        tracks.about(0.3, 0, NODES, PoseForm.STANDARD).contains("start ramp"),
        tracks.about(0.3, 0, NODES, PoseForm.STANDARD));
    Tracks without = Tracks.of(run.ring.recording(), new TimeRange(0, 1.2), 600, false, false);
    assertEquals(List.of(), without.startRamps());
  }
}
