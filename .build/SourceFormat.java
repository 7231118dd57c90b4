import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.spi.ToolProvider;

/**
 * Source format: checks that every Java source below the working directory is formatted by
 * google-java-format, or formats them. The root pom runs it on the project's JDK with the formatter
 * on the class path.
 *
 * <p>A successful run leaves {@code target/format/stamp}; the next looks only at files changed
 * since, so a build with nothing changed pays for one JVM start.
 */
final class SourceFormat {
  private static final Path STAMP = Path.of("target", "format", "stamp");

  /** There while some source is not formatted; the root pom fails the build on it. */
  private static final Path UNFORMATTED = Path.of("target", "format", "unformatted");

  private SourceFormat() {}

  public static void main(String[] arguments) throws IOException {
    String task = arguments.length == 1 ? arguments[0] : "";
    switch (task) {
      case "check", "fix" -> System.exit(run(task.equals("fix")));
      case "skip" -> {}
      default -> {
        System.err.println("format is \"" + task + "\", must be check, fix or skip");
        System.exit(2);
      }
    }
  }

  private static int run(boolean fix) throws IOException {
    Files.createDirectories(STAMP.getParent());
    Files.deleteIfExists(UNFORMATTED);
    FileTime started = FileTime.fromMillis(System.currentTimeMillis());
    List<String> sources = sourcesChangedSinceStamp();
    if (!sources.isEmpty()) {
      var output = new StringWriter();
      var complaints = new StringWriter();
      int code =
          formatter()
              .run(
                  new PrintWriter(output, true),
                  new PrintWriter(complaints, true),
                  commandLine(fix, sources));
      if (code != 0 && output.toString().isEmpty()) {
        System.err.print(complaints);
        return 1;
      }
      if (code != 0) {
        System.err.println("Not formatted as google-java-format does it:");
        output.toString().lines().forEach(file -> System.err.println("  " + file));
        Files.writeString(UNFORMATTED, output.toString());
        return 0;
      }
    }
    Files.writeString(STAMP, "");
    Files.setLastModifiedTime(STAMP, started);
    return 0;
  }

  private static ToolProvider formatter() {
    return ToolProvider.findFirst("google-java-format").orElseThrow();
  }

  private static String[] commandLine(boolean fix, List<String> sources) {
    var line =
        new ArrayList<>(fix ? List.of("--replace") : List.of("--dry-run", "--set-exit-if-changed"));
    line.addAll(sources);
    return line.toArray(String[]::new);
  }

  private static List<String> sourcesChangedSinceStamp() throws IOException {
    FileTime stamp =
        Files.exists(STAMP) ? Files.getLastModifiedTime(STAMP) : FileTime.fromMillis(0);
    var found = new ArrayList<String>();
    Files.walkFileTree(
        Path.of(""),
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            String name = folder.getFileName().toString();
            boolean ours = !name.startsWith(".") || name.equals(".build");
            return ours && !name.equals("target")
                ? FileVisitResult.CONTINUE
                : FileVisitResult.SKIP_SUBTREE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            if (file.toString().endsWith(".java")
                && attributes.lastModifiedTime().compareTo(stamp) >= 0) {
              found.add(file.toString());
            }
            return FileVisitResult.CONTINUE;
          }
        });
    return found;
  }
}
