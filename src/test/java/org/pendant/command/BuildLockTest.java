package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The launcher's lock and its AOT caches, in a folder with a JDK and a Maven that only say that
 * they were called.
 */
@DisabledOnOs(OS.WINDOWS)
@Tag("slow")
final class BuildLockTest {
  private static final int PATIENCE_S = 60;

  @TempDir Path folder;

  @BeforeEach
  void aFolderWithNothingBuilt() throws IOException {
    Files.copy(Launcher.home().resolve("pendant"), folder.resolve("pendant"));
    Files.createDirectories(folder.resolve(".build"));
    Files.copy(Launcher.home().resolve(".build/start.sh"), folder.resolve(".build/start.sh"));
    Files.copy(Launcher.home().resolve(".build/options.sh"), folder.resolve(".build/options.sh"));
    Files.createDirectories(folder.resolve("jdk/bin"));
    Files.writeString(folder.resolve("jdk/release"), "JAVA_VERSION=\"25\"\n");
    program("jdk/bin/java", "echo ran");
    Files.createDirectories(folder.resolve("maven"));
    program(
        "maven/mvn",
        "echo built >>builds; mkdir -p gui/desktop/target/lib; touch gui/desktop/target/lib/stamp"
            + " gui/desktop/target/pendant.jar");
    Files.writeString(folder.resolve("pom.xml"), "");
  }

  private void program(String name, String line) throws IOException {
    Path file = Files.writeString(folder.resolve(name), "#!/bin/sh\n" + line + "\n");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwx------"));
  }

  private Path lock() throws IOException {
    return Files.createDirectories(folder.resolve("gui/desktop/target/build.lock"));
  }

  private Process start() throws IOException {
    return start("", "--version");
  }

  private Process start(String display, String word) throws IOException {
    return start(display, word, "");
  }

  private Process start(String display, String word, String options) throws IOException {
    return start(display, List.of(word), options);
  }

