package org.pendant.protocols.server;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Port opening: opens the ports that can be opened, and keeps account of those that cannot. */
public final class PortOpening {
  private final List<MissingPort> missing = new ArrayList<>();

  /** Opens a port, or several that make sense together only. */
  @FunctionalInterface
  public interface Attempt {
    /** Opens it, or throws what is told to people. */
    void open() throws IOException;
  }

  /**
   * Makes an attempt.
   *
   * @param standardPort the number on a real box
   */
  public void attempt(int standardPort, Attempt attempt) {
    try {
      attempt.open();
    } catch (IOException e) {
      missing.add(new MissingPort(standardPort, e.getMessage()));
    }
  }

  /** What could not be had so far. */
  public List<MissingPort> missing() {
    return List.copyOf(missing);
  }
}
