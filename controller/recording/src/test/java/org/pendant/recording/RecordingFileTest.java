package org.pendant.recording;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.LinkFrames;

@Tag("slow")
final class RecordingFileTest {
  @TempDir Path folder;

  private static List<ControllerState> states(long seed, int count) {
    RandomStates random = new RandomStates(seed);
    List<ControllerState> states = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      states.add(random.next());
    }
    return states;
  }

  private static byte[] bytes(List<ControllerState> states) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (RecordingWriter writer = new RecordingWriter(out, states.getFirst())) {
      writer.note(new RecordedProgram(3, "one", Source.of("one.script", "a = 1\n")));
      for (ControllerState each : states.subList(1, states.size())) {
        writer.write(each);
      }
      writer.note(new RecordedProgram(900, "two", Source.of("one.script", "a = 1\n")));
    }
    return out.toByteArray();
  }

  private Path file(byte[] bytes) throws IOException {
    return Files.write(folder.resolve("some.rec"), bytes);
  }

  @Test
  void aFileKnowsTheCalibrationOfItsArm() throws IOException {
    LinkFrames frames = LinkFrames.of(ArmLibrary.load("ur5e").dh());
    DhDeltas deltas =
        new DhDeltas(Joints.ZERO.with(1, 1.5), Joints.ZERO, Joints.ZERO, Joints.ZERO.with(2, 1e-3));
    Calibration ofDeltas =
        new Calibration(deltas, List.of(1, 2, 3, 4, -5, 6), Calibration.Status.NOT_LINEARISED);
    for (Calibration each : List.of(Calibration.NONE, ofDeltas, Calibration.of(frames))) {
      ControllerState state =
          new Controller(ControllerOptions.headless().withCalibration(each)).state();
      Recording found = RecordingFile.open(file(bytes(List.of(state)))).recording();
      assertEquals(each, found.arm().calibration());
      assertEquals(
          state.arm().targetTcpInBase(),
          found.atFrame(state.frame()).arm().targetTcpInBase(),
          each::toString);
    }
  }

  @Test
  void aFileGivesBackWhatTheRingHas() throws IOException {
    for (long seed = 1; seed <= 3; seed++) {
      List<ControllerState> states = states(seed, 600);
      RecordingRing ring = new RecordingRing(states.getFirst(), Optional::empty);
      states.subList(1, states.size()).forEach(ring::take);
      RecordingFile.Opened opened = RecordingFile.open(file(bytes(states)));

      assertTrue(opened.warning().isEmpty(), "seed " + seed);
      Recording wanted = ring.recording();
      Recording found = opened.recording();
      assertEquals(wanted.lastFrame(), found.lastFrame(), "seed " + seed);
      for (ControllerState each : states) {
        SameState.assertSame(wanted.atFrame(each.frame()), found.atFrame(each.frame()));
      }
      assertEquals(wanted.log(0, 1e9), found.log(0, 1e9), "seed " + seed);
      assertEquals(wanted.marks(), found.marks(), "seed " + seed);
      assertEquals("ur10e", found.arm().id());
    }
  }

  @Test
  void keepsTheTextsOfPrograms() throws IOException {
    Recording recording = RecordingFile.open(file(bytes(states(1, 500)))).recording();

    assertEquals(2, recording.programs().size());
    assertTrue(recording.programAt(0).isEmpty());
    RecordedProgram one = recording.programAt(0.01).orElseThrow();
    assertEquals("one", one.name());
    assertEquals("a = 1", one.source().lineText(1));
    assertEquals("two", recording.programAt(100).orElseThrow().name());
    assertEquals("one.script", recording.programAt(100).orElseThrow().source().name());
  }

  @Test
  void equalFramesMakeEqualFiles() throws IOException {
    assertArrayEquals(bytes(states(4, 400)), bytes(states(4, 400)));
  }

  @Test
  void aFileThatIsCutOffEndsWithItsLastWholeBlock() throws IOException {
    for (long seed : new long[] {2, 5}) {
      assertCutsEndWithTheirLastWholeBlock(bytes(states(seed, 1500)));
    }
  }

  private void assertCutsEndWithTheirLastWholeBlock(byte[] whole) throws IOException {
    Path original = Files.write(folder.resolve("whole.rec"), whole);
    Recording wanted = RecordingFile.open(original).recording();
    Random random = new Random(3);
    int opened = 0;
    for (int i = 0; i < 40; i++) {
      int length = random.nextInt(whole.length);
      Path cut = file(Arrays.copyOf(whole, length));
      try {
        RecordingFile.Opened found = RecordingFile.open(cut);
        opened++;
        assertTrue(found.warning().orElseThrow().startsWith("some.rec is cut off: it ends at"));
        // the last frame itself may continue in the next block, where a debugger held it
        long last = found.recording().lastFrame() - 1;
        if (last < wanted.firstFrame()) {
          continue;
        }
        SameState.assertSame(wanted.atFrame(last), found.recording().atFrame(last));
      } catch (RecordingException e) {
        assertTrue(e.getMessage().startsWith("some.rec: "), e.getMessage());
      }
    }
    assertTrue(opened > 20, opened + " opened");
  }

  /** Counts what is flushed, as that is what a killed process leaves behind. */
  private static final class Flushed extends ByteArrayOutputStream {
    private int flushed;

    @Override
    public void flush() {
      flushed = size();
    }

    byte[] kept() {
      return Arrays.copyOf(toByteArray(), flushed);
    }
  }

  @Test
  void aFileOfAProcessThatIsKilledAtOnceHasTheFirstSnapshot() throws IOException {
    ControllerState start = states(9, 1).getFirst();
    Flushed out = new Flushed();
    RecordingWriter unused = new RecordingWriter(out, start);

    RecordingFile.Opened opened = RecordingFile.open(file(out.kept()));
    assertTrue(opened.warning().orElseThrow().startsWith("some.rec is cut off: it ends at"));
    SameState.assertSame(start, opened.recording().atFrame(start.frame()));
    unused.close();
  }

  @Test
  void aFileOfAKilledProcessLacksTheLastMinuteAtMost() throws IOException {
    Controller controller = new Controller(ControllerOptions.headless());
    Flushed out = new Flushed();
    RecordingWriter writer = new RecordingWriter(out, controller.state());
    for (int i = 0; i < 150 * 500; i++) {
      controller.advance();
      writer.write(controller.state());
      if (i % 18_713 == 0) {
        Recording kept = RecordingFile.open(file(out.kept())).recording();
        long lost = controller.state().frame() - kept.lastFrame();
        assertTrue(lost <= 61 * 500, lost + " frames are lost after " + i);
      }
    }
    writer.close();
  }

  @Test
  void aFileWithAWrongBitIsRefused() throws IOException {
    byte[] whole = bytes(states(2, 300));
    Random random = new Random(5);
    for (int i = 0; i < 200; i++) {
      byte[] wrong = whole.clone();
      int at = random.nextInt(whole.length);
      wrong[at] ^= (byte) (1 << random.nextInt(8));
      try {
        // a length may now reach beyond the end: then the file looks cut off
        assertTrue(RecordingFile.open(file(wrong)).warning().isPresent(), "bit in byte " + at);
      } catch (RecordingException e) {
        assertTrue(e.getMessage().startsWith("some.rec: "), e.getMessage());
      }
    }
  }

  @Test
  void bytesThatSomebodyMadeUpAreRefusedWithoutHarm() throws MalformedBytes {
    List<ControllerState> states = states(6, 8);
    List<Segment> begun = new ArrayList<>();
    SnapshotEncoder snapshotEncoder =
        new SnapshotEncoder(states.getFirst(), begun::add, full -> {}, 0);
    states.forEach(snapshotEncoder::take);
    ByteSink sink = new ByteSink();
    SegmentBytes.write(begun.getFirst(), begun.getFirst().published(), sink);
    byte[] whole = Arrays.copyOf(sink.array(), sink.size());
    assertEquals(
        begun.getFirst().published(), SegmentBytes.read(new ByteSource(whole)).published());

    Random random = new Random(8);
    int refused = 0;
    for (int i = 0; i < 1500; i++) {
      byte[] wrong =
          random.nextInt(4) == 0 ? Arrays.copyOf(whole, i % whole.length) : whole.clone();
      for (int k = 0; k < 1 + random.nextInt(3) && wrong.length > 0; k++) {
        wrong[random.nextInt(wrong.length)] = (byte) random.nextInt();
      }
      try {
        SegmentBytes.read(new ByteSource(wrong));
      } catch (MalformedBytes | IllegalArgumentException e) {
        refused++;
      }
    }
    assertTrue(refused > 150, refused + " refused");
  }

  @Test
  void saysWhatIsNoRecording() throws IOException {
    assertRefused(new byte[0], "is no recording of Pendant");
    assertRefused(
        "time_s,target_q_0\n0.002,1\n".getBytes(StandardCharsets.US_ASCII),
        "is no recording of Pendant");
    assertRefused(Arrays.copyOf(bytes(states(1, 3)), 15), "ends in its header");
    byte[] newer = bytes(states(1, 3));
    newer[8] = 9;
    assertRefused(newer, "is of version 9, must be " + FileFormat.VERSION);
  }

  @Test
  void lengthsThatCannotBeAreRefusedBeforeAnythingIsMade() throws IOException {
    byte[] whole = bytes(states(1, 3));
    int header = ByteBuffer.wrap(whole).order(ByteOrder.LITTLE_ENDIAN).getInt(12);
    int block = FileFormat.MAGIC.length + 12 + header;
    for (int length : new int[] {Integer.MAX_VALUE, -1, FileFormat.MAX_BLOCK_BYTES}) {
      byte[] wrong = whole.clone();
      ByteBuffer.wrap(wrong).order(ByteOrder.LITTLE_ENDIAN).putInt(block + 1, length);
      assertRefused(wrong, "which cannot be");
    }
    byte[] wrong = whole.clone();
    ByteBuffer.wrap(wrong).order(ByteOrder.LITTLE_ENDIAN).putInt(12, Integer.MAX_VALUE);
    assertRefused(wrong, "its header has 2147483647 bytes");
  }

  private void assertRefused(byte[] bytes, String why) throws IOException {
    Path file = file(bytes);
    String message =
        assertThrows(RecordingException.class, () -> RecordingFile.open(file)).getMessage();
    assertTrue(message.startsWith("some.rec: ") && message.contains(why), message);
  }

  @Test
  void whyAFileCannotBeOpenedIsToldApart() throws IOException {
    assertThrows(
        NoSuchFileException.class, () -> RecordingFile.open(folder.resolve("nothing.rec")));
    IOException aFolder = assertThrows(IOException.class, () -> RecordingFile.open(folder));
    assertEquals("it is a folder", FileTrouble.reason(aFolder));
  }

  @Test
  void aFileThatHasGoneIsToldWhereItIsAsked() throws IOException {
    Path file = file(bytes(states(1, 50)));
    Recording recording = RecordingFile.open(file).recording();
    Files.delete(file);

    assertThrows(UncheckedIOException.class, () -> recording.at(0));
  }

  @Test
  void anExportHasTheChosenStretchOnly() throws IOException {
    List<ControllerState> states = states(9, 2000);
    RecordingRing ring = new RecordingRing(states.getFirst(), Optional::empty);
    states.forEach(ring::take);
    for (int number = 0; number < 3; number++) {
      ring.note(
          new RecordedProgram(400L * number, "p" + number, Source.of("p.script", "a = " + number)));
    }
    Recording recording = ring.recording();
    double fromS = Recording.timeS(states.get(700).frame());
    double toS = Recording.timeS(states.get(1300).frame());
    Path file = folder.resolve("part.rec");

    RecordingExport.toRec(recording, fromS, toS, file);
    Recording part = RecordingFile.open(file).recording();
    assertEquals(states.get(700).frame(), part.firstFrame());
    assertEquals(states.get(1300).frame(), part.lastFrame());
    for (ControllerState each : states.subList(700, 1300)) {
      SameState.assertSame(recording.atFrame(each.frame()), part.atFrame(each.frame()));
    }
    assertFalse(part.programs().isEmpty());
    assertEquals(
        recording.programAt(fromS).orElseThrow().name(),
        part.programAt(fromS).orElseThrow().name());
  }

  @Test
  void aTableOfARecordingIsThatOfTheRun() throws IOException {
    Controller controller = new Controller(ControllerOptions.headless());
    RecordingRing ring = new RecordingRing(controller.state(), Optional::empty);
    Path table = folder.resolve("run.csv");
    try (Recorder recorder = Recorder.to(Files.newOutputStream(table), List.of())) {
      recorder.write(controller.state());
      for (int i = 0; i < 100; i++) {
        controller.advance();
        ring.take(controller.state());
        recorder.write(controller.state());
      }
    }
    Path made = folder.resolve("made.csv");

    RecordingExport.toCsv(ring.recording(), 0, 1000, made);
    assertEquals(Files.readAllLines(table), Files.readAllLines(made));
  }
}
