package org.pendant.gui.session;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.installation.Installation;

/** The installation that the desktop works with. One thread uses it, the dispatch thread. */
public final class ActiveInstallation {
  private final List<Runnable> listeners = new ArrayList<>();
  private Installation current = Installation.NONE;

  /** What is set up now. */
  public Installation current() {
    return current;
  }

  /** Sets it up anew. */
  public void set(Installation next) {
    if (!next.equals(current)) {
      current = next;
      List.copyOf(listeners).forEach(Runnable::run);
    }
  }

  /** Tells {@code listener} of every change from now on. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }
}
