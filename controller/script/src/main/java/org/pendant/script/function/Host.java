package org.pendant.script.function;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * Host: what programs run on. Built-ins know the whole of it by its own type; this is what the
 * virtual machine itself needs.
 */
public interface Host {

  /** Says something that is worth a look, but stops nothing. */
  void warn(String message);

  /** Reports a mistake of ours that a program continued after. */
  void internalError(Throwable fault);

  /** Has whatever the host says from now on carry the place that {@code place} answers. */
  void placeMessagesBy(Supplier<Optional<ScriptPlace>> place);

  /** The primary program is over. */
  void programEnded();

  /** What was begun comes to rest: the program's time will stand still. */
  void pauseMotion();

  /** What {@link #pauseMotion} has stopped continues. */
  void resumeMotion();

  /**
   * Whether a motion continues to its end though no thread waits for it any more: the program is
   * not over before it is.
   */
  boolean arriving();

  /**
   * Whether the motion that comes to rest needs to know before that what follows it: threads run on
   * until they have said so.
   */
  boolean handsOverBeforeRest();

  /** Whether the motion that has just begun depends on what follows it. */
  boolean wantsLookAhead();
}
