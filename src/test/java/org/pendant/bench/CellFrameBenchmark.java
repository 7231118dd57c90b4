package org.pendant.bench;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.JsonException;
import org.pendant.script.vm.ProgramState;

/**
 * One frame of the controller while the arm moves beside objects that rest or that a belt moves.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 4, time = 1)
public class CellFrameBenchmark {
  private static final String BOX = "\"type\": \"box\", \"size\": [0.08, 0.08, 0.08]";
  private static final String ROUND = "\"type\": \"cylinder\", \"radius\": 0.04, \"length\": 0.08";

  /** What stands beside the arm. */
  public enum Beside {
    /** Nothing, and no scene. */
    NOTHING,
    /** 50 boxes on the floor. */
    RESTING,
    /** 20 boxes that a belt carries. */
    MOVING_BOXES,
    /** 20 cylinders that a belt carries. */
    MOVING_CYLINDERS
  }

  /** What is measured. */
  @Param public Beside beside;

  private Controller controller;

  /** Starts the program and lets everything get under way. */
  @Setup
  public void start() throws JsonException {
    ControllerOptions options = ControllerOptions.headless();
    if (beside != Beside.NOTHING) {
      byte[] cell = cell().getBytes(StandardCharsets.UTF_8);
      options =
          options
              .withScene(SceneReader.read("cell", new ByteArrayInputStream(cell)))
              .withEquipment(EquipmentReader.read("cell", new ByteArrayInputStream(cell)));
    }
    BenchmarkScript script =
        BenchmarkScript.load(BenchmarkScript.source("frame_movej"), new Controller(options));
    script.start();
    controller = script.controller();
    for (int i = 0; i < 10_000; i++) {
      controller.advance();
    }
  }

  /** The belt is slow enough to carry them as long as this takes. */
  private String cell() {
    boolean rest = beside == Beside.RESTING;
    String shape = beside == Beside.MOVING_CYLINDERS ? ROUND : BOX;
    String objects =
        IntStream.range(0, rest ? 50 : 20)
            .mapToObj(
                i ->
                    String.format(
                        Locale.ROOT,
                        "{\"name\": \"part %d\", \"pose\": [%.2f, 3, 0.04, 0, 0, 0], \"mass\": 1,"
                            + " %s}",
                        i,
                        0.15 * i - 4.9,
                        shape))
            .collect(Collectors.joining(", "));
    return """
    {"objects": [
      {"type": "box", "name": "belt", "pose": [0, 3, -0.05, 0, 0, 0], "size": [10, 1, 0.1]}, %s],
     "devices": [%s]}
    """
        .formatted(
            objects, rest ? "" : "{\"type\": \"belt\", \"object\": \"belt\", \"speed\": 0.01}");
  }

  /** One frame. */
  @Benchmark
  public void frame() {
    controller.advance();
  }

  /** Looks whether the program still runs. */
  @TearDown
  public void check() {
    if (controller.state().program().state() != ProgramState.RUNNING) {
      throw new IllegalStateException("the program ended");
    }
  }
}
