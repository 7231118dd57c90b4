package org.pendant.kit.settings;

import static org.pendant.kit.settings.SettingsTexts.text;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.kit.fault.Faults;

/**
 * Settings in a file of the user's configuration folder. Changes are written soon, by a thread of
 * its own; a file that cannot be read or written disturbs nothing.
 */
public final class FileSettings implements Settings, AutoCloseable {
  /** Changes within this time (ms) are written together. */
  private static final long DELAY_MS = 300;

  private static final long PATIENCE_S = 5;

  /** Far above any real settings; a larger file is something else. */
  private static final long MAX_BYTES = 1 << 20;

  private final Path file;
  private final Map<String, String> values = new ConcurrentSkipListMap<>();
  private final AtomicBoolean changed = new AtomicBoolean();
  private final ScheduledThreadPoolExecutor writer =
      new ScheduledThreadPoolExecutor(1, Thread.ofPlatform().daemon().name("settings").factory());
  private volatile Optional<String> notice = Optional.empty();
  private Consumer<String> told = text -> {};

  /** Whether the file has something that could not be read, and must not be lost. */
  private boolean unreadable;

  private Optional<String> trouble = Optional.empty();

  private FileSettings(Path file) {
    this.file = file;
    writer.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    // What is put after the end is not written.
    writer.setRejectedExecutionHandler((task, executor) -> {});
  }

  /** Reads a settings file; there may be none yet. */
  public static FileSettings open(Path file) {
    FileSettings settings = new FileSettings(file);
    settings.read();
    return settings;
  }

  private void read() {
    if (!Files.exists(file)) {
      return;
    }
    try {
      if (Files.size(file) > MAX_BYTES) {
        unreadable = true;
        notice = Optional.of(text("tooLarge", file));
        return;
      }
      SettingsText settings = SettingsText.parse(Files.readString(file));
      values.putAll(settings.values());
      if (!settings.wrongLines().isEmpty()) {
        keepAside(text("wrongLines", file, shorten(settings.wrongLines())));
      }
    } catch (CharacterCodingException e) {
      keepAside(text("noText", file));
    } catch (IOException e) {
      unreadable = true;
      notice = Optional.of(text("cannotBeRead", file, FileTrouble.reason(e)));
    }
  }

  private static String shorten(List<Integer> lines) {
    String shown = String.join(", ", lines.stream().limit(5).map(String::valueOf).toList());
    return lines.size() > 5 ? shown + ", ..." : shown;
  }

  private void keepAside(String why) {
    Path copy = file.resolveSibling(file.getFileName() + ".bad");
    try {
      AtomicFile.writePrivate(copy, Files.readAllBytes(file));
      notice = Optional.of(text("ignoredWithCopy", why, copy));
    } catch (IOException e) {
      unreadable = true;
      notice = Optional.of(text("forgotten", why));
    }
  }

  /** What people should know about the file, such as that a part of it was ignored. */
  public Optional<String> notice() {
    return notice;
  }

  /** Tells {@code listener} when they cannot be written, in any thread; at once if it was so. */
  public synchronized void onTrouble(Consumer<String> listener) {
    told = listener;
    trouble.ifPresent(listener);
  }

  private synchronized void written() {
    trouble = Optional.empty();
  }

  /** Tells once: each later change would fail as well. The next one tries again. */
  private synchronized void notWritten(IOException why) {
    if (trouble.isEmpty()) {
      trouble = Optional.of(text("cannotBeWritten", why.getMessage()));
      told.accept(trouble.get());
    }
  }

  @Override
  public Optional<String> get(String name) {
    return Optional.ofNullable(values.get(name));
  }

  @Override
  public void put(String name, String text) {
    if (text.equals(values.put(name, text))) {
      return;
    }
    if (changed.compareAndSet(false, true)) {
      var _ = writer.schedule(() -> Faults.guard(this::write), DELAY_MS, TimeUnit.MILLISECONDS);
    }
  }

  private void write() {
    if (!changed.getAndSet(false) || unreadable) {
      return;
    }
    try {
      AtomicFile.writePrivate(file, SettingsText.format(values).getBytes(StandardCharsets.UTF_8));
      written();
    } catch (IOException e) {
      notWritten(e);
    }
  }

  /** Writes what has changed, now; nothing is written after this. */
  @Override
  public void close() {
    writer.shutdown();
    try {
      // A write that has begun comes to its end first.
      boolean ended = writer.awaitTermination(PATIENCE_S, TimeUnit.SECONDS);
      if (ended) {
        write();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
