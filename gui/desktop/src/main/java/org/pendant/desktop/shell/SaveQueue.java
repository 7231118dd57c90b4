package org.pendant.desktop.shell;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.kit.background.Background;
import org.pendant.kit.fault.Faults;

/**
 * Save queue: writes files elsewhere: those of one name in the order in which they were handed in,
 * so that what was saved last is what stays. Files of other names do not wait for each other. Only
 * the dispatch thread calls it.
 */
final class SaveQueue {
  /** What is waiting for each file, the first being at work. */
  private final Map<Path, Deque<Runnable>> files = new LinkedHashMap<>();

  private final List<Runnable> waiting = new ArrayList<>();

  /**
   * Writes a file, after all that was handed in for it before.
   *
   * @param begin called on the dispatch thread when its turn has come; what it gives back writes
   * @param then takes the result, on the dispatch thread
   * @param failed takes the reason if it fails, on the dispatch thread
   */
  <T> void add(
      Path file,
      Supplier<Background.Task<T>> begin,
      Consumer<T> then,
      Consumer<IOException> failed) {
    Path name = nameOf(file);
    Runnable turn =
        () ->
            Background.run(
                begin.get(),
                result -> done(name, () -> then.accept(result)),
                trouble -> done(name, () -> failed.accept(trouble)));
    Deque<Runnable> queue = files.computeIfAbsent(name, path -> new ArrayDeque<>());
    queue.add(turn);
    if (queue.size() == 1) {
      turn.run();
    }
  }

  private static Path nameOf(Path file) {
    return file.toAbsolutePath().normalize();
  }

  /** The next one begins only after the last one was told: it may depend on what came of it. */
  private void done(Path name, Runnable tell) {
    Faults.guard(tell);
    Deque<Runnable> queue = files.get(name);
    queue.remove();
    if (queue.isEmpty()) {
      files.remove(name);
    } else {
      queue.element().run();
    }
    if (files.isEmpty()) {
      List<Runnable> told = List.copyOf(waiting);
      waiting.clear();
      told.forEach(Faults::guard);
    }
  }

  /** Whether a file is being written, or is to be. */
  boolean writes(Path file) {
    return files.containsKey(nameOf(file));
  }

  /** The files that are being written. */
  List<Path> underWay() {
    return List.copyOf(files.keySet());
  }

  /** Runs {@code action} when nothing is being written: now, or later on the dispatch thread. */
  void whenDone(Runnable action) {
    if (files.isEmpty()) {
      action.run();
    } else {
      waiting.add(action);
    }
  }
}
