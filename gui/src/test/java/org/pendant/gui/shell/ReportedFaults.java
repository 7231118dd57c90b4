package org.pendant.gui.shell;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/** Faults of all threads, as the window hears of them; as before when closed. */
final class ReportedFaults implements AutoCloseable {
  private final Thread.UncaughtExceptionHandler before =
      Thread.getDefaultUncaughtExceptionHandler();
  private final List<Throwable> all = new CopyOnWriteArrayList<>();

  ReportedFaults() {
    Thread.setDefaultUncaughtExceptionHandler((thread, fault) -> all.add(fault));
  }

  /** Those so far. */
  List<Throwable> all() {
    return all;
  }

  @Override
  public void close() {
    Thread.setDefaultUncaughtExceptionHandler(before);
  }
}
