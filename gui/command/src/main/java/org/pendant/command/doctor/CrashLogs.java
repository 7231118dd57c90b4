package org.pendant.command.doctor;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.pendant.command.service.StateFolder;

/**
 * Crash logs: files in which a JVM says how it came to its end, such as in the driver of a graphics
 * card. The launcher has them written into the state folder; where the JVM cannot, or was started
 * otherwise, it takes that of temporary files.
 */
final class CrashLogs {
  /** Those after these repeat what they say, or are about something else long ago. */
  static final int MAX_LOGS = 3;

  /** The folder of temporary files may have many of other programs. */
  private static final int MAX_CANDIDATES = 50;

  private static final int MAX_BYTES = 1 << 18;
  private static final int MAX_LINES = 400;
  private static final int MAX_LINE_CHARACTERS = 1_000;
  private static final String COMMAND_LINE = "Command Line: ";
  private static final Pattern COMMAND =
      Pattern.compile("(?:pendant\\.jar|org\\.pendant\\.command\\.\\w+)(?: (\\S+))?( .*)?");

  private CrashLogs() {}

  /** Where those of this user are. */
  static List<Path> folders(Map<String, String> environment) {
    return List.of(StateFolder.of(environment), Path.of(System.getProperty("java.io.tmpdir")));
  }

  /** The newest in {@code folders}, the newest first; folders that are not there have none. */
  static List<Path> newest(List<Path> folders) throws IOException {
    record Log(Path file, FileTime time) {}
    List<Log> logs = new ArrayList<>();
    for (Path folder : folders) {
      if (Files.isDirectory(folder)) {
        try (Stream<Path> files = Files.list(folder)) {
          for (Path file : files.filter(CrashLogs::isOne).toList()) {
            logs.add(new Log(file, Files.getLastModifiedTime(file)));
          }
        }
      }
    }
    logs.sort(Comparator.comparing(Log::time).reversed().thenComparing(Log::file));
    List<Path> newest = new ArrayList<>();
    for (Log each : logs.subList(0, Math.min(logs.size(), MAX_CANDIDATES))) {
      if (newest.size() < MAX_LOGS && isOfPendant(each.file())) {
        newest.add(each.file());
      }
    }
    return newest;
  }

  private static boolean isOfPendant(Path log) throws IOException {
    return lines(log)
        .anyMatch(each -> each.startsWith(COMMAND_LINE) && COMMAND.matcher(each).find());
  }

  private static boolean isOne(Path file) {
    String name = file.getFileName().toString();
    return name.startsWith("hs_err_pid") && name.endsWith(".log") && Files.isReadable(file);
  }

  /**
   * What one says of the fault: the signal, the versions, the thread and its frames. What follows
   * these, the memory around, the environment and all libraries, may tell others too much, as do
   * the words behind the command.
   */
  static String excerpt(Path log) throws IOException {
    StringBuilder text = new StringBuilder();
    lines(log)
        .limit(MAX_LINES)
        .takeWhile(each -> !endsExcerpt(each))
        .map(each -> each.startsWith(COMMAND_LINE) ? commandOnly(each) : each)
        .forEach(
            each ->
                text.append(each, 0, Math.min(each.length(), MAX_LINE_CHARACTERS)).append('\n'));
    return text.toString();
  }

  private static Stream<String> lines(Path log) throws IOException {
    try (InputStream in = Files.newInputStream(log)) {
      // Whatever the bytes are.
      return new String(in.readNBytes(MAX_BYTES), StandardCharsets.ISO_8859_1).lines();
    }
  }

  private static boolean endsExcerpt(String line) {
    return line.startsWith("Registers:")
        || line.startsWith("Top of Stack:")
        || line.contains("P R O C E S S");
  }

  private static String commandOnly(String line) {
    Matcher command = COMMAND.matcher(line);
    if (!command.find()) {
      return COMMAND_LINE + "(left out)";
    }
    return command.group(2) == null ? line : line.substring(0, command.end(1)) + " ...";
  }
}
