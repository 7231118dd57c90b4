package org.pendant.desktop.debug;

import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.variables.VariableSamples;
import org.pendant.script.vm.ProgramState;

/**
 * Live tree: fills a tree from samples while no program is paused, about ten times a second. It has
 * no Swing; one thread uses it, the dispatch thread.
 */
final class LiveTree {
  /** Least time between two looks at a program that runs, ms. */
  static final long PERIOD_MS = 95;

  private final ValueTree tree;
  private final LongSupplier clockMs;
  private final Source source;
  private VariableSamples shown = VariableSamples.NONE;
  private boolean running;
  private long shownMs;

  /** Makes values of samples. */
  @FunctionalInterface
  interface Source {
    /**
     * The values.
     *
     * @param running whether the program has not ended
     * @param unfolded how many parts are wanted of those that are
     */
    List<ValueNode.Group> of(
        VariableSamples samples, boolean running, Map<ValueKey, Integer> unfolded);
  }

  /**
   * Nothing yet.
   *
   * @param clockMs any clock that runs, ms
   */
  LiveTree(ValueTree tree, LongSupplier clockMs, Source source) {
    this.tree = tree;
    this.clockMs = clockMs;
    this.source = source;
  }

  /**
   * Takes the newest snapshot.
   *
   * @param held whether the tree shows what a debugger found
   */
  void refresh(ControllerState state, boolean held) {
    if (held) {
      return;
    }
    VariableSamples now = state.variables();
    boolean runs = state.program().state() != ProgramState.STOPPED;
    long nowMs = clockMs.getAsLong();
    boolean other = !tree.showsLive() || runs != running || now.run() != shown.run();
    boolean due = nowMs - shownMs >= PERIOD_MS && (!now.equals(shown) || tree.fades(nowMs));
    if (!other && !due) {
      return;
    }
    if (now.run() != shown.run()) {
      tree.programStarted();
    }
    running = runs;
    shown = now;
    shownMs = nowMs;
    tree.showLive(unfolded -> source.of(now, runs, unfolded), nowMs, runs);
  }

  /** The samples that are shown; nothing while a debugger has paused the program. */
  VariableSamples samples() {
    return tree.showsLive() ? shown : VariableSamples.NONE;
  }
}
