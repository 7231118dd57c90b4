package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingExport;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.RecordingRing;

final class LookBackTest {
  /** So many blocks a long file has at least. */
  private static final int BLOCKS = 4;

  private static final String MOVE = "n = 1\nmovej([0, -1.2, -1.5, -1.5, 1.5, 0], a=3, v=2)\n";

  private final RecordedRun run = new RecordedRun().start(MOVE).frames(500);
  private final List<String> told = new ArrayList<>();
  private final LookBack lookBack = new LookBack(run.ring::recording, told::add);

  @Test
  void showsNowUntilSomebodyLooksBack() {
    lookBack.take(run.state());
    assertFalse(lookBack.back());
    assertSame(run.state(), lookBack.shown(run.state()));
    assertEquals("", lookBack.banner());
  }

  @Test
  void showsTheMomentWhileTheRobotGoesOn() {
    lookBack.take(run.state());
    lookBack.scrub(0.2);
    run.frames(250);
    lookBack.take(run.state());

    assertEquals(100, lookBack.shown(run.state()).frame());
    assertEquals(
        "Looking at 0.200 s \u2013 the robot is at 1.500 s; Esc leads back", lookBack.banner());
    assertEquals("test.script", lookBack.program().orElseThrow().source().name());
    lookBack.live();
    assertSame(run.state(), lookBack.shown(run.state()));
  }

  @Test
  void stepsByFramesAndStaysWithinWhatIsKept() {
    lookBack.take(run.state());
    lookBack.step(-1);
    assertEquals(OptionalDouble.of(0.998), lookBack.timeS());
    lookBack.step(-50);
    assertEquals(OptionalDouble.of(0.898), lookBack.timeS());
    lookBack.first();
    lookBack.step(-1);
    assertEquals(OptionalDouble.of(0), lookBack.timeS());
    lookBack.last();
    assertEquals(OptionalDouble.of(1), lookBack.timeS());
  }

  @Test
  void goesFromMarkToMark() {
    lookBack.take(run.state());
    var marks = lookBack.recording().marks();
    lookBack.scrub(0);
    assertTrue(lookBack.toMark(marks, true));
    assertEquals(marks.getFirst().timeS(), lookBack.timeS().orElseThrow());
    assertFalse(lookBack.toMark(marks, false), "there is a mark before the first");
  }

  @Test
  void theOldestThatIsLeftIsShownWhereTheMomentWasDropped() {
    RecordingRing[] ring = {run.ring};
    LookBack moving = new LookBack(() -> ring[0].recording(), told::add);
    moving.scrub(0.1);
    ring[0] = new RecordingRing(run.state(), Optional::empty);
    moving.take(run.state());
    assertEquals(run.state().frame(), moving.shown(run.state()).frame());
  }

  @Test
  void followsNowWithItsRightEndUntilItIsMoved() {
    lookBack.zoom(0.005, 0.5);
    lookBack.take(run.state());
    assertEquals(1, lookBack.range().toS(), 1e-9);
    run.frames(50);
    lookBack.take(run.state());
    assertEquals(1.1, lookBack.range().toS(), 1e-9);
    lookBack.pan(-0.5);
    run.frames(50);
    lookBack.take(run.state());
    assertEquals(0.6, lookBack.range().toS(), 1e-9);
  }

  @Test
  void aMomentThatIsOutOfSightIsBroughtIntoIt() {
    lookBack.take(run.state());
    lookBack.zoom(0.005, 1);
    lookBack.jump(0.1);
    assertTrue(lookBack.range().share(0.1) >= 0 && lookBack.range().share(0.1) <= 1);
  }

  /** Looks at a file of several blocks, and reads these when the test says so. */
  private final class SlowFile {
    private final Deque<Runnable> reads = new ArrayDeque<>();
    private final LookBack looking =
        new LookBack(
            run.ring::recording, told::add, new RecordingReader<>(reads::add, Runnable::run));

