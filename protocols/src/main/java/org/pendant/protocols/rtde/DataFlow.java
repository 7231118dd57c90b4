package org.pendant.protocols.rtde;

import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.pendant.controller.state.ControllerState;

/**
 * Data flow: the data packages of one client. The client's own thread sets up, starts and pauses;
 * the thread that hands out frames sends.
 */
final class DataFlow {
  private final Consumer<byte[]> sending;

  /** Held while a package is encoded, so that none comes after the answer to a pause. */
  private final ReentrantLock lock = new ReentrantLock();

  private Optional<OutputRecipe> recipe = Optional.empty();
  private double frequencyHz;
  private Optional<Pacing> pacing = Optional.empty();

  /**
   * A flow that is not set up.
   *
   * @param sending must not wait
   */
  DataFlow(Consumer<byte[]> sending) {
    this.sending = sending;
  }

  /** Takes the place of any recipe before, and pauses. */
  void setUp(OutputRecipe wanted, double frequencyHz) {
    lock.lock();
    try {
      recipe = Optional.of(wanted);
      this.frequencyHz = frequencyHz;
      pacing = Optional.empty();
    } finally {
      lock.unlock();
    }
  }

  /** There is no recipe any more that could be sent. */
  void clear() {
    lock.lock();
    try {
      recipe = Optional.empty();
      pacing = Optional.empty();
    } finally {
      lock.unlock();
    }
  }

  /** Whether there is a recipe. */
  boolean ready() {
    lock.lock();
    try {
      return recipe.isPresent();
    } finally {
      lock.unlock();
    }
  }

  /** Sends from the next frame on, if there is a recipe. */
  void start() {
    lock.lock();
    try {
      if (recipe.isPresent() && pacing.isEmpty()) {
        pacing = Optional.of(new Pacing(frequencyHz));
      }
    } finally {
      lock.unlock();
    }
  }

  /** Sends nothing any more; what was sent before this call is on its way. */
  void pause() {
    lock.lock();
    try {
      pacing = Optional.empty();
    } finally {
      lock.unlock();
    }
  }

  /** A frame has come. */
  void frame(ControllerState state) {
    lock.lock();
    try {
      if (pacing.isPresent() && pacing.get().due()) {
        sending.accept(recipe.orElseThrow().encode(state));
      }
    } finally {
      lock.unlock();
    }
  }
}
