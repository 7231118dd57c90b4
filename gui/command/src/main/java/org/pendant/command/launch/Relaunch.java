package org.pendant.command.launch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.command.service.StateFolder;

/**
 * Relaunch: starts the JVM once more with the options of what it is asked for. Launchers that are
 * no shell, those that jpackage makes for macOS and Windows, give it the options of one {@link
 * StartKind} whatever the words are, and name that in a property. What has other options runs in a
 * JVM of its own then, at the same streams, and what the user adds in {@code PENDANT_JAVA_OPTIONS}
 * reaches that.
 */
public final class Relaunch {
  /** Property of launchers with the options of one kind: its word. */
  public static final String STARTED_AS = "pendant.started-as";

  private static final String MAIN = "org.pendant.command.Pendant";

  private final String startedAs;
  private final String system;
  private final Map<String, String> environment;

  Relaunch(String startedAs, String system, Map<String, String> environment) {
    this.startedAs = startedAs;
    this.system = system;
    this.environment = Map.copyOf(environment);
  }

  /**
   * Runs a command line in a JVM of its own, where it has other options than this one, and waits
   * for its end.
   *
   * @param words behind {@code pendant}
   * @return its exit code; empty where this JVM has the options
   * @throws IOException if there is no JVM to start
   */
  public static Optional<Integer> run(List<String> words) throws IOException, InterruptedException {
    Relaunch relaunch =
        new Relaunch(
            System.getProperty(STARTED_AS, ""), System.getProperty("os.name"), System.getenv());
    Optional<List<String>> command =
        relaunch.command(
            words, Path.of(System.getProperty("java.home")), System.getProperty("java.class.path"));
    if (command.isEmpty()) {
      return Optional.empty();
    }
    Process process = new ProcessBuilder(command.get()).inheritIO().start();
    // Who ends this one means that one.
    Runtime.getRuntime().addShutdownHook(new Thread(process::destroy));
    return Optional.of(process.waitFor());
  }

  /** The command of the JVM for {@code words}; empty where this one does. */
  Optional<List<String>> command(List<String> words, Path java, String classPath) {
    List<String> given = given();
    StartKind kind = StartKind.of(words, true, each -> Files.isRegularFile(Path.of(each)));
    // Of a window on macOS this is the one that the Dock and files opened by the Finder know.
    boolean stays = kind.word().equals(startedAs) || (kind == StartKind.WINDOW && isMac());
    if (stays && given.isEmpty()) {
      return Optional.empty();
    }
    List<String> command = new ArrayList<>();
    command.add(java.resolve("bin").resolve("java").toString());
    command.add("-XX:ErrorFile=" + StateFolder.of(environment).resolve("hs_err_pid%p.log"));
    command.addAll(kind.all(given, system));
    command.add("--enable-native-access=ALL-UNNAMED");
    command.add("-cp");
    command.add(classPath);
    command.add(MAIN);
    command.addAll(words);
    return Optional.of(command);
  }

  private boolean isMac() {
    return system.startsWith("Mac");
  }

  private List<String> given() {
    String options = environment.getOrDefault("PENDANT_JAVA_OPTIONS", "").strip();
    return options.isEmpty() ? List.of() : List.of(options.split("\\s+"));
  }
}