    private SlowFile(Path file) throws Exception {
      run.start(
          "while True:\n"
              + "  movej([0, -1.2, -1.5, -1.5, 1.5, 0])\n"
              + "  movej([1, -1, -1, -1, 1, 0])\n"
              + "end\n");
      run.frames(BLOCKS * 1100);
      RecordingExport.toRec(run.ring.recording(), 0, run.state().timeS(), file);
      Recording recording = RecordingFile.open(file).recording();
      looking.open(recording, file, List.of());
    }

    private long shownFrame() {
      return looking.shown(run.state()).frame();
    }
  }

  @Test
  void aMomentOfAFileIsReadOutsideAndShownAtOnceWhereItsBlockIsInMemory(@TempDir Path folder)
      throws Exception {
    SlowFile file = new SlowFile(folder.resolve("long.rec"));
    assertEquals(0, file.shownFrame());

    file.looking.scrub(5);
    assertEquals(0, file.shownFrame(), "the picture before");
    assertEquals(OptionalDouble.of(5), file.looking.timeS(), "the timeline is there already");
    file.looking.step(1);
    assertEquals(OptionalDouble.of(5.002), file.looking.timeS());
    file.reads.remove().run();
    file.reads.remove().run();
    assertEquals(2501, file.shownFrame());

    file.looking.scrub(5.1);
    assertEquals(2550, file.shownFrame());
    assertTrue(file.reads.isEmpty());
  }

  @Test
  void noOlderMomentIsShownInThePlaceOfANewerOne(@TempDir Path folder) throws Exception {
    SlowFile file = new SlowFile(folder.resolve("long.rec"));
    file.looking.scrub(5);
    file.reads.remove().run();
    file.looking.scrub(8);
    file.looking.scrub(5.1);
    assertEquals(2550, file.shownFrame(), "from memory");
    file.reads.remove().run();
    assertEquals(2550, file.shownFrame(), "what was asked for before came later");
    assertEquals(OptionalDouble.of(5.1), file.looking.timeS());

    file.looking.scrub(2);
    file.looking.live();
    file.reads.remove().run();
    assertFalse(file.looking.back());
  }

  @Test
  void ofManyMomentsThatAreAskedForWhileOneIsReadTheNewestIsRead(@TempDir Path folder)
      throws Exception {
    SlowFile file = new SlowFile(folder.resolve("long.rec"));
    for (double timeS : new double[] {3, 5, 7, 9}) {
      file.looking.scrub(timeS);
    }
    file.reads.remove().run();
    assertEquals(1500, file.shownFrame(), "a picture on the way");
    file.reads.remove().run();
    assertEquals(4500, file.shownFrame());
    assertTrue(file.reads.isEmpty());
  }

  @Test
  void aFileThatHasGoneIsToldAndNowIsShown(@TempDir Path folder) throws Exception {
    Path path = folder.resolve("long.rec");
    SlowFile file = new SlowFile(path);
    Files.delete(path);
    file.looking.scrub(5);
    file.reads.remove().run();
    assertFalse(file.looking.back());
    assertTrue(told.getFirst().startsWith("The recording can no longer be read: "), told::toString);
  }

  @Test
  void looksAtAFileUntilPeopleGoBackToTheRobot(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("run.rec");
    RecordingExport.toRec(run.ring.recording(), 0.2, 0.6, file);
    lookBack.open(RecordingFile.open(file).recording(), Path.of("run.rec"), List.of());
    run.frames(10);
    lookBack.take(run.state());

    ControllerState first = lookBack.shown(run.state());
    assertEquals(100, first.frame());
    assertTrue(lookBack.banner().contains("of the recording run.rec"), lookBack.banner());
    assertFalse(lookBack.whyNoBranch().isEmpty());
    lookBack.live();
    lookBack.take(run.state());
    assertFalse(lookBack.ofFile());
    assertEquals(510, lookBack.recording().lastFrame());
  }
}
