package org.pendant.desktop.session;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Programs that are open, and the one among them that Run runs. There is always at least one. One
 * thread uses it, the dispatch thread.
 */
public final class Programs {
  private final List<ProgramDocument> open = new ArrayList<>();
  private final List<Runnable> listeners = new ArrayList<>();
  private ProgramDocument current;

  /** One open program. */
  public Programs(ProgramDocument first) {
    open.add(first);
    current = first;
  }

  /** Those that are open, in the order they were opened. */
  public List<ProgramDocument> all() {
    return List.copyOf(open);
  }

  /** The one that Run runs and Save saves. */
  public ProgramDocument current() {
    return current;
  }

  /** The open program of a file. */
  public Optional<ProgramDocument> of(Path file) {
    Path wanted = file.toAbsolutePath().normalize();
    return open.stream()
        .filter(
            each ->
                each.file()
                    .filter(path -> path.toAbsolutePath().normalize().equals(wanted))
                    .isPresent())
        .findFirst();
  }

  /** Opens a program behind the current one. */
  public void open(ProgramDocument program) {
    if (!open.contains(program)) {
      open.add(program);
      tell();
    }
  }

  /** Makes a program the current one, opening it if it is not open. */
  public void select(ProgramDocument program) {
    if (current != program) {
      if (!open.contains(program)) {
        open.add(program);
      }
      current = program;
      tell();
    }
  }

  /** Closes a program; the last one is replaced by {@code spare}. */
  public void close(ProgramDocument program, ProgramDocument spare) {
    int index = open.indexOf(program);
    if (index < 0) {
      return;
    }
    open.remove(index);
    if (open.isEmpty()) {
      open.add(spare);
    }
    if (current == program) {
      current = open.get(Math.min(index, open.size() - 1));
    }
    tell();
  }

  /** Tells {@code listener} when programs are opened, closed or selected. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void tell() {
    List.copyOf(listeners).forEach(Runnable::run);
  }
}
