package org.pendant.kit.fault;

import static org.pendant.kit.fault.FaultTexts.text;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Fault file: a file with the faults of ours. Each kind of fault is written once with all there is
 * to know; how often it came again is written at 10, 100, 1000 times and so on. Any thread may call
 * it.
 */
public final class FaultFile {
  /** A file of this size (bytes) is put aside; only the newest one that was is kept. */
  static final long MAX_BYTES = 1 << 20;

  /** More kinds than this are not told apart any more. */
  static final int MAX_KINDS = 256;

  private static final int MAX_FRAMES = 60;
  private static final int MAX_CAUSES = 5;
  private static final int MAX_CHARACTERS = 1_000;
  private static final String OWN_CODE = "org.pendant.";

  private final Path file;
  private final InstantSource clock;
  private final Map<Kind, Long> counts = new HashMap<>();

  /** Faults of one class that came about at one place are one kind. */
  private record Kind(Class<?> fault, Optional<StackTraceElement> place) {
    static final Kind OTHERS = new Kind(Throwable.class, Optional.empty());

    static Kind of(Throwable fault) {
      StackTraceElement[] trace = root(fault).getStackTrace();
      return new Kind(
          fault.getClass(),
          Arrays.stream(trace)
              .filter(frame -> frame.getClassName().startsWith(OWN_CODE))
              .findFirst()
              .or(() -> Arrays.stream(trace).findFirst()));
    }

    private static Throwable root(Throwable fault) {
      Throwable root = fault;
      for (int i = 0; i < MAX_CAUSES && root.getCause() != null; i++) {
        root = root.getCause();
      }
      return root;
    }
  }

  /** Writes to the end of {@code file}, which may not be there yet. */
  public FaultFile(Path file) {
    this(file, InstantSource.system());
  }

  FaultFile(Path file, InstantSource clock) {
    this.file = file;
    this.clock = clock;
  }

  /**
   * Adds a fault.
   *
   * @param thread name of the thread that it ended, or would have
   * @return what people should know of it; empty for one of a kind that was told already
   */
  public synchronized Optional<String> add(String thread, Throwable fault) {
    Kind kind = Kind.of(fault);
    Kind counted = counts.containsKey(kind) || counts.size() < MAX_KINDS ? kind : Kind.OTHERS;
    long count = counts.merge(counted, 1L, Long::sum);
    String heading = clock.instant() + " thread " + thread;
    if (count == 1) {
      return Optional.of(
          text("internalError", inWords(fault), written(heading + "\n" + details(fault))));
    }
    if (powerOfTen(count)) {
      var _ = written(heading + ", " + count + " times so far: " + inWords(fault) + "\n");
    }
    return Optional.empty();
  }

  private static boolean powerOfTen(long count) {
    long rest = count;
    while (rest % 10 == 0) {
      rest /= 10;
    }
    return rest == 1;
  }

  private static String inWords(Throwable fault) {
    String text = fault.toString();
    return text.length() > MAX_CHARACTERS ? text.substring(0, MAX_CHARACTERS) + "..." : text;
  }

  private static String details(Throwable fault) {
    StringBuilder details = new StringBuilder();
    Throwable each = fault;
    for (int i = 0; i < MAX_CAUSES && each != null; i++) {
      details.append(inWords(each)).append('\n');
      StackTraceElement[] trace = each.getStackTrace();
      Arrays.stream(trace)
          .limit(MAX_FRAMES)
          .forEach(frame -> details.append("    at ").append(frame).append('\n'));
      if (trace.length > MAX_FRAMES) {
        details.append("    and ").append(trace.length - MAX_FRAMES).append(" more\n");
      }
      each = each.getCause();
    }
    return details.toString();
  }

  private String written(String text) {
    try {
      Files.createDirectories(file.getParent());
      if (Files.exists(file) && Files.size(file) > MAX_BYTES) {
        Files.move(
            file,
            file.resolveSibling("older-" + file.getFileName()),
            StandardCopyOption.REPLACE_EXISTING);
      }
      Files.writeString(file, text, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
      return text("pleaseReportItWith", file);
    } catch (IOException e) {
      return text("cannotBeWritten", file, e.getMessage());
    }
  }
}
