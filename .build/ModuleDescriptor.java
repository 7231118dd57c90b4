import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;

/**
 * Compilation of a module's descriptor, in the module's folder: runs javac with the given
 * arguments, and its own class path for a module path, unless nothing in the folder that is named
 * after {@code -d} has changed since it did so last. A descriptor made anew makes another jar, and
 * for another jar Maven compiles every module above once more.
 */
final class ModuleDescriptor {
  private ModuleDescriptor() {}

  public static void main(String[] arguments) throws IOException {
    Path classes = Path.of(arguments[Arrays.asList(arguments).indexOf("-d") + 1]);
    Path stamp = classes.resolveSibling("module-descriptor");
    List<Path> inputs = List.of(classes, Path.of("src", "main", "java", "module-info.java"));
    if (!Files.exists(stamp) || changedSince(Files.getLastModifiedTime(stamp), inputs)) {
      int code = javac(arguments);
      if (code != 0) {
        System.exit(code);
      }
      Files.writeString(stamp, Arrays.toString(arguments));
    }
  }

  private static int javac(String[] arguments) {
    List<String> all = new ArrayList<>(List.of(arguments));
    all.addAll(List.of("--module-path", System.getProperty("java.class.path")));
    ToolProvider javac = ToolProvider.findFirst("javac").orElseThrow();
    return javac.run(System.out, System.err, all.toArray(new String[0]));
  }

  private static boolean changedSince(FileTime then, List<Path> inputs) throws IOException {
    for (Path each : inputs) {
      try (Stream<Path> files = Files.walk(each)) {
        for (Path file : files.filter(Files::isRegularFile).toList()) {
          if (Files.getLastModifiedTime(file).compareTo(then) > 0) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
