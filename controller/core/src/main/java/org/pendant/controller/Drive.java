package org.pendant.controller;

import java.util.Optional;
import java.util.SortedMap;
import java.util.function.BooleanSupplier;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.language.source.Source;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.value.Value;

/** Drive of a robot: lets its time pass; used by one thread alone. */
public interface Drive extends Frames {
  /** The newest snapshot; any thread. */
  ControllerState state();

  /** Time of the last frame, s, as the newest snapshot has it; the thread that drives alone. */
  double timeS();

  /** The program, as the newest snapshot has it; the thread that drives alone. */
  ProgramStatus program();

  /**
   * Whether the newest snapshot has log lines or popups that the one before had not; the thread
   * that drives alone. Who runs frames and only wants to know that makes no snapshots.
   */
  boolean broughtMessages();

  /**
   * Runs frames in the calling thread until a condition holds, looked at after each.
   *
   * @param condition usually about {@link #state}
   * @param maxFrames how many frames to run at most
   * @return whether the condition came to hold
   */
  default boolean runUntil(BooleanSupplier condition, long maxFrames) {
    for (long i = 0; i < maxFrames; i++) {
      advance();
      if (condition.getAsBoolean()) {
        return true;
      }
    }
    return false;
  }

  /** Has {@code journal} told of every command from now on. */
  void noteCommandsIn(CommandJournal journal);

  @Override
  default boolean held() {
    return state().debug().held();
  }

  /** The text of the running or last program. */
  Optional<Source> programSource();

  /** Copies of the global variables of the running or last program, by name. */
  SortedMap<String, Value> globals();

  /**
   * What the running or last program has reached so far; empty before the first and for one that
   * was loaded without coverage.
   */
  Optional<Coverage> coverage();
}
