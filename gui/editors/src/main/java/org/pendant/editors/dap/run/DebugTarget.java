package org.pendant.editors.dap.run;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.pendant.controller.Clock;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.VirtualClock;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.language.source.Source;
import org.pendant.testing.run.DebuggedTest;

/**
 * Debug target: a program and the robot that it is to run on.
 *
 * @param file of the program
 * @param source what runs; empty for a tree that cannot run
 * @param generated whether it was made of a tree, so that no file has it
 * @param node which node of the tree a line belongs to
 * @param notes what people should know
 * @param problems what keeps it from running, apart from mistakes in scripts
 * @param options how the controller is switched on
 * @param waveforms what happens at its inputs
 * @param clock a clock for one run
 * @param outside what has to be closed after a run: the ways to other computers
 * @param test what runs if it is a test; empty for a program
 */
public record DebugTarget(
    String file,
    Optional<Source> source,
    boolean generated,
    IntFunction<Optional<String>> node,
    List<String> notes,
    List<String> problems,
    ControllerOptions options,
    InputWaveforms waveforms,
    Supplier<Clock> clock,
    Runnable outside,
    Optional<DebuggedTest> test) {
  /** Copies the lists. */
  public DebugTarget {
    notes = List.copyOf(notes);
    problems = List.copyOf(problems);
  }

  /**
   * A test, which has a controller of its own.
   *
   * @param file that the test is in
   */
  public static DebugTarget of(String file, DebuggedTest test) {
    return new DebugTarget(
        file,
        Optional.of(test.program().source()),
        false,
        line -> Optional.empty(),
        List.of(),
        List.of(),
        test.options(),
        InputWaveforms.NONE,
        VirtualClock::new,
        () -> {},
        Optional.of(test));
  }
}