  private Process start(String display, List<String> words, String options) throws IOException {
    List<String> command = new ArrayList<>(List.of(folder.resolve("pendant").toString()));
    command.addAll(words);
    ProcessBuilder builder =
        new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true);
    builder.environment().remove("PENDANT_CLASSPATH");
    builder.environment().remove("WAYLAND_DISPLAY");
    builder.environment().put("DISPLAY", display);
    builder.environment().put("PENDANT_JAVA_OPTIONS", options);
    builder.environment().put("PENDANT_JAVA_HOME", folder.resolve("jdk").toString());
    builder.environment().merge("PATH", "", (path, _) -> folder.resolve("maven") + ":" + path);
    return builder.start();
  }

  private void assertBuilds() throws IOException, InterruptedException {
    Process process = start();
    try {
      assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS), "it waits for the lock");
      String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertEquals(0, process.exitValue(), said);
      assertTrue(said.endsWith("ran\n"), said);
      assertTrue(Files.exists(folder.resolve("builds")), said);
      assertFalse(Files.exists(folder.resolve("gui/desktop/target/build.lock")), said);
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void itBuildsAndDropsTheLock() throws Exception {
    assertBuilds();
  }

  @Test
  @DisabledOnOs({OS.WINDOWS, OS.MAC})
  void windowsWhereThereIsADisplayEditorsAndSweepsHaveAotCachesOfTheirOwn() throws Exception {
    // what a JVM is started for is the class behind the class path
    program(
        "jdk/bin/java",
        "for word; do case $word in -XX:AOTCacheOutput=*) echo cache >\"${word#*=}\";;"
            + " org.pendant.*) echo ${word##*.} >>trained;; esac; done; echo ran");
    for (String display : new String[] {":0", ""}) {
      for (String word : new String[] {"open", "check", "lsp", "dap", "sweep", "open"}) {
        Process process = start(display, word);
        assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS));
        assertEquals(0, process.exitValue());
      }
    }
    assertEquals(
        "WindowTraining\nTraining\nEditorTraining\nSweepTraining\n",
        Files.readString(folder.resolve("trained")));
    Path app = folder.resolve("gui/desktop/target/app");
    assertTrue(Files.exists(app.resolve("window-25.aot")));
    assertTrue(Files.exists(app.resolve("pendant-25.aot")));
    assertTrue(Files.exists(app.resolve("editors-25.aot")));
    assertTrue(Files.exists(app.resolve("sweep-25.aot")));
  }

  @Test
  void sweepsAreTrainedWithTheCompilersThatTheyRunWith() throws Exception {
    program("jdk/bin/java", "echo $* >>\"$0.words\"");
    Process process = start("", "sweep");
    assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS));
    List<String> words = Files.readAllLines(folder.resolve("jdk/bin/java.words"));
    for (String end : new String[] {"SweepTraining .*", " sweep"}) {
      String line = words.stream().filter(each -> each.matches(".*" + end)).findFirst().orElse("");
      assertTrue(line.lastIndexOf("TieredStopAtLevel=4") > line.lastIndexOf("=1 "), words + "");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"sweep --engine spark plan.toml", "sweep plan.toml --engine=spark"})
  void sweepsOnSparkAreToldWhichJarWorkersGet(String line) throws Exception {
    program("jdk/bin/java", "echo $PENDANT_SPARK_JAR >>\"$0.jars\"");
    Path jar = folder.resolve("gui/spark/target/pendant-spark.jar");
    Files.createDirectories(jar.getParent());
    Files.createFile(jar);
    Process process = start("", List.of(line.split(" ")), "");
    assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS));
    List<String> told = Files.readAllLines(folder.resolve("jdk/bin/java.jars"));
    assertEquals(jar.toRealPath(), Path.of(told.getLast()).toRealPath());
  }

  @Test
  void aHeapThatTheUserChoosesForALanguageServerIsTheOnlyChoice() throws Exception {
    program("jdk/bin/java", "echo $* >>\"$0.words\"");
    for (String options : new String[] {"", "-Dx=y -Xmx64m"}) {
      Process process = start("", "lsp", options);
      assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS));
      assertEquals(0, process.exitValue());
    }
    List<String> words =
        Files.readAllLines(folder.resolve("jdk/bin/java.words")).stream()
            .filter(line -> line.endsWith(" lsp"))
            .toList();
    assertTrue(words.getFirst().contains(" -Xms80m -Xmn48m "), words.toString());
    assertTrue(words.getLast().contains(" -Dx=y -Xmx64m "), words.toString());
    assertFalse(words.getLast().contains("-Xms"), words.toString());
    assertFalse(words.getLast().contains("-Xmn"), words.toString());
  }

  @Test
  void theBuildUsesTheJdkThatWasFoundWhateverJavaIsOnThePath() throws Exception {
    program("maven/java", "echo older");
    program(
        "maven/mvn",
        "\"$JAVA_HOME/bin/java\" >builds; mkdir -p gui/desktop/target/lib; touch"
            + " gui/desktop/target/lib/stamp gui/desktop/target/pendant.jar");
    assertBuilds();
    assertEquals("ran\n", Files.readString(folder.resolve("builds")));
  }

  @Test
  void aLockWithoutAnOwnerIsTakenOver() throws Exception {
    lock();
    assertBuilds();
  }

  @Test
  void aLockWhoseOwnerFoundTheDiskFullIsTakenOver() throws Exception {
    Files.writeString(lock().resolve("owner"), "");
    assertBuilds();
  }

  @Test
  void aLockWhoseOwnerIsGoneIsTakenOver() throws Exception {
    Process gone = new ProcessBuilder("true").start();
    gone.waitFor();
    Files.writeString(lock().resolve("owner"), gone.pid() + "\n12345\n");
    assertBuilds();
  }

  @Test
  void aLockWhoseOwnersNumberIsAnotherProcessNowIsTakenOver() throws Exception {
    Files.writeString(lock().resolve("owner"), ProcessHandle.current().pid() + "\n12345\n");
    assertBuilds();
  }

  @Test
  void theLockOfALiveOwnerIsWaitedFor() throws Exception {
    program(
        "maven/mvn",
        "read go <"
            + folder.resolve("go")
            + "; mkdir -p gui/desktop/target/lib; touch gui/desktop/target/lib/stamp"
            + " gui/desktop/target/pendant.jar; echo built >>builds");
    assertEquals(
        0, new ProcessBuilder("mkfifo", folder.resolve("go").toString()).start().waitFor());
    Process builder = start();
    Process waiting = null;
    try {
      Path owner = folder.resolve("gui/desktop/target/build.lock/owner");
      builder.inputReader().readLine(); // it says that it builds, and so has the lock
      assertTrue(Files.readString(owner).startsWith(builder.pid() + "\n"));
      waiting = start();
      assertTrue(waiting.inputReader().readLine().contains("waiting for another build"));
      Files.writeString(folder.resolve("go"), "go\n");
      assertTrue(builder.waitFor(PATIENCE_S, TimeUnit.SECONDS));
      assertTrue(waiting.waitFor(PATIENCE_S, TimeUnit.SECONDS));
      assertEquals(0, waiting.exitValue());
      assertEquals("built\n", Files.readString(folder.resolve("builds")), "built once");
    } finally {
      builder.destroyForcibly();
      if (waiting != null) {
        waiting.destroyForcibly();
      }
    }
  }
}
