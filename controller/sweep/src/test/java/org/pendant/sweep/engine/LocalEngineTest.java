package org.pendant.sweep.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.run.SweepResult;
import org.pendant.sweep.table.SomeResults;

final class LocalEngineTest {
  private static SweepVariant variant(long number) {
    return new SweepVariant(number, List.of());
  }

  private static SweepResult result(SweepVariant variant) {
    return SomeResults.of(variant);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 7})
  void resultsComeInOrderAndOnceWhateverTheWorkers(int workers) throws IOException {
    List<Long> numbers = new ArrayList<>();
    Set<Long> run = ConcurrentHashMap.newKeySet();
    LocalEngine engine =
        new LocalEngine(
            variant -> {
              assertTrue(run.add(variant.number()), "twice");
              return result(variant);
            },
            workers);
    long end =
        engine.run(
            LocalEngineTest::variant,
            3,
            5000,
            result -> numbers.add(result.variant().number()),
            () -> false);
    assertEquals(5000, end);
    assertEquals(LongStream.range(3, 5000).boxed().toList(), numbers);
  }

  @Test
  void slowRunHoldsUpNobodyButTheResultsBehindIt() throws IOException {
    CountDownLatch othersDone = new CountDownLatch(100);
    List<Long> numbers = new ArrayList<>();
    LocalEngine engine =
        new LocalEngine(
            variant -> {
              if (variant.number() == 0) {
                await(othersDone);
              } else {
                othersDone.countDown();
              }
              return result(variant);
            },
            2);
    engine.run(
        LocalEngineTest::variant,
        0,
        101,
        result -> numbers.add(result.variant().number()),
        () -> false);
    assertEquals(LongStream.range(0, 101).boxed().toList(), numbers);
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void stoppedEngineHasHandedOverAllUpToSomeNumber() throws IOException {
    List<Long> numbers = new ArrayList<>();
    LocalEngine engine = new LocalEngine(LocalEngineTest::result, 2);
    long end =
        engine.run(
            LocalEngineTest::variant,
            0,
            1_000_000_000,
            result -> numbers.add(result.variant().number()),
            () -> numbers.size() >= 1000);
    assertEquals(numbers.size(), end);
    assertEquals(LongStream.range(0, end).boxed().toList(), numbers);
  }

  @Test
  void sinkThatFailsEndsIt() {
    LocalEngine engine = new LocalEngine(LocalEngineTest::result, 2);
    assertThrows(
        IOException.class,
        () ->
            engine.run(
                LocalEngineTest::variant,
                0,
                1000,
                _ -> {
                  throw new IOException("full");
                },
                () -> false));
  }

  @Test
  void faultOfAWorkerIsNotLost() {
    LocalEngine engine =
        new LocalEngine(
            _ -> {
              throw new IllegalStateException("broken");
            },
            2);
    Throwable fault =
        assertThrows(
            IllegalStateException.class,
            () -> engine.run(LocalEngineTest::variant, 0, 10, _ -> {}, () -> false));
    assertEquals("broken", fault.getCause().getMessage());
  }
}
