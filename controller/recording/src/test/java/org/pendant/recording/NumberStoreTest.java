package org.pendant.recording;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.state.ControllerState;

final class NumberStoreTest {
  @TempDir private Path folder;

  private final Random random = new Random(3);
  private final List<IOException> failures = new ArrayList<>();

  private NumberStore store(Path in, int places) {
    return new NumberStore(
        () -> NumberStore.TemporaryFile.in(in), places, Runnable::run, failures::add);
  }

  private Segment full() {
    Segment segment = new Segment(0);
    double[] numbers = new double[NumberGroup.NUMBERS];
    int frame = 0;
    while (segment.fits(frame, NumberGroup.ALL)) {
      for (int i = 0; i < numbers.length; i++) {
        // all bits, not a number as well
        numbers[i] = Double.longBitsToDouble(random.nextLong());
      }
      segment.begin(frame, NumberGroup.ALL, 0);
      segment.add(numbers, 0, numbers.length);
      segment.publish();
      frame++;
    }
    return segment.trimmed();
  }

  private static long[] bits(Segment segment) {
    long[] bits = new long[segment.numberCount()];
    double[] numbers = segment.numbers();
    for (int i = 0; i < bits.length; i++) {
      bits[i] = Double.doubleToRawLongBits(numbers[i]);
    }
    return bits;
  }

  private List<Path> files() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.toList();
    }
  }

  @Test
  void givesBackEveryBit() {
    NumberStore store = store(folder, 20);
    List<Segment> segments = Stream.generate(this::full).limit(20).toList();
    List<long[]> before = segments.stream().map(NumberStoreTest::bits).toList();
    segments.forEach(store::keep);
    segments.forEach(store::keep);
    assertEquals(20L * NumberStore.PLACE_BYTES, store.usedBytes());
    for (int i = 0; i < 20; i++) {
      assertTrue(segments.get(i).numbersAreAway());
      assertArrayEquals(before.get(i), bits(segments.get(i)));
    }
    assertEquals(List.of(), failures);
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void ofAKilledProcessNothingIsLeft() throws IOException {
    NumberStore store = store(folder, 20);
    Segment segment = full();
    store.keep(segment);
    assertTrue(segment.numbersAreAway());
    assertEquals(List.of(), files());
  }

  @Test
  void whatCannotBeWrittenStaysInMemoryAndThatIsSaidOnce() throws IOException {
    Path missing = folder.resolve("missing");
    NumberStore store = store(missing, 20);
    List<Segment> segments = Stream.generate(this::full).limit(3).toList();
    List<long[]> before = segments.stream().map(NumberStoreTest::bits).toList();
    segments.forEach(store::keep);
    for (int i = 0; i < 3; i++) {
      assertFalse(segments.get(i).numbersAreAway());
      assertArrayEquals(before.get(i), bits(segments.get(i)));
    }
    assertEquals(1, failures.size());
    assertEquals(0, store.usedBytes());

    Files.createDirectory(missing);
    segments.forEach(store::keep);
    assertTrue(segments.stream().allMatch(Segment::numbersAreAway));
    assertEquals(1, failures.size());
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void onAFullDiskAllStaysInMemory() {
    NumberStore store =
        new NumberStore(NumberStoreTest::onFullDisk, 20, Runnable::run, failures::add);
    List<Segment> segments = Stream.generate(this::full).limit(3).toList();
    List<long[]> before = segments.stream().map(NumberStoreTest::bits).toList();
    segments.forEach(store::keep);
    for (int i = 0; i < 3; i++) {
      assertArrayEquals(before.get(i), bits(segments.get(i)));
    }
    assertEquals(1, failures.size());
    assertEquals(0, store.usedBytes());
  }

  private static NumberStore.TemporaryFile onFullDisk() throws IOException {
    return new NumberStore.TemporaryFile(
        new RandomAccessFile("/dev/full", "rw"), new RandomAccessFile("/dev/full", "r"));
  }

  @Test
  void theFileHasAnEnd() {
    NumberStore store = store(folder, 1);
    Segment first = full();
    Segment second = full();
    store.keep(first);
    store.keep(second);
    assertTrue(first.numbersAreAway());
    assertFalse(second.numbersAreAway());
  }

  @Test
  void aPlaceIsUsedAgainWhenNobodyRefersToItAnyMore() {
    NumberStore store = store(folder, 1);
    store.keep(full());
    Segment next = full();
    long[] before = bits(next);
    while (!next.numbersAreAway()) {
      // which collectors of Java promise nobody, so asked until it happens
      System.gc();
      store.keep(next);
    }
    assertArrayEquals(before, bits(next));
  }

  @Test
  void recordingsAreTheSameWithAStore() throws IOException {
    NumberStore store = store(folder, 200);
    RandomStates states = new RandomStates(5);
    ControllerState start = states.next();
    RecordingRing kept = new RecordingRing(start, Optional::empty);
    RecordingRing stored = new RecordingRing(start, Optional::empty, store);
    ControllerState last = start;
    for (int i = 0; i < 700; i++) {
      last = states.next();
      kept.take(last);
      stored.take(last);
    }
    assertTrue(store.usedBytes() > 0, "nothing was tested");
    assertEquals(kept.bytes(), stored.bytes());
    assertArrayEquals(file(kept), file(stored));

    RecordingRing next = RecordingRing.continuing(stored.recording(), last, Optional::empty, store);
    assertArrayEquals(
        file(RecordingRing.continuing(kept.recording(), last, Optional::empty)), file(next));
  }

  private static byte[] file(RecordingRing ring) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    RecordingExport.toRec(ring.recording(), 0, 1e9, out);
    return out.toByteArray();
  }
}
